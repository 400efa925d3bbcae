package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.experiment.generate.PolygonShape;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Rings that meet themselves, taken apart at each place or moved a hair apart. */
class TouchingTest {
  /** Two triangles that share their tip, run through as one ring. */
  private static final Points TIPS =
      Points.ofPairs(0, 0, 200, 0, 100, 100, 200, 200, 0, 200, 100, 100);

  /** A square with a square hole, tied to it by an edge that is gone to and fro. */
  private static final Points TIED =
      Points.ofPairs(
          0, 0, 300, 0, 300, 300, 0, 300, 0, 0, 100, 100, 100, 200, 200, 200, 200, 100, 100, 100);

  private static Optional<Defect> defect(Points points) {
    return SimplicityCheck.firstDefect(points, Progress.NONE);
  }

  private static List<List<Integer>> rings(Points points) {
    return Touching.rings(points, Progress.NONE).stream()
        .map(ring -> java.util.Arrays.stream(ring).boxed().toList())
        .toList();
  }

  private static double area(Points points) {
    double sum = 0;
    for (int v = 0; v < points.size(); v++) {
      int w = (v + 1) % points.size();
      sum += points.x(v) * points.y(w) - points.x(w) * points.y(v);
    }
    return sum / 2;
  }

  @Test
  void aSharedTipPartsTwoRings() {
    assertThat(rings(TIPS)).containsExactly(List.of(2, 3, 4), List.of(0, 1, 5));
  }

  @Test
  void aTiedHoleIsARingOfItsOwnAndTheTieIsLeftOut() {
    assertThat(rings(TIED)).containsExactly(List.of(0, 1, 2, 3), List.of(5, 6, 7, 8));
  }

  @Test
  void aSimpleRingStaysWhatItIs() {
    Points square = Points.ofPairs(0, 0, 1, 0, 1, 1, 0, 1);
    assertThat(rings(square)).containsExactly(List.of(0, 1, 2, 3));
    assertThat(Touching.parted(square, Progress.NONE)).contains(square);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void whatMeetsItselfIsSimpleAHairApart(boolean turned) {
    for (Points ring : List.of(TIPS, TIED)) {
      Points run = turned ? reversed(ring) : ring;
      Points parted = Touching.parted(run, Progress.NONE).orElseThrow();
      assertThat(defect(parted)).isEmpty();
      requireNear(parted, run);
    }
  }

  private static Points reversed(Points ring) {
    List<double[]> all = new ArrayList<>();
    for (int v = 0; v < ring.size(); v++) {
      all.add(new double[] {ring.x(v), ring.y(v)});
    }
    Collections.reverse(all);
    return Points.of(
        all.stream().mapToDouble(p -> p[0]).toArray(),
        all.stream().mapToDouble(p -> p[1]).toArray());
  }

  /** Every vertex stays within 10⁻⁸, and so does the area, in relation. */
  private static void requireNear(Points parted, Points ring) {
    assertThat(parted.size()).isEqualTo(ring.size());
    for (int v = 0; v < ring.size(); v++) {
      assertThat(parted.x(v)).isCloseTo(ring.x(v), within(1e-8 * 300));
      assertThat(parted.y(v)).isCloseTo(ring.y(v), within(1e-8 * 300));
    }
    assertThat(area(parted)).isCloseTo(area(ring), within(1e-6 * Math.abs(area(ring))));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9})
  void itDoesNotMatterWhereTheRingBegins(int first) {
    Points ring = begunAt(TIED, first);
    assertThat(Touching.rings(ring, Progress.NONE)).hasSize(2);
    Points parted = Touching.parted(ring, Progress.NONE).orElseThrow();
    assertThat(defect(parted)).isEmpty();
    assertThat(parted)
        .isEqualTo(begunAt(Touching.parted(TIED, Progress.NONE).orElseThrow(), first));
  }

  private static Points begunAt(Points ring, int first) {
    int n = ring.size();
    return Points.of(
        IntStream.range(0, n).mapToDouble(v -> ring.x((v + first) % n)).toArray(),
        IntStream.range(0, n).mapToDouble(v -> ring.y((v + first) % n)).toArray());
  }

  @Test
  void aVertexOnAnEdgeIsMovedOffIt() {
    Points ring = Points.ofPairs(0, 0, 200, 0, 200, 200, 100, 0, 0, 200);
    Points parted = Touching.parted(ring, Progress.NONE).orElseThrow();
    assertThat(defect(parted)).isEmpty();
    requireNear(parted, ring);
  }

  @Test
  void edgesThatCrossCannotBeParted() {
    assertThat(Touching.parted(Points.ofPairs(0, 0, 9, 9, 9, 0, 0, 9), Progress.NONE)).isEmpty();
  }

  /** A simple polygon and its copies further on, tied together at random vertices. */
  @ParameterizedTest
  @CsvSource({"1", "2", "3", "4", "5", "6", "7", "8"})
  void randomRingsAtRandomVerticesArePartedAndFallApart(long seed) {
    Random random = new Random(seed);
    int n = 5 + random.nextInt(60);
    Points first = PolygonShape.TWO_OPT.generate(n, seed).points();
    Points second = PolygonShape.TWO_OPT.generate(n + 3, seed + 99).points();
    int right = extreme(first, 1);
    int left = extreme(second, -1);
    double dx = first.x(right) - second.x(left);
    double dy = first.y(right) - second.y(left);
    List<double[]> both = new ArrayList<>();
    for (int v = 0; v < n; v++) {
      int at = (right + v) % n;
      both.add(new double[] {first.x(at), first.y(at)});
    }
    for (int v = 0; v < second.size(); v++) {
      int at = (left + v) % second.size();
      double x = v == 0 ? first.x(right) : second.x(at) + dx;
      double y = v == 0 ? first.y(right) : second.y(at) + dy;
      both.add(new double[] {x, y});
    }
    Points ring =
        Points.of(
            both.stream().mapToDouble(p -> p[0]).toArray(),
            both.stream().mapToDouble(p -> p[1]).toArray());
    assertThat(defect(ring).orElseThrow().kind()).isEqualTo(Defect.Kind.DUPLICATE);
    assertThat(rings(ring)).hasSize(2);
    Points parted = Touching.parted(ring, Progress.NONE).orElseThrow();
    assertThat(defect(parted)).isEmpty();
  }

  private static int extreme(Points points, int sign) {
    int best = 0;
    for (int v = 1; v < points.size(); v++) {
      best = sign * points.x(v) > sign * points.x(best) ? v : best;
    }
    return best;
  }
}
