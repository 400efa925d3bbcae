package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import dct.core.degree.bound.SmallSets;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Bounds that a result file states, recomputed from the file alone. */
class VerifyBoundTest {
  private static final String SITES = "# kind: points\n";
  private static final String TRIANGLE_AND_CENTRE = SITES + "0 0\n9 0\n4 8\n4 3\n";
  private static final String FIVE_ON_A_LINE = "0 0\n1 0\n2 0\n3 0\n4 0\n1 3\n";

  private static JsonObject result(String points, int bound, String reason) {
    String text = CliRun.withInput(points, "triangulate", "-", "-o", "-").done().out();
    JsonObject result = JsonParser.parseString(text).getAsJsonObject();
    result.addProperty("oddLowerBound", bound);
    result.addProperty("optimal", result.get("odd").getAsInt() == bound);
    result.addProperty("boundReason", reason);
    return result;
  }

  private static String verified(JsonObject result) {
    return CliRun.withInput(result.toString(), "verify", "-").done().out();
  }

  private static String fault(JsonObject result) {
    CliRun run = CliRun.withInput(result.toString(), "verify", "-");
    assertThat(run.status()).isEqualTo(4);
    return run.err();
  }

  @Test
  void aBoundOfSitesIsRecomputed() {
    assertThat(verified(result(TRIANGLE_AND_CENTRE, 4, "three hull sites")))
        .contains("4 odd; the lower bound: 4 was recomputed (degree sum)");
  }

  @Test
  void theBoundaryCountIsRecomputed() {
    assertThat(verified(result(SITES + "0 0\n9 0\n9 8\n1 7\n", 2, "4 hull sites")))
        .contains("the lower bound: 2 was recomputed (4 hull sites, 3 does not divide 4)");
  }

  @Test
  void theExactOptimumOfAPolygonIsRecomputed() {
    assertThat(verified(result(FIVE_ON_A_LINE, 4, "exact table")))
        .contains("the lower bound: 4 was recomputed (exact table");
  }

  @Test
  void anOptimizedResultNeedNotBeDelaunay() {
    JsonObject result = result(TRIANGLE_AND_CENTRE, 4, "three hull sites");
    result.addProperty("post", "optimize");
    assertThat(verified(result)).contains("the lower bound: 4 was recomputed");
  }

  @Test
  void aBoundThatIsLessThanWhatCanBeProvenIsTrue() {
    assertThat(verified(result(TRIANGLE_AND_CENTRE, 2, "three hull sites")))
        .contains("the lower bound: 2 was recomputed, and more: 4 (degree sum)");
  }

  @Test
  void aBoundAboveTheOptimumIsALie() {
    String hexagon = "0 0\n5 -2\n9 1\n10 6\n4 9\n-1 5\n";
    String flatHexagon = "0 0\n20 -5\n40 1\n39 10\n20 15\n1 10\n";
    for (String points : new String[] {hexagon, SITES + flatHexagon}) {
      JsonObject lie = result(points, 2, "hull walk");
      assertThat(lie.get("odd").getAsInt()).isPositive();
      assertThat(fault(lie)).contains("\"oddLowerBound\" says 2, but the optimum is 0");
    }
  }

  @Test
  void aBoundAboveTheResultIsALie() {
    assertThat(fault(result(TRIANGLE_AND_CENTRE, 6, "hull walk")))
        .contains("\"oddLowerBound\" says 6, but 4 odd vertices are here");
  }

  @Test
  void aBoundBelowTheBoundaryCountIsALie() {
    assertThat(fault(result(SITES + "0 0\n9 0\n9 8\n1 7\n", 0, "none")))
        .contains("\"oddLowerBound\" says 0, but it is 2 at least");
  }

  @Test
  void anInventedBoundOfManySitesIsALie() {
    Random random = new Random(4);
    StringBuilder sites = new StringBuilder(SITES);
    for (int i = 0; i < 60; i++) {
      sites.append(random.nextInt(10_000)).append(' ').append(random.nextInt(10_000)).append('\n');
    }
    assertThat(fault(result(sites.toString(), 4, "a longer search")))
        .containsPattern("\"oddLowerBound\" says 4, but the optimum is [02] \\(\\d+ hull sites");
  }

  private static String sitesOnSides(int onSide) {
    double[] pairs = SmallSets.sidesOfTriangle(onSide);
    StringBuilder sites = new StringBuilder(SITES);
    for (int i = 0; i < pairs.length; i += 2) {
      sites.append(pairs[i]).append(' ').append(pairs[i + 1]).append('\n');
    }
    return sites.toString();
  }

  /** 275 sites of which nothing is proven, by too many triangles to refute sets of odd ones. */
  @Test
  void whatCannotBeRecomputedIsSaid() {
    CliRun run =
        CliRun.withInput(result(sitesOnSides(90), 4, "a longer search").toString(), "verify", "-");
    assertThat(run.status()).as(run.out() + run.err()).isEqualTo(5);
    assertThat(run.out()).containsPattern("the lower bound: 4 was not recomputed, only [02] ");
  }

  /** 35 sites whose best triangulation has four odd ones: only the refutation of sets proves it. */
  @Test
  void aRefutationIsRecomputed() {
    CliRun run =
        CliRun.withInput(result(sitesOnSides(10), 4, "a longer search").toString(), "verify", "-");
    assertThat(run.status()).as(run.out() + run.err()).isZero();
    assertThat(run.out())
        .contains("4 was recomputed (refuted: 596 sets of at most 2 odd vertices)");
  }

  private static JsonObject crossWithWindows(String windows) {
    StringBuilder points = new StringBuilder(SITES);
    double[] pairs = SmallSets.cross(10, 10);
    for (int i = 0; i < pairs.length; i += 2) {
      points.append(pairs[i]).append(' ').append(pairs[i + 1]).append('\n');
    }
    JsonObject result = result(points.toString(), 4, "windows that cannot be all even");
    result.add("certificate", JsonParser.parseString("{\"windows\": " + windows + "}"));
    return result;
  }

  @Test
  void theWindowsOfACertificateAreProvenAgain() {
    String odd = "[1, 3, 5, 7, 9, 11, 13, 15, 17, 19]";
    String other = "[21, 23, 25, 27, 29, 31, 33, 35, 37, 39]";
    String even = "[20, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40]";
    String form =
        "[{\"unmet\": 1, \"sites\": %s}, {\"unmet\": 1, \"sites\": %s},"
            + " {\"unmet\": 1, \"sites\": %s}]";
    assertThat(verified(crossWithWindows(form.formatted(odd, other, even))))
        .contains("4 was recomputed (windows that cannot be all even)");
    assertThat(verified(crossWithWindows(form.formatted(odd, other, odd))))
        .contains("4 was recomputed (refuted: 821 sets of at most 2 odd vertices)");
  }

  @Test
  void aCertificateWithSitesThatThereAreNotIsFalse() {
    assertThat(fault(crossWithWindows("[{\"unmet\": 1, \"sites\": [41]}]")))
        .contains("a window of the certificate has no site 41");
    assertThat(fault(crossWithWindows("[{\"unmet\": 2, \"sites\": [4]}]")))
        .contains("a window of the certificate is said to have 2 unmet sites");
  }

  @Test
  void aCertificateOfAnotherFormIsRefusedWithItsPlace() {
    CliRun run = CliRun.withInput(crossWithWindows("[[4]]").toString(), "verify", "-");
    assertThat(run.status()).isEqualTo(3);
    assertThat(run.err()).contains("-:1: the certificate is not of the known form");
  }
}
