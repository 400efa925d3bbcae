package dct.core.degree.region;

import static dct.testing.TriangulationAssert.assertThat;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.ParityGoal;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.SiteShape;
import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class MeshRegionTest {

  private static final int WEIGHT = 1 << 16;

  /** A region of ten vertices round one of sixty sites, filled anew: never more are unmet. */
  @Test
  void an_example() {
    SearchMesh mesh = mesh(delaunay(SiteShape.UNIFORM, 60, 1));
    MeshRegion region = region(mesh, Progress.NONE, 10);
    int before = mesh.unmet();
    region.open(mesh.out[30]);
    region.grow(10, 3);
    int change = region.fill(4);
    assertThat(change).isLessThanOrEqualTo(0);
    assertThat(mesh.unmet()).isEqualTo(before + change);
  }

  private static Triangulation delaunay(SiteShape shape, int n, long seed) {
    return Delaunay.triangulate(Sites.of(shape.generate(n, seed), Progress.NONE), Progress.NONE);
  }

  private static SearchMesh mesh(Triangulation start) {
    return new SearchMesh(start, ParityGoal.allEven(start.vertexCount()), WEIGHT, Progress.NONE);
  }

  private static MeshRegion region(SearchMesh mesh, Progress progress, int most) {
    return new MeshRegion(mesh, new SeededRandom(3), progress, most, 0, mesh.size());
  }

  /** Small regions and large ones, so that both kinds of table fill them. */
  @Test
  void never_makes_more_vertices_unmet() {
    for (SiteShape shape : SiteShape.values()) {
      Triangulation start = delaunay(shape, 300, 5);
      SearchMesh mesh = mesh(start);
      solveEverywhere(mesh);
      assertThat(MeshExport.triangulation(mesh, start))
          .isTriangulationOf(Sites.of(start.points(), Progress.NONE));
    }
    for (PolygonShape shape : PolygonShape.values()) {
      SimplePolygon polygon = shape.generate(300, 5);
      Triangulation start = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
      SearchMesh mesh = mesh(start);
      solveEverywhere(mesh);
      assertThat(MeshExport.triangulation(mesh, start)).isTriangulationOf(polygon);
    }
  }

  private static void solveEverywhere(SearchMesh mesh) {
    SeededRandom random = new SeededRandom(8);
    MeshRegion region = region(mesh, Progress.NONE, 120);
    int unmet = mesh.unmet();
    for (int step = 0; step < 60; step++) {
      int v = random.nextInt(mesh.size());
      assertThat(region.open(mesh.halfEdgeAt(v, random))).isTrue();
      region.grow(step % 3 == 0 ? 120 : 12, 20);
      int change = region.fill(4);
      unmet += change;
      assertThat(change).isLessThanOrEqualTo(0);
      assertThat(mesh.unmet()).isEqualTo(unmet);
    }
  }

  @Test
  void takes_only_the_vertices_of_its_part() {
    SearchMesh mesh = mesh(delaunay(SiteShape.UNIFORM, 200, 2));
    MeshRegion region = new MeshRegion(mesh, new SeededRandom(1), Progress.NONE, 40, 50, 100);
    for (int e = 0; e < mesh.corner.length; e += 4) {
      if (region.open(e)) {
        region.grow(40, 3);
        assertThat(IntStream.range(0, region.size()).map(region::vertex))
            .allMatch(v -> v >= 50 && v < 100)
            .doesNotHaveDuplicates();
        region.fill(4);
      }
    }
  }

  @Test
  void a_cancel_leaves_the_triangles_as_they_were() {
    SimplePolygon polygon = PolygonShape.TWO_OPT.generate(500, 1);
    Triangulation start = MonotoneTriangulation.triangulate(polygon, Progress.NONE);
    SearchMesh mesh = mesh(start);
    int before = mesh.unmet();
    Progress cancelled =
        new Progress() {
          @Override
          public void report(double fraction, String message) {}

          @Override
          public boolean isCancelled() {
            return true;
          }
        };
    MeshRegion region = region(mesh, cancelled, 200);
    region.open(0);
    region.grow(200, 20);
    assertThat(region.size()).isGreaterThan(RegionTable.MOST);
    assertThatThrownBy(() -> region.fill(4)).isInstanceOf(CancellationException.class);
    assertThat(mesh.unmet()).isEqualTo(before);
    assertThat(MeshExport.triangulation(mesh, start)).isTriangulationOf(polygon);
  }
}
