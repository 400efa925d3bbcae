package dct.render;

import dct.core.geometry.Box;
import dct.core.triangulate.MovedSite.Edge;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Where on the screen two scenes look different that are the same but for where one site is: boxes
 * along the edges that only one of them has, and round the vertices that look different. They may
 * overlap.
 */
final class SceneDifference {
  private static final double TILE = 64; // pixels; a box is hardly larger than this
  private static final double STEP = 32; // pixels of a line that go into a box at once
  private static final double SMOOTHING = 2; // how far a shape is seen beyond its edge

  private final Scene before;
  private final Scene now;
  private final Viewport view;
  private final Box screen;
  private final double reach;
  private final Map<Long, Box> boxes = new HashMap<>(); // by tile

  private SceneDifference(Scene before, Scene now, Viewport view, Box screen) {
    this.before = before;
    this.now = now;
    this.view = view;
    this.reach = ScenePainter.dotRadius(now, view) + SMOOTHING;
    this.screen = screen.grown(reach);
  }

  /**
   * The boxes, in pixels of the screen.
   *
   * @param screen the part of the screen that is of interest
   */
  static List<Box> between(Scene before, Scene now, Viewport view, Box screen) {
    SceneDifference difference = new SceneDifference(before, now, view, screen);
    difference.edges();
    difference.vertices();
    return List.copyOf(difference.boxes.values());
  }

  private void edges() {
    Set<Edge> gone = removed(now);
    Set<Edge> goneBefore = removed(before);
    without(gone, goneBefore).forEach(edge -> line(before, edge));
    without(goneBefore, gone).forEach(edge -> line(now, edge));
    Set<Edge> there = added(now);
    Set<Edge> thereBefore = added(before);
    if (!isSamePlace()) { // edges of the site between the same two are others
      there.stream().filter(this::isAtSite).forEach(edge -> line(now, edge));
      thereBefore.stream().filter(this::isAtSite).forEach(edge -> line(before, edge));
    }
    without(there, thereBefore).forEach(edge -> line(now, edge));
    without(thereBefore, there).forEach(edge -> line(before, edge));
  }

  private static Set<Edge> removed(Scene scene) {
    return scene.patch().moved().map(move -> Set.copyOf(move.removed())).orElse(Set.of());
  }

  private static Set<Edge> added(Scene scene) {
    return scene.patch().moved().map(move -> Set.copyOf(move.added())).orElse(Set.of());
  }

  private static Set<Edge> without(Set<Edge> edges, Set<Edge> others) {
    Set<Edge> rest = new HashSet<>(edges);
    rest.removeAll(others);
    return rest;
  }

  private int site() {
    return Math.max(before.patch().site(), now.patch().site());
  }

  private boolean isAtSite(Edge edge) {
    return edge.isAt(site());
  }

  private boolean isSamePlace() {
    int site = site();
    return site < 0 || (before.x(site) == now.x(site) && before.y(site) == now.y(site));
  }

  private void vertices() {
    SceneIndex index = now.index();
    Set<Integer> places = new HashSet<>();
    for (int place : before.patch().turned().toArray()) {
      places.add(place);
    }
    for (int place : now.patch().turned().toArray()) {
      if (!places.add(place)) {
        places.remove(place);
      }
    }
    places.forEach(place -> dot(index.x(place), index.y(place)));
    int site = site();
    if (site >= 0) {
      dot(before.x(site), before.y(site));
      dot(now.x(site), now.y(site));
    }
  }

  private void dot(double x, double y) {
    include(view.screenX(x), view.screenY(y), view.screenX(x), view.screenY(y));
  }

  private void line(Scene scene, Edge edge) {
    double ax = view.screenX(scene.x(edge.from()));
    double ay = view.screenY(scene.y(edge.from()));
    double dx = view.screenX(scene.x(edge.to())) - ax;
    double dy = view.screenY(scene.y(edge.to())) - ay;
    double from =
        Math.max(
            enter(ax, dx, screen.minX(), screen.maxX()),
            enter(ay, dy, screen.minY(), screen.maxY()));
    double to =
        1
            - Math.max(
                enter(ax + dx, -dx, screen.minX(), screen.maxX()),
                enter(ay + dy, -dy, screen.minY(), screen.maxY()));
    int steps = (int) Math.ceil((to - from) * Math.max(Math.abs(dx), Math.abs(dy)) / STEP);
    for (int step = 0; step < steps; step++) {
      double t = from + (to - from) * step / steps;
      double u = from + (to - from) * (step + 1) / steps;
      include(ax + t * dx, ay + t * dy, ax + u * dx, ay + u * dy);
    }
  }

  /** The part of a line after which a coordinate that starts at a and grows by d is in a range. */
  private static double enter(double a, double d, double low, double high) {
    if (a >= low && a <= high) {
      return 0;
    }
    return d == 0 ? 1 : Math.max(0, ((d > 0 ? low : high) - a) / d);
  }

  private void include(double x1, double y1, double x2, double y2) {
    if (screen.mayMeet(x1, y1, x2, y2)) {
      long column = (long) Math.floor((x1 + x2) / 2 / TILE);
      long row = (long) Math.floor((y1 + y2) / 2 / TILE);
      Box box = new Box(x1, y1, x1, y1).around(x2, y2).grown(reach);
      boxes.merge(
          (column << 32) ^ (row & 0xFFFFFFFFL),
          box,
          (a, b) -> a.around(b.minX(), b.minY()).around(b.maxX(), b.maxY()));
    }
  }
}
