package dct.testing;

import static dct.testing.TriangulationAssert.assertThat;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

/** The assertion itself must be able to fail: every break of a right triangulation is named. */
class MeshCheckTest {
  // A square with a straight vertex 1 below and a dent 4 above; right: 0 1 4, 1 2 3, 1 3 4.
  private static final Points PENTAGON = Points.ofPairs(0, 0, 2, 0, 4, 0, 4, 3, 2, 2);
  private static final Points WITH_INNER = Points.ofPairs(0, 0, 2, 0, 4, 0, 4, 4, 0, 4, 1, 2);

  @Test
  void acceptsARightTriangulationOfAPolygon() {
    assertThat(MeshCheck.ofPolygon(pentagon(), PENTAGON)).isEmpty();
  }

  @Test
  void acceptsARightTriangulationOfSites() {
    assertThat(MeshCheck.ofSites(sites(), WITH_INNER)).isEmpty();
  }

  @Test
  void namesForeignPoints() {
    refusesPentagon(m -> m.points = PENTAGON.moved(0, 1, 1), "points are not those given");
  }

  @Test
  void namesAMissingTriangle() {
    refusesPentagon(m -> m.triangles = Arrays.copyOf(m.triangles, 6), "V − E + F");
  }

  @Test
  void namesAMissingTriangleWithItsDiagonal() {
    refusesPentagon(
        m -> {
          m.triangles = Arrays.copyOf(m.triangles, 6);
          dropLastEdge(m);
        },
        "2 triangles, not 3");
  }

  @Test
  void namesAMissingDiagonal() {
    refusesPentagon(MeshCheckTest::dropLastEdge, "V − E + F");
  }

  @Test
  void namesARepeatedEdge() {
    refusesPentagon(
        m -> {
          m.from[6] = 4;
          m.to[6] = 1;
        },
        "edge v1–v4 twice");
  }

  @Test
  void namesALoop() {
    refusesPentagon(m -> m.from[6] = m.to[6], "loop v3–v3");
  }

  @Test
  void namesABoundaryEdgeOfTheWrongKind() {
    refusesPentagon(m -> m.kinds[0] = EdgeKind.DIAGONAL, "the boundary: v0–v1 expected");
  }

  @Test
  void namesADiagonalOfTheWrongKind() {
    refusesPentagon(m -> m.kinds[6] = EdgeKind.BOUNDARY, "the boundary: v2–v3 expected");
  }

  @Test
  void namesAWrongDegree() {
    refusesPentagon(m -> m.degrees[3]++, "degree of v3 is 3");
  }

  @Test
  void namesAClockwiseTriangle() {
    refusesPentagon(m -> swap(m.triangles, 0, 1), "is not counter-clockwise");
  }

  @Test
  void namesATriangleWithoutArea() {
    refusesPentagon(m -> setTriangle(m, 0, 0, 1, 2), "triangle v0 v1 v2 is not counter");
  }

  @Test
  void namesATriangleThatReachesOutside() {
    refusesPentagon(m -> setTriangle(m, 1, 0, 2, 3), "areas");
  }

  @Test
  void namesTrianglesThatDoNotMatchTheEdges() {
    refusesPentagon(
        m -> {
          m.from[6] = 2;
          m.to[6] = 4;
          m.degrees = new int[] {2, 3, 3, 2, 4};
        },
        "the sides of the triangles");
  }

  @Test
  void namesOverlappingTrianglesOfTheRightArea() {
    // 0 1 4 has the area of 1 2 4: twice the one, none of the other.
    Points square = Points.ofPairs(0, 0, 2, 0, 4, 0, 2, 3);
    Mesh m = new Mesh();
    m.points = square;
    m.from = new int[] {0, 1, 2, 3, 1};
    m.to = new int[] {1, 2, 3, 0, 3};
    m.kinds = new EdgeKind[5];
    Arrays.fill(m.kinds, EdgeKind.BOUNDARY);
    m.kinds[4] = EdgeKind.DIAGONAL;
    m.degrees = new int[] {2, 3, 2, 3};
    m.triangles = new int[] {0, 1, 3, 0, 1, 3};
    assertThat(MeshCheck.ofPolygon(m, square)).hasValueSatisfying(p -> has(p, "the sides"));
  }

  @Test
  void namesASiteLeftOut() {
    Mesh m = sites();
    m.triangles = new int[] {0, 1, 4, 1, 2, 3, 1, 3, 4, 1, 3, 4, 1, 3, 4};
    assertThat(MeshCheck.ofSites(m, WITH_INNER)).hasValueSatisfying(p -> has(p, "areas"));
  }

  @Test
  void namesAHullEdgeThatSkipsASite() {
    Mesh m = sites();
    m.to[0] = 2;
    assertThat(MeshCheck.ofSites(m, WITH_INNER))
        .hasValueSatisfying(p -> has(p, "the boundary: v0–v1 expected, v0–v2 found"));
  }

