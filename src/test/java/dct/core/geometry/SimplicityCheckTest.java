package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.geometry.Defect.Kind;
import dct.testing.ExactArea;
import dct.testing.ForeignDataTest;
import dct.testing.RandomPolygons;
import dct.testing.SharedData;
import dct.testing.SimplicityOracle;
import dct.testing.Transforms;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The sweep against a look at every pair of edges; and what it says of the defect is true.
 *
 * <pre>
 * Points bowTie = Points.ofPairs(0, 0, 4, 4, 4, 0, 0, 4);
 * Optional&lt;Defect&gt; found = SimplicityCheck.firstDefect(bowTie, Progress.NONE);
 * Defect defect = found.orElseThrow();
 * defect.kind(); // Kind.CROSSING
 * defect.x(); // 2.0
 * </pre>
 */
class SimplicityCheckTest {

  /** On the smallest grids nearly every chain is broken, in every way that there is. */
  @ParameterizedTest
  @CsvSource({"2, 6", "3, 4", "3, 7", "4, 5", "4, 9", "6, 8", "10, 12", "30, 25", "1000, 6"})
  void agreesWithEveryPairOnRandomChains(int range, int n) {
    for (int seed = 0; seed < 4_000; seed++) {
      Random random = new Random(seed);
      double[] pairs = random.ints(2L * n, 0, range).asDoubleStream().toArray();
      check(Points.ofPairs(pairs), "range %d, n %d, seed %d".formatted(range, n, seed));
    }
  }

