package dct.io.format.json;

import com.google.gson.stream.JsonToken;
import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.io.format.PointColumns;
import dct.io.format.Rim;
import dct.io.format.Shape;
import dct.io.format.StoredFaces;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import dct.problem.verify.ClaimedEdges;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * The files of the challenge CG:SHOP: instances, the polygons of solutions of 2023, the Steiner
 * points of those of 2025. Each triangulation of an instance of 2026 is a shape; the edges of the
 * hull may be left out there.
 */
final class CgShop {
  static final String TITLE = "CG:SHOP";

  private static final Pattern SOLUTION = Pattern.compile("(?i)(.*_)?solution(_.*)?");
  private static final Set<String> NESTED =
      Set.of("points", "outer_boundary", "polygons", "triangulations");
  private static final Set<String> LISTS =
      Set.of("points_x", "points_y", "region_boundary", "steiner_points_x", "steiner_points_y");
  private static final Set<String> MOTION = Set.of("starts", "targets", "steps");
  private static final Set<String> NUMBERS = Set.of("edges", "edge_i", "edge_j");

  private final JsonScanner scanner;
  private final Map<String, Nested> nested = new HashMap<>();
  private final Map<String, double[]> lists = new HashMap<>();
  private final Map<String, Integer> lines = new HashMap<>(); // where the lists end
  private final Set<String> left = new HashSet<>(); // lists of numbers of points or edges
  private String instance = "";
  private Optional<CgShopFlips> flips = Optional.empty();
  private boolean isMotion; // of robots: the challenge of 2021

  CgShop(JsonScanner scanner) {
    this.scanner = scanner;
  }

  /** Reads the value of a field if it is one of the challenge; says whether it was. */
  boolean read(String field) throws IOException {
    boolean isArray = scanner.json.peek() == JsonToken.BEGIN_ARRAY;
    if (isArray && NESTED.contains(field)) {
      nested.put(field, scanner.nested());
    } else if (isArray && LISTS.contains(field)) {
      put(field, scanner.numbers());
    } else if (isArray && (field.equals("x") || field.equals("y"))) {
      put(field, scanner.nestedOrNumbers().map(found -> found.numbers).orElse(new double[0]));
    } else if (isArray && NUMBERS.contains(field)) {
      left.add(field);
      scanner.json.skipValue();
    } else if (isArray && field.equals("flips")) {
      flips = Optional.of(CgShopFlips.read(scanner));
    } else if (isArray && MOTION.contains(field)) {
      isMotion = true;
      scanner.json.skipValue();
    } else if (field.equals("instance") && scanner.json.peek() == JsonToken.STRING) {
      instance = scanner.json.nextString();
    } else {
      return false;
    }
    return true;
  }

  private void put(String field, double[] numbers) {
    lists.put(field, numbers);
    lines.put(field, scanner.line());
  }

  /** Hears of the holes, whose field other formats have, too. */
  void holes(Nested holes) {
    nested.put("holes", holes);
  }

  /**
   * The shapes that an object of this type holds; none if it holds nothing of the challenge.
   *
   * @param name what the object says it is of; may be empty
   * @param notes hears what is left out
   * @throws BadInputException if it is a solution without points
   */
  List<Shape> shapes(String type, String name, List<String> notes) {
    if (has("points_x", "points_y")) {
      return columns(notes);
    }
    if (has("steiner_points_x", "steiner_points_y")) {
      return steinerPoints(name, notes);
    }
    if (has("x", "y") && lists.get("x").length > 0) {
      return List.of(polygonOrSites(notes));
    }
    List<Shape> shapes = new ArrayList<>();
    rings(Shape.Kind.RING, "outer_boundary", shapes);
    rings(Shape.Kind.HOLE, "holes", shapes);
    rings(Shape.Kind.RING, "polygons", shapes);
    if (shapes.isEmpty()) {
      rings(Shape.Kind.SITES, "points", shapes);
    }
    if (shapes.isEmpty() && isMotion) {
      throw scanner.fault(
          "this is CG:SHOP 2021, robots that move on a grid, and nothing to triangulate; open a"
              + " file of another year");
    }
    if (shapes.isEmpty() && SOLUTION.matcher(type).matches()) {
      throw withoutPoints(name);
    }
    return shapes;
  }

  /** The flips of a solution of 2026. */
  Optional<CgShopFlips> flips() {
    return flips;
  }

  private boolean has(String x, String y) {
    return lists.containsKey(x) && lists.containsKey(y);
  }

  /** The points whose x and y stand in these lists, all on the line where the second ends. */
  private PointColumns points(String x, String y) {
    double[] xs = lists.get(x);
    double[] ys = lists.get(y);
    if (xs.length != ys.length) {
      throw scanner.fault(
          "there are " + xs.length + " x, but " + ys.length + " y; give as many of both");
    }
    PointColumns columns = new PointColumns();
    for (int i = 0; i < xs.length; i++) {
      columns.add(xs[i], ys[i], lines.get(y));
    }
    return columns;
  }

