package dct.core.degree.bound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.degree.LowerBound;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Against all triangulations of convex polygons: every triangulation of a simple polygon is, but
 * for the coordinates, one of these.
 */
class PolygonBoundsTest {

  /** The sets of odd vertices of all triangulations of the part i … j, its edge i j included. */
  private static Set<Integer> oddSets(int i, int j) {
    Set<Integer> sets = new HashSet<>();
    int closing = 1 << i | 1 << j;
    if (j == i + 1) {
      sets.add(closing);
    }
    for (int k = i + 1; k < j; k++) {
      Set<Integer> second = oddSets(k, j);
      for (int left : oddSets(i, k)) {
        second.forEach(right -> sets.add(left ^ right ^ closing));
      }
    }
    return sets;
  }

  private static int least(Set<Integer> oddSets, ParityGoal goal) {
    int least = goal.size();
    for (int set : oddSets) {
      int missed = 0;
      for (int v = 0; v < goal.size(); v++) {
        missed += goal.wish(v).isGrantedBy(set >> v & 1) ? 0 : 1;
      }
      least = Math.min(least, missed);
    }
    return least;
  }

  private static ParityGoal goal(int n, int code) {
    Wish[] wishes = new Wish[n];
    int rest = code;
    for (int v = 0; v < n; v++) {
      wishes[v] = rest % 3 == 0 ? Wish.EVEN : rest % 3 == 1 ? Wish.ODD : Wish.ANY;
      rest = Math.floorDiv(rest, 3);
    }
    return ParityGoal.of(wishes);
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 6, 7, 8})
  void noGoalHasALessOptimum(int n) {
    Set<Integer> oddSets = oddSets(0, n - 1);
    for (int code = 0; code < Math.pow(3, n); code++) {
      ParityGoal goal = goal(n, code);
      assertThat(PolygonBounds.of(n, goal).value())
          .as("goal %d of %d vertices", code, n)
          .isLessThanOrEqualTo(least(oddSets, goal));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 6, 7, 8, 9, 10})
  void convexPolygonsAttainItForAllEvenAndAllOdd(int n) {
    Set<Integer> oddSets = oddSets(0, n - 1);
    ParityGoal even = ParityGoal.allEven(n);
    ParityGoal odd = ParityGoal.allOdd(n);
    assertThat(PolygonBounds.of(n, even).value()).isEqualTo(least(oddSets, even));
    assertThat(PolygonBounds.of(n, odd).value()).isEqualTo(least(oddSets, odd));
  }

  @Test
  void theReasonNamesTheBoundaryCount() {
    assertThat(PolygonBounds.of(12, ParityGoal.allEven(12)))
        .isEqualTo(new LowerBound(0, "12 vertices, 12 ≡ 0 mod 3"));
    assertThat(PolygonBounds.of(13, ParityGoal.allEven(13)))
        .isEqualTo(new LowerBound(2, "13 vertices, 3 does not divide 13"));
  }

  @Test
  void oneVertexWishedOddCannotBeAlone() {
    Wish[] wishes = new Wish[9];
    Arrays.fill(wishes, Wish.EVEN);
    wishes[4] = Wish.ODD;
    assertThat(PolygonBounds.of(9, ParityGoal.of(wishes)).value()).isEqualTo(1);
  }

  @Test
  void wishesMustBeAsManyAsVertices() {
    assertThatThrownBy(() -> PolygonBounds.of(5, ParityGoal.allEven(6)))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
