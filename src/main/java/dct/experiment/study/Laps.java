package dct.experiment.study;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;

/** Takes the time of the steps of one trial. */
final class Laps {
  private final Map<String, Double> millis = new LinkedHashMap<>();

  /** Does a step and keeps its time. */
  <T> T time(String step, Supplier<T> work) {
    long start = System.nanoTime();
    T result = work.get();
    millis.put(step, (System.nanoTime() - start) / 1e6);
    return result;
  }

  /** The times, by step. */
  Map<String, Double> millis() {
    return millis;
  }
}