  @Test
  void acceptsThePathOfSitesOnALineAndNothingElse() {
    Points line = Points.ofPairs(3, 3, 0, 0, 1, 1);
    Mesh m = new Mesh();
    m.points = line;
    m.from = new int[] {1, 2};
    m.to = new int[] {2, 0};
    m.kinds = new EdgeKind[] {EdgeKind.BOUNDARY, EdgeKind.BOUNDARY};
    m.degrees = new int[] {1, 1, 2};
    m.triangles = new int[0];
    assertThat(MeshCheck.ofSites(m, line)).isEmpty();
    m.to[1] = 1;
    assertThat(MeshCheck.ofSites(m, line)).hasValueSatisfying(p -> has(p, "the path"));
  }

  @Test
  void assertionCarriesTheProblemAndTheDescription() {
    Points reflex = Points.ofPairs(0, 0, 4, 0, 1, 1, 0, 4);
    Dcel dcel = Dcel.cycle(0, 1, 2, 3);
    dcel.splitFace(2, 6); // 1–3 lies outside
    Triangulation wrong = new Triangulation(Domain.SITES, reflex, dcel, edge -> EdgeKind.DIAGONAL);
    assertThatThrownBy(
            () -> assertThat(wrong).as("seed 7").isTriangulationOf(Sites.of(reflex, Progress.NONE)))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("seed 7")
        .hasMessageContaining("2 triangles, not 3");
  }

  @Test
  void namesASiteInsideACircle() {
    Points kite = Points.ofPairs(0, 0, 1, -1, 4, 0, 1, 1);
    assertThatThrownBy(() -> assertThat(split(kite, 0, 4)).isDelaunay())
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("lies inside the circle of");
    assertThat(split(kite, 2, 6)).isDelaunay();
  }

  @Test
  void acceptsBothDiagonalsOfCocircularSites() {
    Points square = Points.ofPairs(0, 0, 1, 0, 1, 1, 0, 1);
    assertThat(split(square, 0, 4)).isDelaunay();
    assertThat(split(square, 2, 6)).isDelaunay();
  }

  @Test
  void namesAKindThatIsNotAllowed() {
    Points square = Points.ofPairs(0, 0, 1, 0, 1, 1, 0, 1);
    Triangulation t = split(square, 0, 4);
    assertThat(t).hasInnerEdgesOnlyOf(EdgeKind.DIAGONAL);
    assertThatThrownBy(() -> assertThat(t).hasInnerEdgesOnlyOf(EdgeKind.FLIPPED))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("is of kind DIAGONAL");
  }

  private static Triangulation split(Points quadrilateral, int a, int b) {
    Dcel dcel = Dcel.cycle(0, 1, 2, 3);
    dcel.splitFace(a, b);
    return new Triangulation(Domain.SITES, quadrilateral, dcel, edge -> EdgeKind.DIAGONAL);
  }

  private static void refusesPentagon(Consumer<Mesh> harm, String problem) {
    Mesh mesh = pentagon();
    harm.accept(mesh);
    assertThat(MeshCheck.ofPolygon(mesh, PENTAGON)).hasValueSatisfying(p -> has(p, problem));
  }

  private static void has(String problem, String part) {
    assertThat(problem).contains(part);
  }

  private static Mesh pentagon() {
    Mesh m = new Mesh();
    m.points = PENTAGON;
    m.from = new int[] {0, 1, 2, 3, 4, 1, 1};
    m.to = new int[] {1, 2, 3, 4, 0, 4, 3};
    m.kinds = kinds(5, 7);
    m.degrees = new int[] {2, 4, 2, 3, 3};
    m.triangles = new int[] {0, 1, 4, 1, 2, 3, 1, 3, 4};
    return m;
  }

  private static Mesh sites() {
    Mesh m = new Mesh();
    m.points = WITH_INNER;
    m.from = new int[] {0, 1, 2, 3, 4, 5, 5, 5, 5, 1};
    m.to = new int[] {1, 2, 3, 4, 0, 0, 1, 3, 4, 3};
    m.kinds = kinds(5, 10);
    m.degrees = new int[] {3, 4, 2, 4, 3, 4};
    m.triangles = new int[] {0, 1, 5, 1, 2, 3, 1, 3, 5, 5, 3, 4, 0, 5, 4};
    return m;
  }

  private static EdgeKind[] kinds(int boundary, int edges) {
    EdgeKind[] kinds = new EdgeKind[edges];
    Arrays.fill(kinds, EdgeKind.DIAGONAL);
    Arrays.fill(kinds, 0, boundary, EdgeKind.BOUNDARY);
    return kinds;
  }

  private static void dropLastEdge(Mesh m) {
    m.from = Arrays.copyOf(m.from, m.from.length - 1);
    m.to = Arrays.copyOf(m.to, m.to.length - 1);
    m.kinds = Arrays.copyOf(m.kinds, m.kinds.length - 1);
  }

  private static void setTriangle(Mesh m, int number, int a, int b, int c) {
    m.triangles[3 * number] = a;
    m.triangles[3 * number + 1] = b;
    m.triangles[3 * number + 2] = c;
  }

  private static void swap(int[] array, int i, int j) {
    int kept = array[i];
    array[i] = array[j];
    array[j] = kept;
  }
}
