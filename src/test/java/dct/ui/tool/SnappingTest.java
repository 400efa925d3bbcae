package dct.ui.tool;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.geometry.Points;
import dct.core.geometry.SegmentPoints.Place;
import dct.core.triangulate.Domain;
import dct.render.Viewport;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What the place of a vertex snaps to. */
class SnappingTest {
  private final FakeContext polygon =
      new FakeContext(Domain.POLYGON, 100.25, 100, 300, 100.75, 300, 300, 100.25, 300);

  private Target target(Spot spot) {
    return Snapping.of(polygon, spot, Optional.empty(), v -> false);
  }

  private Target from(double x, double y, Spot spot) {
    return Snapping.of(polygon, spot, Optional.of(new Place(x, y)), v -> false);
  }

  @Test
  void nothingSnapsUnlessItIsOn() {
    assertThat(target(polygon.spot(101, 101))).isEqualTo(new Target(101, 101, ""));
  }

  @Test
  void aVertexWithinReachIsMetExactly() {
    polygon.snap.toggle(Snap.To.VERTICES);
    assertThat(target(polygon.spot(104, 97))).isEqualTo(new Target(100.25, 100, "on v0"));
    assertThat(target(polygon.spot(120, 97)).hit()).isEmpty();
  }

  @Test
  void whatIsOnItsWayIsNotMet() {
    polygon.snap.toggle(Snap.To.VERTICES);
    polygon.snap.toggle(Snap.To.EDGES);
    Target target = Snapping.of(polygon, polygon.spot(104, 97), Optional.empty(), v -> v == 0);
    assertThat(target).isEqualTo(new Target(104, 97, ""));
  }

  @Test
  void anEdgeWithinReachIsMetExactly() {
    polygon.snap.toggle(Snap.To.EDGES);
    Target target = target(polygon.spot(200, 104));
    assertThat(target.hit()).isEqualTo("on v0–v1");
    Points with = polygon.points().inserted(1, target.x(), target.y());
    assertThat(with.orient(0, 2, 1)).isZero();
    assertThat(target(polygon.spot(200, 130)).hit()).isEmpty();
  }

  @Test
  void theGridIsMetExactlyAndAVertexComesFirst() {
    polygon.snap.toggle(Snap.To.GRID);
    polygon.snap.setGrid(0.1);
    polygon.viewport = Viewport.IDENTITY.zoomed(100, 0, 0);
    Target target = target(polygon.spot(31, 72));
    assertThat(target).isEqualTo(new Target(0.3, 0.7, "on the grid"));
    polygon.viewport = Viewport.IDENTITY;
    polygon.snap.setGrid(20);
    assertThat(target(polygon.spot(109, 91))).isEqualTo(new Target(100, 100, "on the grid"));
    polygon.snap.toggle(Snap.To.VERTICES);
    assertThat(target(polygon.spot(102, 99)).hit()).isEqualTo("on v0");
  }

  @ParameterizedTest
  @CsvSource({"80, 7, 80, 0.125", "5, -60, 0.5, -60", "-70, 20, -70, 0.125"})
  void withShiftOneCoordinateStays(double x, double y, double toX, double toY) {
    Target target = from(0.5, 0.125, polygon.spot(x, y).withShift(true));
    assertThat(target.x()).isEqualTo(toX);
    assertThat(target.y()).isEqualTo(toY);
  }

  @Test
  void anglesAreMultiplesFromTheVertexBefore() {
    polygon.snap.toggle(Snap.To.ANGLES);
    polygon.snap.setAngle(30);
    Target target = from(0, 0, polygon.spot(100, 50));
    assertThat(Math.toDegrees(Math.atan2(target.y(), target.x()))).isCloseTo(30, within(1e-3));
    polygon.snap.setAngle(45);
    target = from(10, 10, polygon.spot(60, 52));
    assertThat(target.x() - 10).isEqualTo(target.y() - 10);
  }

  @Test
  void inALevelDirectionTheOtherCoordinateIsThatOfAVertex() {
    polygon.snap.toggle(Snap.To.VERTICES);
    Target target = from(500, 200.5, polygon.spot(103, 205).withShift(true));
    assertThat(target.x()).isEqualTo(100.25);
    assertThat(target.y()).isEqualTo(200.5);
  }

