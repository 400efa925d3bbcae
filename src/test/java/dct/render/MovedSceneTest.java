package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.MovedSite;
import dct.core.triangulate.MovingSite;
import dct.core.triangulate.Triangulation;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scenes in which one site has moved show what a scene made anew shows. */
class MovedSceneTest {
  private static final int WIDTH = 400;
  private static final int HEIGHT = 300;
  private static final Box SCREEN = new Box(0, 0, WIDTH, HEIGHT);

  private final Random random = new Random(5);
  private final Triangulation start = delaunay(randomPoints(4000));
  private final Scene scene = Scene.of(start);

  private Points randomPoints(int n) {
    return Points.of(random.doubles(n, 0, WIDTH).toArray(), random.doubles(n, 0, HEIGHT).toArray());
  }

  private static Triangulation delaunay(Points points) {
    return Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE);
  }

  /** An inner site, a hull site or an outermost one. */
  private MovingSite anySite() {
    int v = random.nextInt(start.vertexCount());
    while (random.nextBoolean() && !isOnHull(v)) {
      v = (v + 1) % start.vertexCount();
    }
    return MovingSite.of(start, v).orElseThrow();
  }

  private boolean isOnHull(int v) {
    int e = start.dcel().outEdge(v);
    for (int k = 0; k < start.degree(v); k++) {
      if (start.dcel().isBoundary(e >> 1)) {
        return true;
      }
      e = start.dcel().rotate(e);
    }
    return false;
  }

  private MovedSite anyMove(MovingSite moving) {
    double spread = random.nextBoolean() ? 1 : 1.4; // beyond the hull
    return moving.to(
        WIDTH * (0.5 + spread * (random.nextDouble() - 0.5)),
        HEIGHT * (0.5 + spread * (random.nextDouble() - 0.5)));
  }

  @Test
  void itShowsWhatASceneMadeAnewShows() {
    for (int k = 0; k < 40; k++) {
      MovingSite moving = anySite();
      MovedSite moved = anyMove(moving);
      Points points = start.points().moved(moved.site(), moved.x(), moved.y());
      Scene anew = Scene.of(delaunay(points)).withLabels(new Labels(true, true));
      Scene patched = scene.moved(moved).withLabels(new Labels(true, true));
      assertThat(patched.counts()).isEqualTo(anew.counts());
      assertThat(patched.bounds()).isEqualTo(anew.bounds());
      assertThat(patched.points()).isEqualTo(anew.points());
      assertThat(patched.edgeCount()).isEqualTo(anew.edgeCount());
      for (int v = 0; v < points.size(); v++) {
        assertThat(patched.label(v)).isEqualTo(anew.label(v));
        assertThat(patched.ink(v)).isEqualTo(anew.ink(v));
      }
      double zoom = 1 + 30 * random.nextDouble();
      Viewport view = Viewport.IDENTITY.zoomed(zoom, moved.x(), moved.y());
      assertThat(shapes(patched, view)).as("move %d", k).isEqualTo(shapes(anew, view));
    }
  }

  @Test
  void aSiteOnAnotherOneIsNotToBeSeen() {
    MovingSite moving = MovingSite.of(start, 17).orElseThrow();
    MovedSite moved = moving.to(start.points().x(40), start.points().y(40));
    Scene anew = Scene.of(delaunay(start.points().removed(17)));
    Scene patched = scene.moved(moved);
    assertThat(patched.counts()).isEqualTo(anew.counts());
    assertThat(patched.withLabels(new Labels(true, false)).label(17)).isEmpty();
    Viewport view = Viewport.IDENTITY.zoomed(20, moved.x(), moved.y());
    assertThat(shapes(patched, view)).isEqualTo(shapes(anew, view));
  }

  @Test
  void edgesAreFoundNearAPlaceWhereTheyAreNow() {
    for (int k = 0; k < 20; k++) {
      MovedSite moved = anyMove(anySite());
      List<String> near = new ArrayList<>();
      scene
          .moved(moved)
          .visitNear(
              Viewport.IDENTITY,
              moved.x(),
              moved.y(),
              (from, to) -> {
                near.add(Math.min(from, to) + " " + Math.max(from, to));
                return Double.POSITIVE_INFINITY;
              });
      assertThat(near).doesNotHaveDuplicates();
      assertThat(near).containsAll(names(moved.added()));
      assertThat(near).doesNotContainAnyElementsOf(removedForGood(moved));
    }
  }

  private static List<String> names(List<MovedSite.Edge> edges) {
    return edges.stream().map(edge -> edge.from() + " " + edge.to()).toList();
  }

  private static List<String> removedForGood(MovedSite moved) {
    List<String> gone = new ArrayList<>(names(moved.removed()));
    gone.removeAll(names(moved.added()));
    return gone;
  }

  @Test
  void backAtTheFirstPlaceItIsTheSceneItself() {
    MovingSite moving = MovingSite.of(start, 3).orElseThrow();
    assertThat(scene.moved(moving.to(start.points().x(3), start.points().y(3)))).isSameAs(scene);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.5, 2})
  void aPictureDrawnAnewWhereItDiffersIsThatOfTheWhole(double scale) {
    int redrawn = 0;
    for (int k = 0; k < 12; k++) {
      MovingSite moving = anySite();
      double zoom = (k % 3 == 0 ? 1 : 1 + 40 * random.nextDouble()) / scale;
      Viewport view =
          Viewport.IDENTITY.zoomed(
              zoom, start.points().x(moving.site()), start.points().y(moving.site()));
      Scene last = scene;
      BufferedImage image = picture(scene, view, scale);
      for (int move = 0; move < 6; move++) {
        Scene next = move == 5 ? scene : scene.moved(anyMove(moving));
        if (SceneRaster.redraw(last, next, view, Theme.LIGHT, scale, image)) {
          last = next;
          redrawn++;
        }
        assertSame(image, picture(last, view, scale), k + ", " + move);
      }
    }
    assertThat(redrawn).isGreaterThan(40);
  }

  @Test
  void ofOtherScenesNothingIsDrawnAnew() {
    Scene moved = scene.moved(anyMove(MovingSite.of(start, 1).orElseThrow()));
    Scene other = scene.moved(anyMove(MovingSite.of(start, 2).orElseThrow()));
    Viewport view = Viewport.IDENTITY;
    BufferedImage image = picture(scene, view, 1);
    assertThat(SceneRaster.redraw(Scene.of(start), moved, view, Theme.LIGHT, 1, image)).isFalse();
    assertThat(SceneRaster.redraw(other, moved, view, Theme.LIGHT, 1, image)).isFalse();
    Scene labelled = scene.withLabels(new Labels(true, false));
    assertThat(SceneRaster.redraw(labelled, moved, view, Theme.LIGHT, 1, image)).isFalse();
    assertSame(image, picture(scene, view, 1), "untouched");
  }

  /** What is drawn, whatever the order and the directions of the lines. */
  private static List<String> shapes(Scene scene, Viewport view) {
    RecordingPen pen = new RecordingPen();
    ScenePainter.paintShapes(scene, view, SCREEN, pen);
    return pen.shapes.stream().map(MovedSceneTest::name).sorted().toList();
  }

  private static String name(RecordingPen.Shape shape) {
    String one = shape.x() + " " + shape.y();
    String other = shape.text();
    boolean turned = one.compareTo(other) > 0;
    return shape.kind()
        + " "
        + shape.ink()
        + " "
        + (turned ? other + " " + one : one + " " + other);
  }

  private static BufferedImage picture(Scene scene, Viewport view, double scale) {
    BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    SceneRaster.draw(scene, view, Theme.LIGHT, scale, image, Progress.NONE);
    return image;
  }

  private static void assertSame(BufferedImage image, BufferedImage expected, String what) {
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        assertThat(image.getRGB(x, y))
            .as("%s: (%d, %d)", what, x, y)
            .isEqualTo(expected.getRGB(x, y));
      }
    }
  }
}
