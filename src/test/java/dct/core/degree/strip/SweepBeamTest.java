package dct.core.degree.strip;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Deadline;
import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.exact.ExactSites;
import dct.core.degree.region.MeshExport;
import dct.core.degree.region.SearchMesh;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.testing.TriangulationAssert;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SweepBeamTest {
  private static final int WIDE = 100_000; // no state of a dozen sites is ever left out
  private static final int ALL = 1000; // edges or layers: to the hull

  private final Progress clock = Progress.NONE;

  /** Sites on whole coordinates below a side: the smaller it is, the more lie on common lines. */
  private static Triangulation delaunay(int n, int side, Random random) {
    double[] pairs = new double[2 * n];
    for (int i = 0; i < pairs.length; i++) {
      pairs[i] = random.nextInt(side);
    }
    return Delaunay.triangulate(Sites.of(Points.ofPairs(pairs), Progress.NONE), Progress.NONE);
  }

  private static ParityGoal goal(int n, Random random) {
    List<Wish> all = List.of(Wish.EVEN, Wish.ODD, Wish.ANY);
    Wish[] wishes = new Wish[n];
    Arrays.setAll(wishes, v -> all.get(random.nextInt(all.size())));
    return switch (random.nextInt(3)) {
      case 0 -> ParityGoal.allEven(n);
      case 1 -> ParityGoal.allOdd(n);
      default -> ParityGoal.of(wishes);
    };
  }

  /** The whole set as one strip, solved anew by a beam of this width. */
  private Triangulation solved(
      Triangulation start, ParityGoal goal, int turn, int width, int seed) {
    SearchMesh mesh = new SearchMesh(start, goal, 1, clock);
    Strip strip = new Strip(mesh);
    SeededRandom random = new SeededRandom(seed);
    int v = random.nextInt(mesh.size());
    strip.cut(v, new Strip.Shape(turn, ALL, ALL, ALL, ALL), random);
    assertThat(strip.triangleCount()).as("seed %d", seed).isEqualTo(start.triangleCount());
    SweepBeam beam = new SweepBeam(strip, width, random);
    int[] moves = beam.search(mesh.size(), clock);
    assertThat(moves).as("seed %d", seed).isNotEmpty();
    strip.fill(moves);
    assertThat(mesh.unmet()).as("seed %d", seed).isEqualTo(beam.unmet());
    return MeshExport.triangulation(mesh, start);
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 6, 1000})
  void a_wide_beam_is_exact(int side) {
    for (int seed = 0; seed < 40; seed++) {
      Random random = new Random(seed);
      Triangulation start = delaunay(5 + random.nextInt(7), side, random);
      if (start.triangleCount() > 0) {
        ParityGoal goal = goal(start.vertexCount(), random);
        Triangulation best = solved(start, goal, random.nextInt(4), WIDE, seed);
        TriangulationAssert.assertThat(best)
            .isTriangulationOf(Sites.of(start.points(), Progress.NONE));
        assertThat(goal.unmet(best))
            .as("side %d, seed %d", side, seed)
            .isEqualTo(ExactSites.optimize(start, goal, Progress.NONE).unmet());
      }
    }
  }

  @Test
  void strips_of_any_shape_are_filled_with_as_many_triangles_and_no_more_unsatisfied_vertices() {
    Random random = new Random(3);
    Triangulation start = delaunay(300, 25, random);
    ParityGoal goal = ParityGoal.allEven(start.vertexCount());
    SearchMesh mesh = new SearchMesh(start, goal, 1, clock);
    Strip strip = new Strip(mesh);
    for (int seed = 0; seed < 300; seed++) {
      int before = mesh.unmet();
      SeededRandom choices = new SeededRandom(seed);
      int[] sizes = IntStream.range(0, 4).map(i -> choices.nextInt(9)).toArray();
      Strip.Shape shape = new Strip.Shape(seed % 4, sizes[0], sizes[1], sizes[2], sizes[3]);
      strip.cut(choices.nextInt(mesh.size()), shape, choices);
      SweepBeam beam = new SweepBeam(strip, 30, choices);
      int[] moves = beam.search(strip.unmet(), clock);
      if (moves.length > 0) {
        strip.fill(moves);
      }
      int gain = moves.length > 0 ? strip.unmet() - beam.unmet() : 0;
      assertThat(gain).as("seed %d", seed).isNotNegative();
      assertThat(mesh.unmet()).as("seed %d", seed).isEqualTo(before - gain);
    }
    assertThat(mesh.unmet()).isLessThan(goal.unmet(start));
    TriangulationAssert.assertThat(MeshExport.triangulation(mesh, start))
        .isTriangulationOf(Sites.of(start.points(), Progress.NONE));
  }

  @Test
  void a_search_that_the_clock_ends_finds_nothing() {
    SearchMesh mesh =
        new SearchMesh(delaunay(50, 1000, new Random(1)), ParityGoal.allEven(50), 1, clock);
    Strip strip = new Strip(mesh);
    SeededRandom random = new SeededRandom(1);
    strip.cut(0, new Strip.Shape(0, ALL, ALL, ALL, ALL), random);
    Progress struck = new Deadline(Progress.NONE, 0);
    assertThat(new SweepBeam(strip, 10, random).search(50, struck)).isEmpty();
  }
}
