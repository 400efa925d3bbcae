package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.experiment.generate.RandomSites;
import dct.render.RecordingPen.Shape;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MarkPainterTest {
  private static final Box SCREEN = new Box(0, 0, 700, 500);
  private static final List<Tone> TONES = List.of(Tone.values());

  private static Scene circle(int n) {
    double[] x = new double[n];
    double[] y = new double[n];
    for (int v = 0; v < n; v++) {
      x[v] = Math.cos(2 * Math.PI * v / n);
      y[v] = Math.sin(2 * Math.PI * v / n);
    }
    return Scene.outline(Rings.ofChain(Points.of(x, y)), false, List.of());
  }

  private static Scene sites(int n) {
    return Scene.of(
        Delaunay.triangulate(Sites.of(RandomSites.uniform(n, 5), Progress.NONE), Progress.NONE));
  }

  private static List<Shape> painted(Scene scene, List<Mark> marks) {
    RecordingPen pen = new RecordingPen();
    MarkPainter.paint(marks, scene, ScenePainter.fitted(scene, 700, 500, false), SCREEN, pen);
    return pen.shapes;
  }

  private static List<Mark> all(Scene scene) {
    List<Mark> marks = new ArrayList<>();
    for (int v = 0; v < scene.size(); v++) {
      marks.add(new Mark.Vertex(v, TONES.get(v % TONES.size()), Integer.toString(v + 1)));
    }
    return marks;
  }

  private static Rectangle2D letters(Shape text) {
    double halfWidth = 3.3 * text.text().length();
    return new Rectangle2D.Double(text.x() - halfWidth, text.y() - 8, 2 * halfWidth, 8);
  }

  private static void requireReadable(Scene scene, List<Shape> labels) {
    Viewport view = ScenePainter.fitted(scene, 700, 500, false);
    for (int i = 0; i < labels.size(); i++) {
      Rectangle2D letters = letters(labels.get(i));
      for (int j = 0; j < i; j++) {
        assertThat(letters.intersects(letters(labels.get(j))))
            .as("%s and %s", labels.get(i).text(), labels.get(j).text())
            .isFalse();
      }
      for (int v = 0; v < scene.size(); v++) {
        assertThat(letters.contains(view.screenX(scene.x(v)), view.screenY(scene.y(v))))
            .as("%s covers v%d", labels.get(i).text(), v)
            .isFalse();
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {12, 60, 150})
  void numbersOnADenseBoundaryThinOut(int n) {
    Scene scene = circle(n);
    List<Shape> labels =
        painted(scene, all(scene)).stream().filter(s -> s.kind().equals("text")).toList();
    assertThat(labels).hasSizeGreaterThan(Math.min(n, 50) - 1);
    requireReadable(scene, labels);
  }

  @ParameterizedTest
  @ValueSource(ints = {40, 300})
  void degreesOfFaultsInsideThinOut(int n) {
    Scene scene = sites(n);
    List<Shape> labels =
        painted(scene, all(scene)).stream().filter(s -> s.kind().equals("text")).toList();
    assertThat(labels).isNotEmpty();
    requireReadable(scene, labels);
  }

  @ParameterizedTest
  @ValueSource(ints = {12, 60})
  void theNumbersOfTheVerticesKeepClearOfThoseOfTheMarks(int n) {
    Scene scene = circle(n).withLabels(new Labels(true, false));
    List<Mark> few = all(scene).subList(0, n / 2);
    List<Shape> labels = painted(scene, few).stream().filter(s -> s.kind().equals("text")).toList();
    assertThat(labels).anyMatch(s -> s.text().startsWith("v")).anyMatch(s -> s.text().equals("1"));
    requireReadable(scene, labels);
  }

  @ParameterizedTest
  @ValueSource(ints = {12, 60, 150})
  void everyVertexHasItsRing(int n) {
    Scene scene = circle(n);
    assertThat(painted(scene, all(scene)).stream().filter(s -> s.kind().equals("ring"))).hasSize(n);
  }
}
