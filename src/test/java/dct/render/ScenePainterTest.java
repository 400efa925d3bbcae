package dct.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.groups.Tuple.tuple;

import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Box;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.render.RecordingPen.Shape;
import java.util.List;
import org.junit.jupiter.api.Test;

class ScenePainterTest {
  private static final Box SCREEN = new Box(0, 0, 1000, 700);

  @Test
  void edgesHaveTheColourOfTheirKind() {
    RecordingPen pen = painted(Scene.of(Fixtures.pentagon()));
    assertThat(pen.count("line", Ink.BOUNDARY)).isEqualTo(5);
    assertThat(pen.count("line", Ink.DIAGONAL)).isEqualTo(1);
    assertThat(pen.count("line", Ink.PARTITION)).isEqualTo(1);
    assertThat(pen.count("line", Ink.FLIPPED)).isZero();
  }

  @Test
  void theInsideOfAPolygonIsFilledFirst() {
    for (Scene scene :
        List.of(
            Scene.of(Fixtures.pentagon()),
            Scene.outline(Rings.ofChain(Fixtures.PENTAGON), true, List.of()),
            Scene.outline(Rings.ofChain(Fixtures.PENTAGON), false, List.of()))) {
      Shape first = painted(scene).shapes.get(0);
      assertThat(first.kind()).isEqualTo("polygon");
      assertThat(first.ink()).isEqualTo(Ink.INSIDE);
      assertThat(first.text())
          .isEqualTo("[100.0, 300.0, 400.0, 300.0, 100.0] [100.0, 100.0, 200.0, 300.0, 300.0]");
    }
    assertThat(painted(Scene.sites(Fixtures.PENTAGON)).count("polygon", Ink.INSIDE)).isZero();
  }

  @Test
  void evenVerticesAreRedDiscsAndOddOnesBlueSquares() {
    // Degrees of v0 … v4: 3, 2, 4, 2, 3.
    RecordingPen pen = painted(Scene.of(Fixtures.pentagon()));
    assertThat(pen.shapes)
        .filteredOn(s -> s.kind().equals("disc"))
        .extracting(Shape::ink, Shape::x, Shape::y)
        .containsExactlyInAnyOrder(
            tuple(Ink.EVEN, 300.0, 100.0),
            tuple(Ink.EVEN, 400.0, 200.0),
            tuple(Ink.EVEN, 300.0, 300.0));
    assertThat(pen.shapes)
        .filteredOn(s -> s.kind().equals("square"))
        .extracting(Shape::ink, Shape::x, Shape::y)
        .containsExactlyInAnyOrder(tuple(Ink.ODD, 100.0, 100.0), tuple(Ink.ODD, 100.0, 300.0));
  }

  @Test
  void countsStandInTheUpperRightCorner() {
    RecordingPen pen = painted(Scene.of(Fixtures.pentagon()));
    assertThat(pen.texts()).containsExactly("Even 3 · Odd 2");
    Shape text = pen.shapes.get(pen.shapes.size() - 1);
    assertThat(text.x()).isBetween(950.0, 1000.0);
    assertThat(text.y()).isBetween(0.0, 50.0);
  }

  @Test
  void afterFlipsTheCountsBeforeAreThereToo() {
    RecordingPen pen = painted(Scene.of(Fixtures.flippedPentagon()));
    assertThat(pen.texts()).containsExactly("Before: Even 3 · Odd 2", "After: Even 3 · Odd 2");
    assertThat(pen.count("line", Ink.FLIPPED)).isEqualTo(1);
    assertThat(pen.count("line", Ink.DIAGONAL)).isZero();
  }

  @Test
  void theFlippedEdgeIsDrawnWhereItIs() {
    RecordingPen pen = painted(Scene.of(Fixtures.flippedPentagon()));
    assertThat(pen.shapes)
        .filteredOn(s -> s.ink() == Ink.FLIPPED)
        .extracting(s -> ends(s))
        .containsAnyOf("300.0 100.0 100.0 300.0", "100.0 300.0 300.0 100.0");
  }

