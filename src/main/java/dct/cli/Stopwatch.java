package dct.cli;

/** Measures one step after the other. */
final class Stopwatch {
  private long since = System.nanoTime();

  /** The milliseconds since the last lap, or since the start. */
  double lap() {
    long now = System.nanoTime();
    double millis = (now - since) / 1e6;
    since = now;
    return millis;
  }
}
