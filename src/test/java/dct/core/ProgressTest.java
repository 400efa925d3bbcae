package dct.core;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.MonotonePartition;
import dct.core.triangulate.MonotoneTriangulation;
import dct.testing.RandomPolygons;
import dct.testing.RandomSets;
import java.util.List;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every long computation says where it is, and stops when it is asked to. */
class ProgressTest {
  private static final int MANY = 100_000;

  /** A long computation and its name. */
  record Computation(String name, Consumer<Progress> run) {
    @Override
    public String toString() {
      return name;
    }
  }

  static List<Computation> computations() {
    SimplePolygon comb = SimplePolygon.of(RandomPolygons.comb(MANY, new Random(1)), Progress.NONE);
    Sites sites = RandomSets.families().get(0).make(MANY, 1);
    return List.of(
        new Computation("ear clipping", p -> EarClipping.triangulate(comb, p)),
        new Computation("monotone partition", p -> MonotonePartition.partition(comb, p)),
        new Computation("monotone", p -> MonotoneTriangulation.triangulate(comb, p)),
        new Computation("convex-even", p -> PartitioningAqt.triangulate(comb, p)),
        new Computation("convex-odd", p -> OddFan.triangulate(comb, p)),
        new Computation("delaunay", p -> Delaunay.triangulate(sites, p)));
  }

  @ParameterizedTest
  @MethodSource("computations")
  void reportsFractionsAndSaysWhatItDoes(Computation computation) {
    Recorder recorder = new Recorder(Integer.MAX_VALUE);
    computation.run.accept(recorder);
    assertThat(recorder.fractions).hasSizeGreaterThan(3).allMatch(f -> f >= 0 && f <= 1);
    assertThat(recorder.messages).allMatch(message -> !message.isBlank());
  }

  @ParameterizedTest
  @MethodSource("computations")
  void stopsWhenCancelled(Computation computation) {
    for (int allowed : new int[] {0, 1, 3}) {
      Recorder recorder = new Recorder(allowed);
      assertThatThrownBy(() -> computation.run.accept(recorder))
          .as("after %d reports", allowed)
          .isInstanceOf(CancellationException.class);
    }
  }

  /** Cancels after a number of reports; is called from several threads. */
  private static final class Recorder implements Progress {
    final Queue<Double> fractions = new ConcurrentLinkedQueue<>();
    final Queue<String> messages = new ConcurrentLinkedQueue<>();
    private final int allowed;

    Recorder(int allowed) {
      this.allowed = allowed;
    }

    @Override
    public void report(double fraction, String message) {
      fractions.add(fraction);
      messages.add(message);
    }

    @Override
    public boolean isCancelled() {
      return fractions.size() >= allowed;
    }
  }
}