  @Test
  void anUnfinishedPolygonHasNeutralVerticesAndNoCounts() {
    RecordingPen pen = painted(Scene.outline(Rings.ofChain(Fixtures.PENTAGON), true, List.of()));
    assertThat(pen.count("disc", Ink.VERTEX)).isEqualTo(5);
    assertThat(pen.count("line", Ink.BOUNDARY)).isEqualTo(4);
    assertThat(pen.count("line", Ink.PROPOSED)).isEqualTo(1);
    assertThat(pen.texts()).isEmpty();
  }

  @Test
  void crossingEdgesAreRed() {
    Points bowTie = Points.ofPairs(0, 0, 100, 100, 100, 0, 0, 100);
    Defect crossing = new Defect(Defect.Kind.CROSSING, 0, 2, 50, 50, 4);
    RecordingPen pen = painted(Scene.outline(Rings.ofChain(bowTie), false, List.of(crossing)));
    assertThat(pen.shapes)
        .filteredOn(s -> s.ink() == Ink.DEFECT && s.kind().equals("line"))
        .extracting(s -> ends(s))
        .containsExactly("0.0 0.0 100.0 100.0", "100.0 0.0 0.0 100.0");
    assertThat(pen.shapes)
        .filteredOn(s -> s.kind().equals("ring"))
        .extracting(Shape::x, Shape::y)
        .containsExactly(tuple(50.0, 50.0));
  }

  @Test
  void theLastEdgeOfAPolygonIsCalledByItsTwoEnds() {
    Points points = Points.ofPairs(0, 0, 100, 100, 100, 0, 50, 90);
    Defect crossing = new Defect(Defect.Kind.CROSSING, 1, 3, 100, 50, 4);
    RecordingPen pen = painted(Scene.outline(Rings.ofChain(points), false, List.of(crossing)));
    assertThat(pen.shapes)
        .filteredOn(s -> s.ink() == Ink.DEFECT && s.kind().equals("line"))
        .extracting(s -> ends(s))
        .contains("50.0 90.0 0.0 0.0");
  }

  @Test
  void whatLiesOutsideTheScreenIsLeftOut() {
    RecordingPen pen = new RecordingPen();
    Viewport away = Viewport.IDENTITY.panned(-350, 0);
    ScenePainter.paint(Scene.of(Fixtures.pentagon()), away, SCREEN, pen);
    // Only v2 is still in sight, and the edges that reach it.
    assertThat(pen.count("disc", Ink.EVEN)).isEqualTo(1);
    assertThat(pen.count("square", Ink.ODD)).isZero();
    assertThat(pen.count("line", Ink.BOUNDARY)).isEqualTo(2);
  }

  @Test
  void theEdgesOfTinyShapesAreDrawnToo() {
    Points tiny = Points.ofPairs(0, 0, 1e-200, 0, 1e-200, 1e-200, 0, 2e-200);
    Scene scene = Scene.outline(Rings.ofChain(tiny), false, List.of());
    RecordingPen pen = new RecordingPen();
    ScenePainter.paint(scene, ScenePainter.fitted(scene, 1000, 700, false), SCREEN, pen);
    assertThat(pen.count("line", Ink.BOUNDARY)).isEqualTo(4);
  }

  @Test
  void labelsAreWrittenOnRequest() {
    Scene scene = Scene.of(Fixtures.pentagon());
    assertThat(painted(scene.withLabels(new Labels(true, false))).texts())
        .contains("v0", "v1", "v2", "v3", "v4");
    assertThat(painted(scene.withLabels(new Labels(false, true))).texts()).contains("3", "2", "4");
    assertThat(painted(scene.withLabels(new Labels(true, true))).texts())
        .contains("v0 · 3", "v2 · 4");
  }

