package dct.ui.tool;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Flip;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Scene;
import dct.render.Stroke;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class FlipToolTest {
  /** A hexagon with a site inside; v6 has the hull round it. */
  private static final double[] SITES = {
    100, 200, 200, 100, 300, 100, 400, 200, 300, 300, 200, 300, 260, 190
  };

  private final FakeContext context = new FakeContext(Domain.SITES, SITES);
  private final Host host = new Host();
  private final FlipTool tool = new FlipTool(host);

  /** Shows a solution and remembers what was flipped. */
  private static final class Host implements FlipHost {
    private Optional<Solution> shown =
        Optional.of(
            Solution.of(
                Instance.of(Domain.SITES, "", Points.ofPairs(SITES), Progress.NONE),
                Method.DELAUNAY,
                Progress.NONE));
    private final List<Integer> flipped = new ArrayList<>();

    @Override
    public Optional<Solution> solution() {
      return shown;
    }

    @Override
    public Scene scene() {
      return Scene.of(shown.orElseThrow());
    }

    @Override
    public String refusal() {
      return "nothing to flip";
    }

    @Override
    public String verdict() {
      return shown.filter(Solution::isProven).map(Solution::verdict).orElse("");
    }

    @Override
    public void flip(int edge) {
      flipped.add(edge);
      shown = shown.map(solution -> solution.flippedAt(edge));
    }

    int edge(int u, int v) {
      return shown.orElseThrow().triangulation().edgeBetween(u, v).orElseThrow();
    }
  }

  /** Over the middle of v4–v6, whose quadrilateral with v3 and v5 is strictly convex. */
  private Spot onFlippable() {
    return context.spot(280, 246);
  }

  @Test
  void aClickFlipsTheEdgeUnderTheMouse() {
    int edge = host.edge(4, 6);
    tool.pressed(context, onFlippable());
    assertThat(host.flipped).containsExactly(edge);
    assertThat(host.shown.orElseThrow().triangulation().edgeBetween(3, 5)).hasValue(edge);
    tool.pressed(context, context.spot(320, 240));
    assertThat(host.flipped).containsExactly(edge, edge);
    assertThat(host.edge(4, 6)).isEqualTo(edge);
  }

  @Test
  void theHintTellsWhatTheFlipGainsAndThenWhatItHasGained() {
    int before = host.shown.orElseThrow().counts().even();
    tool.moved(context, onFlippable());
    String hint = tool.hint(context);
    tool.pressed(context, onFlippable());
    int gain = host.shown.orElseThrow().counts().even() - before;
    assertThat(hint).matches("Click to flip v[46]–v[46] to v[35]–v[35]: .*");
    assertThat(hint).endsWith(": " + FlipTool.signed(gain) + " even");
  }

  @Test
  void newsEndWhenTheFlipIsUndone() {
    Optional<Solution> before = host.shown;
    tool.pressed(context, onFlippable());
    assertThat(tool.hint(context)).startsWith("Flipped v");
    host.shown = before;
    assertThat(tool.hint(context)).startsWith("Click to flip v4–v6");
  }

  @Test
  void newsStayUntilTheMouseGoesElsewhere() {
    Spot crossing = context.spot(285, 258); // where the diagonals cross
    tool.pressed(context, crossing);
    assertThat(host.flipped).hasSize(1);
    assertThat(tool.hint(context)).startsWith("Flipped v").contains(" even");
    tool.moved(context, context.spot(288, 256));
    assertThat(tool.hint(context)).startsWith("Flipped v");
    tool.moved(context, context.spot(250, 100));
    assertThat(tool.hint(context)).doesNotContain("Flipped");
  }

  @Test
  void anOptimumReachedByHandIsSaidToBeOne() {
    Solution best = host.shown.orElseThrow().optimized(SearchLimits.DEFAULT, Progress.NONE);
    int edge = anyFlippable(best);
    host.shown = Optional.of(best.flippedAt(edge)); // worse, or as good
    Spot middle = middle(edge);
    tool.pressed(context, middle);
    assertThat(host.shown.orElseThrow().unmet()).isEqualTo(best.unmet());
    assertThat(tool.hint(context)).startsWith("Flipped v").contains(" — optimal (");
  }

  private static int anyFlippable(Solution solution) {
    return IntStream.range(0, solution.triangulation().edgeCount())
        .filter(edge -> Flip.at(solution.triangulation(), edge).isPresent())
        .findFirst()
        .orElseThrow();
  }

  private Spot middle(int edge) {
    Triangulation shown = host.shown.orElseThrow().triangulation();
    Points points = shown.points();
    return context.spot(
        (points.x(shown.from(edge)) + points.x(shown.to(edge))) / 2,
        (points.y(shown.from(edge)) + points.y(shown.to(edge))) / 2);
  }

  /** What lights up, lights up in the colours of what it stands for. */
  @Test
  void underTheMouseTheEdgeAndTheOneThatWouldTakeItsPlaceAreDrawnWithTheGain() {
    tool.moved(context, onFlippable());
    Recorder pen = new Recorder();
    tool.paint(context, pen);
    assertThat(pen.lines)
        .containsExactlyInAnyOrder(
            Ink.HIGHLIGHT + " " + line(4, 6), Ink.FLIPPED + " " + line(3, 5));
    assertThat(pen.texts).hasSize(1);
    assertThat(pen.texts.get(0)).matches("(±0|[+−][24]) even");
    tool.left(context);
    Recorder after = new Recorder();
    tool.paint(context, after);
    assertThat(after.lines).isEmpty();
  }

  private static String line(int u, int v) {
    int from = Math.min(u, v);
    int to = Math.max(u, v);
    return SITES[2 * from]
        + ","
        + SITES[2 * from + 1]
        + " "
        + SITES[2 * to]
        + ","
        + SITES[2 * to + 1];
  }

  /** Remembers lines and texts. */
  private static final class Recorder implements Pen {
    private final List<String> lines = new ArrayList<>();
    private final List<String> texts = new ArrayList<>();
    private Ink ink;

    @Override
    public void style(Stroke stroke) {
      ink = stroke.ink();
    }

    @Override
    public void line(double x1, double y1, double x2, double y2) {
      boolean turned = number(x1, y1) > number(x2, y2);
      lines.add(
          ink
              + " "
              + (turned
                  ? x2 + "," + y2 + " " + x1 + "," + y1
                  : x1 + "," + y1 + " " + x2 + "," + y2));
    }

    private static int number(double x, double y) {
      int v = 0;
      while (SITES[2 * v] != x || SITES[2 * v + 1] != y) {
        v++;
      }
      return v;
    }

    @Override
    public void disc(double x, double y, double radius) {}

    @Override
    public void rectangle(double x, double y, double width, double height) {}

    @Override
    public void polygon(double[] x, double[] y) {}

    @Override
    public void ring(double x, double y, double radius) {}

    @Override
    public void text(double x, double y, Anchor anchor, double size, String text) {
      texts.add(text);
    }
  }

  @Test
  void anEdgeThatCannotBeFlippedSaysWhy() {
    tool.moved(context, context.spot(250, 100));
    assertThat(tool.hint(context)).isEqualTo("v1–v2 is on the boundary: it cannot be flipped");
    tool.pressed(context, context.spot(250, 100));
    assertThat(host.flipped).isEmpty();
    assertThat(context.said).contains("is on the boundary");
  }

  @Test
  void anEdgeOfAQuadrilateralThatIsNotConvexSaysSo() {
    FakeContext four = new FakeContext(Domain.SITES, 0, 0, 300, 0, 150, 260, 150, 90);
    host.shown =
        Optional.of(
            Solution.of(
                four.document().instance("", Progress.NONE), Method.DELAUNAY, Progress.NONE));
    tool.moved(four, four.spot(150, 170));
    assertThat(tool.hint(four))
        .contains("no strictly convex quadrilateral")
        .contains("cannot be flipped");
  }

  @Test
  void farFromEveryEdgeNothingIsFlipped() {
    tool.pressed(context, context.spot(700, 600));
    assertThat(host.flipped).isEmpty();
    assertThat(context.said).contains("no edge here");
  }

  @Test
  void withoutATriangulationTheHostSaysWhy() {
    host.shown = Optional.empty();
    tool.moved(context, onFlippable());
    assertThat(tool.hint(context)).isEqualTo("nothing to flip");
    tool.pressed(context, onFlippable());
    assertThat(context.said).isEqualTo("nothing to flip");
  }
}
