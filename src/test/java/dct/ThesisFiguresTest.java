package dct;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Partition;
import dct.core.triangulate.Triangulation;
import dct.io.PointFile;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** Each sample that stands for a figure of the thesis shows what the figure shows. */
class ThesisFiguresTest {

  @Test
  void figure31AdmitsAnEvenDegreeTriangulation() {
    SimplePolygon polygon = polygon("figure_3_01_even_degree");

    Triangulation even = PartitioningAqt.triangulate(polygon, Progress.NONE);

    assertThat(DegreeCount.of(even)).isEqualTo(new DegreeCount(polygon.size(), 0));
    assertThat(even.count(EdgeKind.PARTITION)).as("it is not convex").isPositive();
  }

  @Test
  void figure32HasOneTriangulationAndTwoOddVertices() {
    SimplePolygon polygon = polygon("figure_3_02_no_even_degree");

    Triangulation only = MonotoneTriangulation.triangulate(polygon, Progress.NONE);

    assertThat(edges(EarClipping.triangulate(polygon, Progress.NONE))).isEqualTo(edges(only));
    assertThat(flippableDiagonals(only)).as("no flip leads to another one").isZero();
    assertThat(DegreeCount.of(only).odd()).isEqualTo(2);
  }

  @Test
  void figure35HasThreeEarDiagonals() {
    Triangulation triangulation =
        MonotoneTriangulation.triangulate(polygon("figure_3_05_ear_diagonals"), Progress.NONE);
    int n = triangulation.vertexCount();
    int ears = 0;
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      int gap = Math.abs(triangulation.from(edge) - triangulation.to(edge));
      ears += gap == 2 || gap == n - 2 ? 1 : 0;
    }
    assertThat(ears).isEqualTo(3);
  }

  @Test
  void figure38FlipsExactlyTheTwoDiagonalsOfTheText() {
    int[][] diagonals = {
      // the text of Section 3.2.1 names these
      {0, 2}, {0, 3}, {0, 4}, {4, 23}, {5, 23}, {5, 21}, {5, 12}, {5, 11}, {5, 7},
      // these complete it
      {21, 23}, {12, 21}, {7, 11}, {7, 10}, {8, 10}, {12, 19}, {19, 21}, {13, 19}, {13, 17},
      {17, 19}, {13, 16}, {13, 15}
    };
    Triangulation before = triangulation(polygon("figure_3_08_scan_flip"), diagonals);

    FlipResult result = ScanFlip.run(before, Progress.NONE);

    Set<String> gone = edges(before);
    gone.removeAll(edges(result.after()));
    Set<String> made = edges(result.after());
    made.removeAll(edges(before));
    assertThat(gone).containsExactlyInAnyOrder("0-2", "5-21");
    assertThat(made).containsExactlyInAnyOrder("1-3", "12-23");
    assertThat(result.flips()).isEqualTo(2);
  }

  @Test
  void figure39Has36EvenVerticesAnd40AfterOneFlip() {
    SimplePolygon polygon = polygon("figure_3_09_convex_pieces");
    Partition pieces =
        HertelMehlhorn.partition(
            polygon, MonotoneTriangulation.triangulate(polygon, Progress.NONE), Progress.NONE);

    FlipResult result =
        ScanFlip.run(PartitioningAqt.triangulate(polygon, Progress.NONE), Progress.NONE);

    assertThat(polygon.size()).isEqualTo(44);
    assertThat(pieces.pieces()).isEqualTo(4);
    assertThat(DegreeCount.of(result.before()).even()).isEqualTo(36);
    assertThat(DegreeCount.of(result.after()).even()).isEqualTo(40);
    assertThat(result.flips()).isEqualTo(1);
  }

  @Test
  void figure311GainsLittleFromConvexPieces() {
    SimplePolygon polygon = polygon("figure_3_11_reflex_chains");

    Triangulation triangulation = PartitioningAqt.triangulate(polygon, Progress.NONE);

    assertThat(triangulation.count(EdgeKind.PARTITION)).isGreaterThan(polygon.size() / 2);
    assertThat(DegreeCount.of(triangulation).even()).isLessThanOrEqualTo(polygon.size() / 2);
  }

  @Test
  void figure312Has5EvenSitesAnd11AfterScanFlip() {
    Sites sites = Sites.of(points("figure_3_12_sites_pointbased"), Progress.NONE);
    Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);

    FlipResult result = ScanFlip.run(delaunay, Progress.NONE);

    assertThat(sites.size()).isEqualTo(17);
    assertThat(delaunay.edgeCount()).isEqualTo(38);
    assertThat(delaunay.count(EdgeKind.BOUNDARY)).isEqualTo(10);
    assertThat(DegreeCount.of(delaunay).even()).isEqualTo(5);
    assertThat(DegreeCount.of(result.after()).even()).isEqualTo(11);
  }

  private static SimplePolygon polygon(String name) {
    return SimplePolygon.of(points(name + "_polygonbased"), Progress.NONE);
  }

  private static Points points(String name) {
    return PointFile.read(Path.of("samples", name + ".txt"), Progress.NONE).points();
  }

  /** The triangulation of a polygon by these diagonals. */
  private static Triangulation triangulation(SimplePolygon polygon, int[][] diagonals) {
    Dcel dcel = Dcel.cycle(polygon.walk());
    for (int[] diagonal : diagonals) {
      split(dcel, diagonal[0], diagonal[1]);
    }
    return new Triangulation(Domain.POLYGON, polygon.points(), dcel, edge -> EdgeKind.DIAGONAL);
  }

  private static void split(Dcel dcel, int u, int v) {
    for (int a = 0; a < 2 * dcel.edgeBound(); a++) {
      for (int b = 0; b < 2 * dcel.edgeBound(); b++) {
        if (dcel.origin(a) == u && dcel.origin(b) == v && dcel.canSplit(a, b)) {
          dcel.splitFace(a, b);
          return;
        }
      }
    }
    throw new AssertionError("no face has both v" + u + " and v" + v);
  }

  private static Set<String> edges(Triangulation triangulation) {
    Set<String> edges = new HashSet<>();
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      int u = triangulation.from(edge);
      int v = triangulation.to(edge);
      edges.add(Math.min(u, v) + "-" + Math.max(u, v));
    }
    return edges;
  }

  private static int flippableDiagonals(Triangulation triangulation) {
    Dcel dcel = triangulation.dcel();
    int flippable = 0;
    for (int e = 0; e < 2 * triangulation.edgeCount(); e += 2) {
      if (dcel.canFlip(e)) {
        int c = dcel.origin(dcel.prev(e));
        int d = dcel.origin(dcel.prev(e ^ 1));
        Points points = triangulation.points();
        boolean convex =
            points.orient(d, c, dcel.origin(e)) > 0 && points.orient(d, c, dcel.target(e)) < 0;
        flippable += convex ? 1 : 0;
      }
    }
    return flippable;
  }
}
