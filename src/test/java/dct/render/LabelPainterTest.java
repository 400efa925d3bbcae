package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.experiment.generate.RandomSites;
import dct.render.RecordingPen.Shape;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LabelPainterTest {
  private static final Box SCREEN = new Box(0, 0, 1000, 700);
  private static final Labels BOTH = new Labels(true, true);
  private static final Labels NUMBERS = new Labels(true, false);

  private static Scene delaunay(int n) {
    Points sites = RandomSites.uniform(n, 5);
    return Scene.of(Delaunay.triangulate(Sites.of(sites, Progress.NONE), Progress.NONE));
  }

  /** Where the letters of a label certainly are. */
  private static Rectangle2D letters(Shape text) {
    double halfWidth = 2.8 * text.text().length();
    return new Rectangle2D.Double(text.x() - halfWidth, text.y() - 7, 2 * halfWidth, 7);
  }

  private static List<Shape> labels(Scene scene, Viewport view) {
    RecordingPen pen = new RecordingPen();
    ScenePainter.paintLabels(scene, view, SCREEN, pen);
    return pen.shapes;
  }

  @ParameterizedTest
  @CsvSource({"50, 1", "500, 1", "500, 6", "20000, 1", "20000, 20"})
  void noLabelCoversAVertexOrAnotherLabel(int n, double zoom) {
    Scene scene = delaunay(n).withLabels(BOTH);
    Viewport view = ScenePainter.fitted(scene, 1000, 700, false).zoomed(zoom, 500, 350);
    List<Shape> labels = labels(scene, view);
    assertThat(labels).isNotEmpty();
    Points points = scene.points();
    for (int i = 0; i < labels.size(); i++) {
      Rectangle2D letters = letters(labels.get(i));
      for (int v = 0; v < n; v++) {
        assertThat(letters.contains(view.screenX(points.x(v)), view.screenY(points.y(v))))
            .as("%s covers v%d", labels.get(i).text(), v)
            .isFalse();
      }
      for (int j = 0; j < i; j++) {
        assertThat(letters.intersects(letters(labels.get(j))))
            .as("%s and %s", labels.get(i).text(), labels.get(j).text())
            .isFalse();
      }
    }
  }

  @Test
  void whereThereIsRoomEveryVertexHasItsLabel() {
    Scene scene = delaunay(30).withLabels(NUMBERS);
    assertThat(labels(scene, ScenePainter.fitted(scene, 1000, 700, false))).hasSize(30);
  }

  @Test
  void whilePannedLabelsStayWhereTheyAre() {
    Scene scene = delaunay(3000).withLabels(NUMBERS);
    Viewport view = ScenePainter.fitted(scene, 1000, 700, false).zoomed(2, 500, 350);
    Map<String, Shape> before = byText(labels(scene, view));
    Map<String, Shape> after = byText(labels(scene, view.panned(7.3, -12.6)));
    long kept =
        before.values().stream()
            .filter(label -> after.containsKey(label.text()))
            .filter(label -> isMoved(label, after.get(label.text()), 7.3, -12.6))
            .count();
    // Some went out of sight, and at the border some have other neighbours.
    assertThat(kept).isGreaterThan(before.size() * 95L / 100);
  }

  private static Map<String, Shape> byText(List<Shape> labels) {
    return labels.stream().collect(Collectors.toMap(Shape::text, label -> label));
  }

  private static boolean isMoved(Shape before, Shape after, double dx, double dy) {
    return Math.abs(after.x() - before.x() - dx) < 1e-6
        && Math.abs(after.y() - before.y() - dy) < 1e-6;
  }

  /** A star: every second corner is reflex. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void labelsOfAPolygonStandOutsideWhicheverWayItGoesRound(boolean reversed) {
    double[] x = new double[14];
    double[] y = new double[14];
    Path2D inside = new Path2D.Double();
    for (int i = 0; i < 14; i++) {
      double angle = (reversed ? -1 : 1) * Math.PI * i / 7;
      double radius = i % 2 == 0 ? 300 : 170;
      x[i] = 500 + radius * Math.cos(angle);
      y[i] = 350 + radius * Math.sin(angle);
      if (i == 0) {
        inside.moveTo(x[i], y[i]);
      } else {
        inside.lineTo(x[i], y[i]);
      }
    }
    Scene scene =
        Scene.outline(Rings.ofChain(Points.of(x, y)), false, List.of()).withLabels(NUMBERS);
    for (Viewport view : List.of(Viewport.IDENTITY, Viewport.IDENTITY.flipped(500, 350))) {
      List<Shape> labels = labels(scene, view);
      assertThat(labels).hasSize(14);
      for (Shape label : labels) {
        double modelY = view.modelY(label.y() - 4);
        assertThat(inside.contains(view.modelX(label.x()), modelY)).as(label.text()).isFalse();
      }
    }
  }

  @Test
  void aLabelKeepsClearOfEdgesWhereItCan() {
    // Edges to the upper right, upper left and lower right of v0; the lower left is free.
    Points sites = Points.ofPairs(500, 350, 900, 100, 100, 100, 900, 650);
    Scene scene =
        Scene.of(Delaunay.triangulate(Sites.of(sites, Progress.NONE), Progress.NONE))
            .withLabels(NUMBERS);
    Shape label =
        labels(scene, Viewport.IDENTITY).stream()
            .filter(s -> s.text().equals("v0"))
            .findFirst()
            .orElseThrow();
    assertThat(label.x()).isLessThanOrEqualTo(500);
    assertThat(label.y() - 4).isGreaterThan(350);
  }
}