  @ParameterizedTest
  @CsvSource({"200, 298, false", "203, 301, true"})
  void anUprightDirectionAndAnEdgeAreMetWhereTheyCross(double x, double y, boolean shift) {
    polygon.snap.toggle(Snap.To.EDGES);
    if (!shift) {
      polygon.snap.toggle(Snap.To.ANGLES);
    }
    Target target = from(200.7, 150, polygon.spot(x, y).withShift(shift));
    assertThat(target).isEqualTo(new Target(200.7, 300, "on v2–v3 in a direction of 90°"));
  }

  @Test
  void aSlantingDirectionMeetsAnEdgeExactlyOnIt() {
    polygon.snap.toggle(Snap.To.EDGES);
    polygon.snap.toggle(Snap.To.ANGLES);
    polygon.snap.setAngle(30);
    Target target = from(150, 200, polygon.spot(207, 104));
    assertThat(target.hit()).isEqualTo("on v0–v1 in a direction of 60°");
    Points with = polygon.points().inserted(1, target.x(), target.y());
    assertThat(with.orient(0, 2, 1)).isZero();
    double slope = (target.y() - 200) / (target.x() - 150);
    assertThat(slope).isCloseTo(-Math.sqrt(3), within(1e-2));
    assertThat(from(150, 200, polygon.spot(190, 130)).hit()).isEqualTo("in a direction of 60°");
  }

  @Test
  void whatLiesBehindOrIsOnItsWayIsNotCrossed() {
    polygon.snap.toggle(Snap.To.EDGES);
    polygon.snap.toggle(Snap.To.ANGLES);
    Spot spot = polygon.spot(200, 303);
    assertThat(from(200, 302, spot).hit()).isEqualTo("in a direction of 90°");
    assertThat(Snapping.of(polygon, spot, Optional.of(new Place(200, 150)), v -> v == 3).hit())
        .isEqualTo("in a direction of 90°");
  }

  @Test
  void aSlantingDirectionMeetsALineOfTheGrid() {
    polygon.snap.toggle(Snap.To.GRID);
    polygon.snap.toggle(Snap.To.ANGLES);
    polygon.snap.setAngle(45);
    assertThat(from(20, 40, polygon.spot(127, 152)))
        .isEqualTo(new Target(120, 140, "on the grid in a direction of 45°"));
    polygon.snap.setAngle(60);
    Target steep = from(20, 40, polygon.spot(80, 152));
    assertThat(steep.y()).isEqualTo(140);
    assertThat(steep.x()).isCloseTo(20 + 100 / Math.sqrt(3), within(1e-3));
  }

  @Test
  void twoEdgesAreMetWhereTheyCross() {
    FakeContext bowTie = new FakeContext(Domain.POLYGON, 0, 0, 300, 300, 300, 0, 0, 300);
    bowTie.snap.toggle(Snap.To.EDGES);
    Target target = Snapping.of(bowTie, bowTie.spot(155, 147), Optional.empty(), v -> false);
    assertThat(target).isEqualTo(new Target(150, 150, "on the crossing of v0–v1 and v2–v3"));
    target = Snapping.of(bowTie, bowTie.spot(155, 147), Optional.empty(), v -> v == 3);
    assertThat(target.hit()).isEqualTo("on v0–v1");
    target = Snapping.of(bowTie, bowTie.spot(200, 202), Optional.empty(), v -> false);
    assertThat(target.hit()).isEqualTo("on v0–v1");
  }

  @Test
  void drawingSnaps() {
    polygon.snap.toggle(Snap.To.GRID);
    new DrawTool().pressed(polygon, polygon.spot(48, 207));
    assertThat(polygon.points().x(4)).isEqualTo(40);
    assertThat(polygon.points().y(4)).isEqualTo(200);
    new DrawTool().pressed(polygon, polygon.spot(233, 221).withShift(true));
    assertThat(polygon.points().x(5)).isEqualTo(240);
    assertThat(polygon.points().y(5)).isEqualTo(200);
  }

  @Test
  void theStatusLineSaysWhatIsOn() {
    assertThat(polygon.snap.words()).isEmpty();
    polygon.snap.toggle(Snap.To.ANGLES);
    polygon.snap.toggle(Snap.To.GRID);
    polygon.snap.toggle(Snap.To.VERTICES);
    assertThat(polygon.snap.words()).isEqualTo("Snap: vertices, grid 20, angles 15°");
    polygon.snap.toggle(Snap.To.GRID);
    assertThat(polygon.snap.words()).isEqualTo("Snap: vertices, angles 15°");
  }
}