  /** One vertex of a simple polygon goes elsewhere: mostly a single defect, far from the rest. */
  @Test
  void agreesWithEveryPairOnSpoiltPolygons() {
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      for (int seed = 0; seed < 150; seed++) {
        Random random = new Random(seed);
        Points p = family.make(5 + seed % 30, seed);
        int from = random.nextInt(p.size());
        int to = random.nextInt(p.size());
        int toNext = (to + 1) % p.size();
        double t = random.nextInt(5) / 4.0;
        double x = p.x(to) + t * (p.x(toNext) - p.x(to));
        double y = p.y(to) + t * (p.y(toNext) - p.y(to));
        check(p.moved(from, x, y), "%s, seed %d".formatted(family, seed));
      }
    }
  }

  @Test
  void agreesOneUlpFromATouch() {
    for (int seed = 0; seed < 4_000; seed++) {
      Random random = new Random(seed);
      Points p = RandomPolygons.starShaped(4 + seed % 20, random);
      int from = random.nextInt(p.size());
      int to = random.nextInt(p.size());
      int toNext = (to + 1) % p.size();
      double t = random.nextDouble();
      double x = Math.nextUp(p.x(to) + t * (p.x(toNext) - p.x(to)));
      check(p.moved(from, x, p.y(to) + t * (p.y(toNext) - p.y(to))), "seed " + seed);
    }
  }

  private static void check(Points p, String what) {
    Optional<Defect> found = SimplicityCheck.firstDefect(p, Progress.NONE);
    assertThat(found.isEmpty()).as("simple, %s", what).isEqualTo(SimplicityOracle.isSimple(p));
    found.ifPresent(defect -> checkDefect(p, defect, what));
  }

  /** The vertices and edges named do what the kind says, and the place is there. */
  private static void checkDefect(Points p, Defect d, String what) {
    SimplicityOracle oracle = new SimplicityOracle(p);
    int i = d.first();
    int j = d.second();
    boolean isTrue =
        switch (d.kind()) {
          case TOO_FEW -> p.size() < 3;
          case COLLINEAR -> isCollinear(p);
          case DUPLICATE -> i != j && p.same(i, j) && isAt(p, i, d);
          case SPIKE -> oracle.turnsBack(i) && isAt(p, i, d);
          case TOUCH -> oracle.liesInside(i, j) && isAt(p, i, d);
          case CROSSING -> oracle.edgesCross(i, j);
          case OVERLAP -> oracle.edgesOverlap(i, j);
          default -> false; // not of polygons
        };
    assertThat(isTrue).as("%s, %s", d, what).isTrue();
    if (d.kind() == Kind.CROSSING) {
      checkPlace(p, d, what);
    }
    assertThat(d.count()).isEqualTo(p.size());
    assertThat(d.message()).isNotBlank();
  }

  private static boolean isAt(Points p, int v, Defect d) {
    return p.x(v) == d.x() && p.y(v) == d.y();
  }

  private static boolean isCollinear(Points p) {
    for (int i = 0; i < p.size(); i++) {
      for (int j = i + 1; j < p.size(); j++) {
        for (int k = j + 1; k < p.size(); k++) {
          if (p.orient(i, j, k) != 0) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /** The crossing point, found along the other edge. */
  private static void checkPlace(Points p, Defect d, String what) {
    int i = d.first();
    int j = d.second();
    int ii = (i + 1) % p.size();
    int jj = (j + 1) % p.size();
    BigDecimal ux = minus(p.x(ii), p.x(i));
    BigDecimal uy = minus(p.y(ii), p.y(i));
    BigDecimal vx = minus(p.x(jj), p.x(j));
    BigDecimal vy = minus(p.y(jj), p.y(j));
    // The point lies on the second edge where its side of the first edge is level.
    BigDecimal here =
        ux.multiply(minus(p.y(j), p.y(i))).subtract(uy.multiply(minus(p.x(j), p.x(i))));
    BigDecimal there =
        ux.multiply(minus(p.y(jj), p.y(i))).subtract(uy.multiply(minus(p.x(jj), p.x(i))));
    BigDecimal whole = here.subtract(there);
    checkCoordinate(d.x(), p.x(j), vx, here, whole, "x of " + d + ", " + what);
    checkCoordinate(d.y(), p.y(j), vy, here, whole, "y of " + d + ", " + what);
  }

  /** Against from + step · part / whole, to the last digit but one. */
  private static void checkCoordinate(
      double actual, double from, BigDecimal step, BigDecimal part, BigDecimal whole, String what) {
    BigDecimal sum = new BigDecimal(from).multiply(whole).add(step.multiply(part));
    double expected = sum.divide(whole, MathContext.DECIMAL128).doubleValue();
    assertThat(actual).as(what).isCloseTo(expected, within(2 * Math.ulp(expected)));
  }

  private static BigDecimal minus(double a, double b) {
    return new BigDecimal(a).subtract(new BigDecimal(b));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0x1p-1040, 0x1p-700, 0x1p-400, 1, 0x1p400, 0x1p700, 0x1p1000})
  void namesTheCrossingAtEveryScale(double factor) {
    Points bowTie = Transforms.scaled(Points.ofPairs(0, 0, 8, 8, 8, 0, 0, 8), factor);
    Defect d = SimplicityCheck.firstDefect(bowTie, Progress.NONE).orElseThrow();
    assertThat(d).isEqualTo(new Defect(Kind.CROSSING, 0, 2, 4 * factor, 4 * factor, 4));
  }

  @Test
  void namesACrossingOfTheLongestEdges() {
    double most = Double.MAX_VALUE;
    check(Points.ofPairs(-most, -most, most, most, most, -most, -most, most), "as large as can be");
  }

  @Test
  void namesEachKind() {
    assertThat(kind()).isEqualTo(Kind.TOO_FEW);
    assertThat(kind(0, 0)).isEqualTo(Kind.TOO_FEW);
    assertThat(kind(0, 0, 1, 1)).isEqualTo(Kind.TOO_FEW);
    assertThat(kind(0, 0, 1, 1, 3, 3, 2, 2)).isEqualTo(Kind.COLLINEAR);
    assertThat(kind(0, 0, 4, 0, 4, 0, 0, 4)).isEqualTo(Kind.DUPLICATE);
    assertThat(kind(0, 0, 4, 0, 8, 0, 6, 0, 6, 5)).isEqualTo(Kind.SPIKE);
    assertThat(kind(0, 0, 8, 0, 8, 8, 4, 0, 0, 8)).isEqualTo(Kind.TOUCH);
    assertThat(kind(0, 0, 8, 8, 8, 0, 0, 8)).isEqualTo(Kind.CROSSING);
    assertThat(kind(0, 0, 8, 0, 8, 4, 6, 0, 2, 0, 0, 4)).isIn(Kind.OVERLAP, Kind.TOUCH);
  }

  private static Kind kind(double... pairs) {
    return SimplicityCheck.firstDefect(Points.ofPairs(pairs), Progress.NONE).orElseThrow().kind();
  }

  @Test
  void messagesNameTheEdgesAsThePersonCountsThem() {
    Points bowTie = Points.ofPairs(0, 0, 8, 8, 8, 0, 0, 8);
    assertThat(SimplicityCheck.firstDefect(bowTie, Progress.NONE).orElseThrow().message())
        .isEqualTo("edges v0–v1 and v2–v3 cross at (4, 4); move a vertex of one of them");
    Points last = Transforms.startingAt(bowTie, 1);
    assertThat(SimplicityCheck.firstDefect(last, Progress.NONE).orElseThrow().message())
        .contains("edges v1–v2 and v3–v0 cross");
  }

  @Test
  void thePlaceOfACrossingIsRoundedToWhatAPersonReads() {
    Points bowTie = Points.ofPairs(0, 0, 100, 101, 100, 0, 0, 99);
    assertThat(SimplicityCheck.firstDefect(bowTie, Progress.NONE).orElseThrow().message())
        .isEqualTo("edges v0–v1 and v2–v3 cross at (49.5, 49.995); move a vertex of one of them");
    Points skew = Points.ofPairs(0, 0, 300, 301, 299, 0, 7, 200);
    assertThat(SimplicityCheck.firstDefect(skew, Progress.NONE).orElseThrow().message())
        .containsPattern("cross at \\(\\d{3}\\.\\d{1,6}, \\d{3}\\.\\d{1,6}\\);");
  }

  @Test
  void aPolygonRefusesADefectAndCarriesIt() {
    Points bowTie = Points.ofPairs(0, 0, 8, 8, 8, 0, 0, 8);
    assertThatThrownBy(() -> SimplePolygon.of(bowTie, Progress.NONE))
        .isInstanceOfSatisfying(
            InvalidGeometryException.class,
            e -> assertThat(e.defect().kind()).isEqualTo(Kind.CROSSING));
  }

  @ForeignDataTest
  void refusesEverySharedFileThatIsNotSimple() {
    for (Path file : SharedData.files("not_simple")) {
      Points p = SharedData.read(file);
      assertThat(SimplicityCheck.firstDefect(p, Progress.NONE))
          .as("%s", file.getFileName())
          .isPresent();
      check(p, file.getFileName().toString());
    }
  }

  @ForeignDataTest
  void acceptsEverySharedPolygonAndNamesOneSpoiltEdge() {
    for (Path file : SharedData.files("polygons")) {
      Points p = SharedData.read(file);
      assertThat(SimplicityCheck.firstDefect(p, Progress.NONE))
          .as("%s", file.getFileName())
          .isEmpty();
      if (p.size() > 3) {
        Points spoilt = p.moved(1, p.x(2), p.y(2)).moved(2, p.x(1), p.y(1));
        check(spoilt, file.getFileName() + " with v1 and v2 changed");
      }
    }
  }

  @Test
  void findsTheOneCrossingFarAwayInALargePolygon() {
    int n = 100_000;
    double[] pairs = new double[2 * n];
    for (int i = 0; i < n / 2; i++) { // a zigzag there, and its shadow back
      pairs[2 * i] = i;
      pairs[2 * i + 1] = i % 2;
      pairs[2 * (n - 1 - i)] = i;
      pairs[2 * (n - 1 - i) + 1] = i % 2 + 3;
    }
    Points comb = Points.ofPairs(pairs);
    assertThat(SimplicityCheck.firstDefect(comb, Progress.NONE)).isEmpty();
    Points spoilt = comb.moved(77_777, comb.x(77_777), -0.5);
    checkDefect(
        spoilt,
        SimplicityCheck.firstDefect(spoilt, Progress.NONE).orElseThrow(),
        "one tooth too long");
  }

  @Test
  void tellsTheOrientationAndWalksCounterClockwise() {
    for (RandomPolygons.Family family : RandomPolygons.families()) {
      for (int seed = 0; seed < 40; seed++) {
        Points p = family.make(4 + seed, seed);
        SimplePolygon polygon = SimplePolygon.of(p, Progress.NONE);
        SimplePolygon reversed = SimplePolygon.of(Transforms.reversed(p), Progress.NONE);
        assertThat(polygon.isClockwise()).isEqualTo(!reversed.isClockwise());
        int[] walk = polygon.walk();
        assertThat(walk[0]).isZero();
        assertThat(new ExactArea(p).ofRing(walk).signum()).isEqualTo(1);
      }
    }
  }
}
