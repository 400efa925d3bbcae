package dct.ui.tool;

import dct.core.degree.Flip;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Triangulation;
import dct.problem.Solution;
import dct.render.Caption;
import dct.render.Ink;
import dct.render.Pen;
import dct.render.Scene;
import dct.render.Stroke;
import dct.render.Viewport;
import java.awt.Cursor;
import java.awt.event.KeyEvent;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Flip Edge: a click on an edge exchanges the diagonals of its quadrilateral. Under the mouse an
 * edge lights up, with the edge that would take its place and what the flip gains.
 */
public final class FlipTool implements Tool {
  /** How far from the mouse an edge may be, in pixels. */
  private static final double REACH = 12;

  /** Beyond so many vertices nothing is looked for until the scene is prepared for it. */
  private static final int AT_ONCE = 20_000;

  private static final double CAPTION_ABOVE = 44;
  private static final double CAPTION_BELOW = 22;

  private final FlipHost host;
  private Spot hover; // null while the mouse is elsewhere
  private Optional<FlipNews> news = Optional.empty(); // of the flip made last

  /** A tool that flips the edges of this view. */
  public FlipTool(FlipHost host) {
    this.host = host;
  }

  @Override
  public String name() {
    return "Flip Edge";
  }

  @Override
  public String description() {
    return "A click exchanges the diagonals of an edge's quadrilateral";
  }

  @Override
  public int key() {
    return KeyEvent.VK_Q;
  }

  @Override
  public Cursor cursor() {
    return Cursor.getPredefinedCursor(Cursor.HAND_CURSOR);
  }

  @Override
  public String hint(ToolContext context) {
    Optional<Solution> solution = host.solution();
    if (solution.isEmpty()) {
      return host.refusal();
    }
    Triangulation shown = solution.get().triangulation();
    Optional<FlipNews> told = news.filter(flip -> flip.isOf(shown));
    if (told.isPresent()) {
      String verdict = host.verdict();
      return told.get().text() + (verdict.isEmpty() ? "" : " — " + verdict);
    }
    OptionalInt edge = edge(context, solution.get());
    return edge.isPresent()
        ? hint(solution.get(), edge.getAsInt())
        : "Click an edge to flip it to the other diagonal of its quadrilateral";
  }

  private static String hint(Solution solution, int edge) {
    Triangulation triangulation = solution.triangulation();
    Optional<Flip> flip = Flip.at(triangulation, edge);
    if (flip.isPresent()) {
      return String.format(
          Locale.ROOT,
          "Click to flip %s to %s: %s",
          flip.get().removed(),
          flip.get().made(),
          gain(solution, flip.get()));
    }
    return String.format(
        Locale.ROOT,
        "v%d–v%d %s: it cannot be flipped",
        Math.min(triangulation.from(edge), triangulation.to(edge)),
        Math.max(triangulation.from(edge), triangulation.to(edge)),
        Flip.obstacle(triangulation, edge).orElseThrow().clause());
  }

  /** What a flip gains, for a person: {@code +2 even}; of wishes where others were asked for. */
  public static String gain(Solution solution, Flip flip) {
    ParityGoal goal =
        solution
            .optimum()
            .map(Optimum::goal)
            .orElseGet(() -> ParityGoal.allEven(solution.instance().size()));
    int gain = flip.gain(solution.triangulation(), goal);
    String what = goal.isAll(Wish.EVEN) ? " even" : goal.isAll(Wish.ODD) ? " odd" : " wishes";
    return signed(gain) + what;
  }

  /** A number with its sign: {@code +2}, {@code −2}, {@code ±0}. */
  public static String signed(int gain) {
    return gain == 0 ? "±0" : (gain > 0 ? "+" : "−") + Math.abs(gain);
  }

  @Override
  public void moved(ToolContext context, Spot spot) {
    hover = spot;
    news = news.filter(flip -> flip.isAt(spot));
  }

  @Override
  public void left(ToolContext context) {
    hover = null;
    news = Optional.empty();
  }

  @Override
  public void pressed(ToolContext context, Spot spot) {
    hover = spot;
    news = Optional.empty();
    Optional<Solution> solution = host.solution();
    OptionalInt edge = edge(context);
    if (solution.isEmpty()) {
      context.say(host.refusal());
    } else if (edge.isEmpty()) {
      context.say("There is no edge here; click closer to one");
    } else {
      flip(context, solution.get(), edge.getAsInt());
    }
  }

  private void flip(ToolContext context, Solution solution, int edge) {
    Optional<Flip> flip = Flip.at(solution.triangulation(), edge);
    if (flip.isEmpty()) {
      context.say(hint(solution, edge));
      return;
    }
    String made = "Flipped " + flip.get().removed() + ": " + gain(solution, flip.get());
    news = Optional.of(new FlipNews(made, hover, solution.triangulation()));
    host.flip(edge);
  }

  private OptionalInt edge(ToolContext context) {
    return host.solution().map(of -> edge(context, of)).orElse(OptionalInt.empty());
  }

  /** The edge under the mouse. */
  private OptionalInt edge(ToolContext context, Solution solution) {
    Scene scene = host.scene();
    boolean slow = scene.size() > AT_ONCE && !scene.isPrepared();
    if (hover == null || slow) {
      return OptionalInt.empty();
    }
    return NearestEdge.of(solution.triangulation(), scene, context.viewport(), hover, REACH);
  }

  @Override
  public void paint(ToolContext context, Pen pen) {
    host.solution()
        .ifPresent(
            solution ->
                edge(context, solution)
                    .ifPresent(edge -> paint(context.viewport(), solution, edge, pen)));
  }

  private void paint(Viewport view, Solution solution, int edge, Pen pen) {
    Triangulation triangulation = solution.triangulation();
    Points points = triangulation.points();
    Optional<Flip> flip = Flip.at(triangulation, edge);
    pen.style(Stroke.solid(flip.isPresent() ? Ink.HIGHLIGHT : Ink.PROPOSED, 3));
    Pick.line(pen, view, points, triangulation.from(edge), triangulation.to(edge));
    if (flip.isPresent()) {
      pen.style(Stroke.dashed(Ink.FLIPPED, 1.6));
      Pick.line(pen, view, points, flip.get().x(), flip.get().y());
      double y = hover.screenY();
      double top = y > CAPTION_ABOVE ? y - CAPTION_ABOVE : y + CAPTION_BELOW;
      Caption.paint(pen, hover.screenX() + REACH, top, gain(solution, flip.get()));
    }
  }
}