  /** The ends of the edges of an instance of 2022, or a polygon of one of 2024. */
  private Shape polygonOrSites(List<String> notes) {
    noteEdges(notes);
    Shape.Kind kind = left.isEmpty() ? Shape.Kind.RING : Shape.Kind.SITES;
    return Shape.of(kind, "", points("x", "y"));
  }

  private void noteEdges(List<String> notes) {
    if (!left.isEmpty()) {
      notes.add("Edges are left out");
    }
  }

  private BadInputException withoutPoints(String name) {
    String of = instance.isEmpty() ? name : instance;
    return scanner.fault(
        "a solution of CG:SHOP without points of its own; open its instance"
            + (of.isEmpty() ? "" : " " + Shown.word(of)));
  }

  private void rings(Shape.Kind kind, String field, List<Shape> shapes) {
    Optional.ofNullable(nested.get(field)).stream()
        .flatMap(found -> found.rings().stream())
        .forEach(ring -> shapes.add(Shape.of(kind, "", ring)));
  }

  private List<Shape> steinerPoints(String name, List<String> notes) {
    PointColumns points = points("steiner_points_x", "steiner_points_y");
    if (points.size() == 0) {
      throw withoutPoints(name);
    }
    if (left.contains("edges")) {
      notes.add("Edges are left out: they number the points of the instance, too");
    }
    return List.of(Shape.of(Shape.Kind.SITES, "Steiner points", points));
  }

  private List<Shape> columns(List<String> notes) {
    PointColumns all = points("points_x", "points_y");
    Points points = all.points();
    int[] pointLines = all.lines();
    List<Shape> shapes = new ArrayList<>();
    double[] boundary = lists.getOrDefault("region_boundary", new double[0]);
    if (boundary.length > 0) {
      PointColumns ring = new PointColumns();
      for (double index : boundary) {
        int v = vertex(index, all.size());
        ring.add(points.x(v), points.y(v), pointLines[v]);
      }
      shapes.add(Shape.of(Shape.Kind.RING, "region", ring));
    }
    List<StoredFaces> triangulations = triangulations(points);
    for (int t = 0; t < triangulations.size(); t++) {
      String label = triangulations.size() == 1 ? "" : "triangulation " + (t + 1);
      Optional<StoredFaces> faces = Optional.of(triangulations.get(t));
      shapes.add(new Shape(Shape.Kind.SITES, label, points, pointLines, faces));
    }
    if (triangulations.isEmpty()) {
      String label = shapes.isEmpty() ? "" : "all points";
      shapes.add(new Shape(Shape.Kind.SITES, label, points, pointLines, Optional.empty()));
    }
    noteEdges(notes);
    return shapes;
  }

  private int vertex(double index, int vertices) {
    if (index != (int) index || index < 0 || index >= vertices) {
      throw scanner.fault(
          "there is no point with the number " + (long) index + "; they count from 0 on");
    }
    return (int) index;
  }

  private List<StoredFaces> triangulations(Points points) {
    Nested found = nested.get("triangulations");
    if (found == null || found.rings().isEmpty()) {
      return List.of();
    }
    if (found.depth != 3) {
      throw scanner.fault(
          "the triangulations are not lists of edges; write [[[u, v], …], …] with numbers of"
              + " points");
    }
    List<int[]> hull = hull(points);
    return found.rings().stream().map(edges -> faces(edges, hull)).toList();
  }

  /** The edges of a triangulation, with those of the hull that are not listed. */
  private StoredFaces faces(PointColumns list, List<int[]> hull) {
    Points ends = list.points(); // x and y are the numbers of both ends
    int[] edgeLines = list.lines();
    ClaimedEdges edges = new ClaimedEdges();
    Set<Long> listed = new HashSet<>();
    for (int i = 0; i < ends.size(); i++) {
      int u = end(ends.x(i), edgeLines[i]);
      int v = end(ends.y(i), edgeLines[i]);
      edges.add(u, v, EdgeKind.DIAGONAL, edgeLines[i]);
      listed.add(key(u, v));
    }
    for (int[] edge : hull) {
      if (!listed.contains(key(edge[0], edge[1]))) {
        edges.add(edge[0], edge[1], EdgeKind.DIAGONAL, edgeLines[0]);
      }
    }
    return StoredFaces.of(edges, new Rim(0));
  }

  private int end(double number, int line) {
    if (number != (int) number) {
      throw scanner.fault(line, "an edge names a point by a fraction; write whole numbers");
    }
    return (int) number;
  }

  private static long key(int u, int v) {
    return (long) Math.min(u, v) << 32 | (Math.max(u, v) & 0xFFFFFFFFL);
  }

  /** The edges of the hull; none where points coincide or are on one line. */
  private static List<int[]> hull(Points points) {
    Sites sites = Sites.of(points, Progress.NONE);
    List<int[]> hull = new ArrayList<>();
    if (points.size() > 2 && sites.merged() == 0 && !sites.areOnOneLine()) {
      Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
      for (int edge = 0; edge < delaunay.edgeCount(); edge++) {
        if (delaunay.kind(edge) == EdgeKind.BOUNDARY) {
          hull.add(new int[] {delaunay.from(edge), delaunay.to(edge)});
        }
      }
    }
    return hull;
  }
}