  @Test
  void aFittedSceneKeepsClearOfItsCounts() {
    Scene scene = Scene.of(Fixtures.flippedPentagon());
    RecordingPen pen = new RecordingPen();
    ScenePainter.paint(scene, ScenePainter.fitted(scene, 1000, 700, false), SCREEN, pen);
    Notes.at(false).paint(scene, SCREEN, pen, "");
    double lowest =
        pen.shapes.stream()
            .filter(s -> s.kind().equals("text"))
            .mapToDouble(Shape::y)
            .max()
            .orElseThrow();
    assertThat(pen.shapes)
        .filteredOn(s -> s.kind().equals("disc") || s.kind().equals("square"))
        .hasSize(5)
        .allSatisfy(s -> assertThat(s.y()).isGreaterThan(lowest + 10));
  }

  @Test
  void unmetWishesAreRinged() {
    // Degrees of v0 … v4: 3, 2, 4, 2, 3.
    RecordingPen pen = painted(best(Wish.EVEN, Wish.ODD, Wish.ANY, Wish.EVEN, Wish.ODD));
    assertThat(pen.shapes)
        .filteredOn(s -> s.kind().equals("ring"))
        .extracting(Shape::ink, Shape::x, Shape::y)
        .containsExactlyInAnyOrder(tuple(Ink.UNMET, 100.0, 100.0), tuple(Ink.UNMET, 300.0, 100.0));
    assertThat(pen.texts())
        .containsExactlyInAnyOrder(
            "odd", "any", "odd", "Even 3 · Odd 2", "Granted 3 · Unmet 2 — optimal (by hand)");
  }

  @Test
  void whereTheSameIsWishedOfAllItIsNotWrittenBesideEach() {
    RecordingPen pen = painted(best(Wish.ODD, Wish.ODD, Wish.ODD, Wish.ODD, Wish.ODD));
    assertThat(pen.count("ring", Ink.UNMET)).isEqualTo(3);
    assertThat(pen.texts())
        .containsExactly("Even 3 · Odd 2 — best found; 2 or more cannot be avoided (by hand)");
  }

  private static Scene best(Wish... wishes) {
    ParityGoal goal = ParityGoal.of(wishes);
    int unmet = goal.unmet(Fixtures.pentagon());
    Optimum best =
        new Optimum(Fixtures.pentagon(), goal, unmet, new LowerBound(2, "by hand"), false);
    return Scene.of(Fixtures.solution().optimized(best, SearchLimits.DEFAULT));
  }

  @Test
  void wishesOtherThanEvenAreWrittenBesideTheirVertices() {
    ParityGoal goal = ParityGoal.allEven(5).with(1, Wish.ODD).with(3, Wish.ANY);
    Scene polygon = Scene.outline(Rings.ofChain(Fixtures.PENTAGON), false, List.of());
    assertThat(painted(polygon.withWishes(goal)).texts()).containsExactly("odd", "any");
    Scene numbered = polygon.withWishes(goal).withLabels(new Labels(true, false));
    assertThat(painted(numbered).texts()).contains("v0", "v1 · odd", "v3 · any");
    assertThat(painted(polygon.withWishes(ParityGoal.allEven(5))).texts()).isEmpty();
  }

  @Test
  void crowdedLabelsAreThinned() {
    Points crowd = Points.ofPairs(100, 100, 101, 101, 102, 100, 101, 99, 500, 500);
    RecordingPen pen = painted(Scene.sites(crowd).withLabels(new Labels(true, false)));
    assertThat(pen.texts()).hasSizeLessThan(5).contains("v0", "v4");
  }

  @Test
  void nothingIsDrawnForNoPoints() {
    assertThat(painted(Scene.sites(Points.ofPairs())).shapes).isEmpty();
    assertThat(painted(Scene.outline(Rings.ofChain(Points.ofPairs()), true, List.of())).shapes)
        .isEmpty();
  }

  private static String ends(Shape line) {
    return line.x() + " " + line.y() + " " + line.text();
  }

  private static RecordingPen painted(Scene scene) {
    RecordingPen pen = new RecordingPen();
    ScenePainter.paint(scene, Viewport.IDENTITY, SCREEN, pen);
    Notes.at(false).paint(scene, SCREEN, pen, "");
    return pen;
  }
}
