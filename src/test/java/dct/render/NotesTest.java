package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.RecordingPen.Shape;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class NotesTest {
  private static final Box SCREEN = new Box(0, 0, 1000, 700);
  private static final Notes THESIS = Notes.at(false);

  private static Scene delaunay(Points sites) {
    return Scene.of(Delaunay.triangulate(Sites.of(sites, Progress.NONE), Progress.NONE));
  }

  private static RecordingPen painted(Notes notes, Scene scene, String mouse) {
    RecordingPen pen = new RecordingPen();
    notes.paint(scene, SCREEN, pen, mouse);
    return pen;
  }

  private static Scene withSiteAt(double x, double y) {
    return delaunay(Points.ofPairs(300, 300, 700, 350, 500, 500, 450, 200, x, y));
  }

  private static Notes placed(Notes before, Scene scene) {
    return before.placed(scene, Viewport.IDENTITY, SCREEN);
  }

  @Test
  void countsStandAtTheUpperRightWhereNothingIsInTheirWay() {
    Notes notes = placed(THESIS, withSiteAt(600, 400));
    assertThat(notes.counts()).isEqualTo(Corner.UPPER_RIGHT);
    assertThat(notes.coordinates()).isEqualTo(Corner.UPPER_LEFT);
    Shape counts = painted(notes, withSiteAt(600, 400), "x 1   y 2").shapes.get(1);
    assertThat(counts.x()).isBetween(950.0, 1000.0);
    assertThat(counts.y()).isBetween(0.0, 50.0);
  }

  @Test
  void aNoteThatWouldCoverAVertexMovesToAFreeCorner() {
    assertThat(placed(THESIS, withSiteAt(950, 20)).counts()).isNotEqualTo(Corner.UPPER_RIGHT);
    assertThat(placed(THESIS, withSiteAt(60, 20)).coordinates()).isNotEqualTo(Corner.UPPER_LEFT);
    Notes legend = Notes.at(true);
    assertThat(placed(legend, withSiteAt(60, 650)).key()).isNotEqualTo(Corner.LOWER_LEFT);
  }

  @Test
  void noTwoNotesOverlapAndNoneCoversAVertex() {
    for (long seed = 0; seed < 200; seed++) {
      Scene crowd = delaunay(RandomSites.uniform(5 + (int) seed, seed));
      List<Box> grounds = grounds(placed(Notes.at(true), crowd), crowd);
      for (Box box : grounds) {
        assertThat(crowd.verticesIn(Viewport.IDENTITY, box, 1)).as("seed %d", seed).isZero();
        assertThat(grounds.stream().filter(box::meets)).as("seed %d", seed).hasSize(1);
      }
    }
  }

  @Test
  void whileASiteIsDraggedAboutTheBorderNothingJumpsToAndFro() {
    Notes notes = placed(THESIS, withSiteAt(950, 20));
    Corner there = notes.counts();
    for (double y : new double[] {40, 30, 45, 20, 50}) {
      notes = placed(notes, withSiteAt(950, y));
      assertThat(notes.counts()).as("y %s", y).isEqualTo(there);
    }
    assertThat(placed(notes, withSiteAt(950, 200)).counts()).isEqualTo(Corner.UPPER_RIGHT);
  }

  @Test
  void inADrawingFittedWithRoomForFlipsAllNotesComeBackToTheirCorners() {
    Scene square = delaunay(Points.ofPairs(0, 0, 986, 0, 986, 640, 0, 640, 500, 300));
    Viewport fitted = THESIS.fittedForFlips(square, 1000, 700, false);
    Notes moved =
        new Notes(false, Corner.LOWER_RIGHT, Corner.UPPER_RIGHT, Corner.LOWER_LEFT, THESIS.away());
    assertThat(moved.placed(square, fitted, SCREEN)).isEqualTo(THESIS);
  }

  @Test
  void countsBeforeAndAfterFlipsComeBackToTheirCornerOfAFittedDrawing() {
    Points points = Points.ofPairs(0, 0, 900, 10, 880, 500, 10, 640, 500, 300);
    Solution flipped =
        Solution.of(
                Instance.of(Domain.SITES, "a", points, Progress.NONE),
                Method.DELAUNAY,
                Progress.NONE)
            .flipped(Progress.NONE);
    Scene scene = Scene.of(flipped);
    assertThat(scene.counts()).hasSize(2);
    Viewport fitted = THESIS.fittedForFlips(scene, 1000, 700, false);
    Notes moved =
        new Notes(false, Corner.LOWER_RIGHT, Corner.UPPER_LEFT, Corner.LOWER_LEFT, THESIS.away());
    assertThat(moved.placed(scene, fitted, SCREEN).counts()).isEqualTo(Corner.UPPER_RIGHT);
  }

  @Test
  void amongManyVerticesTheWordsAreAside() {
    Scene crowd = delaunay(RandomSites.uniform(5000, 1)).prepared();
    Notes notes = placed(Notes.at(true), crowd);
    assertThat(notes.aside(crowd, "x 1   y 2"))
        .containsExactly("x 1   y 2", crowd.counts().get(0), "No room for the legend (F fits)");
    assertThat(painted(notes, crowd, "x 1   y 2").shapes).isEmpty();
    assertThat(THESIS.haveRoom(crowd, Viewport.IDENTITY, SCREEN)).isFalse();
  }

  @Test
  void wordsThatWereAsideComeBackOnceThereIsMoreRoomThanTheyNeed() {
    Points corners = Points.ofPairs(990, 20, 20, 20, 20, 690, 990, 690, 500, 300);
    Notes away = placed(THESIS, delaunay(corners));
    assertThat(away.aside(delaunay(corners), "")).hasSize(1);
    Points nearly = Points.ofPairs(990, 41, 20, 20, 20, 690, 990, 690, 500, 300);
    assertThat(placed(THESIS, delaunay(nearly)).aside(delaunay(nearly), "")).isEmpty();
    assertThat(placed(away, delaunay(nearly)).aside(delaunay(nearly), "")).hasSize(1);
    Points clear = Points.ofPairs(990, 60, 20, 20, 20, 690, 990, 690, 500, 300);
    assertThat(placed(away, delaunay(clear)).aside(delaunay(clear), "")).isEmpty();
  }

  @Test
  void aFittedCrowdLeavesRoomForCountsAndCoordinatesEvenBeforeItIsSorted() {
    Scene crowd = delaunay(RandomSites.uniform(5000, 1));
    assertThat(THESIS.haveRoom(crowd, Viewport.IDENTITY, SCREEN)).isFalse();
    assertThat(THESIS.haveRoom(crowd, THESIS.fittedForFlips(crowd, 1000, 700, false), SCREEN))
        .isTrue();
    assertThat(crowd.isPrepared()).isFalse();
  }

  @Test
  void countsThatAreWiderThanThePictureAreFolded() {
    Scene scene = Scene.of(Fixtures.flippedPentagon());
    Box narrow = new Box(0, 0, 150, 400);
    RecordingPen pen = new RecordingPen();
    THESIS
        .placed(scene, THESIS.fitted(scene, 150, 400, false), narrow)
        .paint(scene, narrow, pen, "");
    assertThat(String.join(" ", pen.texts())).isEqualTo(String.join(" ", scene.counts()));
    assertThat(pen.texts()).hasSizeGreaterThan(scene.counts().size());
    assertThat(pen.texts()).allSatisfy(text -> assertThat(text.length()).isLessThan(16));
  }

  @ParameterizedTest
  @EnumSource(Corner.class)
  void notesAreWithinThePicture(Corner corner) {
    Scene scene = Scene.of(Fixtures.flippedPentagon());
    Notes notes = new Notes(true, corner, corner, corner, Set.of());
    assertThat(painted(notes, scene, "x 1   y 2").shapes)
        .allSatisfy(s -> assertThat(SCREEN.grown(-5).holds(s.x(), s.y())).as("%s", s).isTrue());
  }

  @Test
  void theLegendNamesWhatOccursAndNothingElse() {
    assertThat(words(Scene.of(Fixtures.pentagon())))
        .containsExactly("Even degree", "Odd degree", "Boundary", "Partition", "Diagonal");
    assertThat(words(Scene.of(Fixtures.flippedPentagon())))
        .containsExactly("Even degree", "Odd degree", "Boundary", "Flipped", "Partition");
    assertThat(words(withSiteAt(600, 400)))
        .containsExactly("Even degree", "Odd degree", "Hull", "Edge");
    assertThat(words(Scene.sites(Fixtures.PENTAGON))).isEmpty();
    ParityGoal goal = ParityGoal.of(Wish.EVEN, Wish.ODD, Wish.ANY, Wish.EVEN, Wish.ODD);
    Optimum best =
        new Optimum(
            Fixtures.pentagon(),
            goal,
            goal.unmet(Fixtures.pentagon()),
            new LowerBound(2, "by hand"),
            false);
    assertThat(words(Scene.of(Fixtures.solution().optimized(best, SearchLimits.DEFAULT))))
        .contains("Unmet wish");
  }

  private static List<String> words(Scene scene) {
    List<String> counts = scene.counts();
    return painted(Notes.at(true), scene, "").texts().stream()
        .filter(text -> !counts.contains(text))
        .toList();
  }

  @Test
  void theLegendShowsTheShapesItNames() {
    RecordingPen pen = painted(Notes.at(true), Scene.of(Fixtures.flippedPentagon()), "");
    assertThat(pen.count("disc", Ink.EVEN)).isEqualTo(1);
    assertThat(pen.count("square", Ink.ODD)).isEqualTo(1);
    assertThat(pen.count("line", Ink.FLIPPED)).isEqualTo(1);
    assertThat(pen.count("line", Ink.BOUNDARY)).isEqualTo(1);
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void aFittedSceneKeepsClearOfAllNotes(boolean yUp) {
    Points wide = Points.ofPairs(0, 0, 1000, 0, 1000, 610, 0, 610, 500, 300);
    Scene scene = delaunay(wide);
    Notes notes = Notes.at(true);
    Viewport view = notes.fitted(scene, 1000, 700, yUp);
    Notes placed = notes.placed(scene, view, SCREEN);
    List<Box> grounds = grounds(placed, scene);
    assertThat(grounds).hasSize(3);
    for (Box box : grounds) {
      assertThat(scene.verticesIn(view, box.grown(5), 10)).as("%s", box).isZero();
    }
  }

  private static List<Box> grounds(Notes notes, Scene scene) {
    return painted(notes, scene, "x 1   y 2").shapes.stream()
        .filter(s -> s.kind().equals("rectangle"))
        .map(NotesTest::box)
        .toList();
  }

  private static Box box(Shape ground) {
    String[] size = ground.text().split(" ", -1);
    return new Box(
        ground.x(),
        ground.y(),
        ground.x() + Double.parseDouble(size[0]),
        ground.y() + Double.parseDouble(size[1]));
  }
}
