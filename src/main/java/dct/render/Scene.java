package dct.render;

import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.Optimum;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What is to be drawn, without saying where and with what; immutable.
 *
 * <p>A scene is made from a triangulation, with its counts, or from a document that is still being
 * drawn. Building one takes linear time.
 */
public final class Scene {
  private static final List<EdgeKind> BACK_TO_FRONT =
      List.of(EdgeKind.DIAGONAL, EdgeKind.PARTITION, EdgeKind.FLIPPED, EdgeKind.BOUNDARY);
  private static final Map<EdgeKind, Stroke> STROKES =
      new EnumMap<>(
          Map.of(
              EdgeKind.DIAGONAL, Stroke.solid(Ink.DIAGONAL, 1.2),
              EdgeKind.PARTITION, Stroke.solid(Ink.PARTITION, 1.8),
              EdgeKind.FLIPPED, Stroke.solid(Ink.FLIPPED, 2),
              EdgeKind.BOUNDARY, Stroke.solid(Ink.BOUNDARY, 1.6)));
  private static final Stroke OUTLINE = Stroke.solid(Ink.BOUNDARY, 1.6);
  private static final Stroke CLOSING = Stroke.dashed(Ink.PROPOSED, 1.4);
  private static final Stroke DEFECT = Stroke.solid(Ink.DEFECT, 3);

  private final Points points;
  private final List<EdgeLayer> layers;
  private final int[] degrees; // by vertex; null while nothing is triangulated
  private final List<String> counts;
  private final List<Defect> defects;
  private final Labels labels;

  private Scene(
      Points points,
      List<EdgeLayer> layers,
      int[] degrees,
      List<String> counts,
      List<Defect> defects,
      Labels labels) {
    this.points = points;
    this.layers = List.copyOf(layers);
    this.degrees = degrees;
    this.counts = List.copyOf(counts);
    this.defects = List.copyOf(defects);
    this.labels = labels;
  }

  /** A triangulation and its counts. */
  public static Scene of(Triangulation triangulation) {
    return of(triangulation, List.of(words(DegreeCount.of(triangulation))));
  }

  /** A triangulation after flips, with the counts before and after. */
  public static Scene of(FlipResult result) {
    return of(
        result.after(),
        List.of(
            "Before: " + words(DegreeCount.of(result.before())),
            "After: " + words(DegreeCount.of(result.after()))));
  }

  /** The best triangulation found, with its counts and what is proven of them. */
  public static Scene of(Optimum best) {
    Triangulation triangulation = best.triangulation();
    String counts = words(DegreeCount.of(triangulation));
    return of(triangulation, List.of(counts + " — " + best.verdict()));
  }

  private static Scene of(Triangulation triangulation, List<String> counts) {
    return new Scene(
        triangulation.points(),
        layers(triangulation),
        degrees(triangulation),
        counts,
        List.of(),
        Labels.NONE);
  }

  /** Points that nothing connects yet. */
  public static Scene sites(Points points) {
    return new Scene(points, List.of(), null, List.of(), List.of(), Labels.NONE);
  }

  /**
   * A polygon that is not triangulated yet.
   *
   * @param growing whether its last edge, back to the first vertex, is only proposed
   * @param defects what keeps it from being simple; marked red
   */
  public static Scene polygon(Points points, boolean growing, List<Defect> defects) {
    EdgeLayer closing = new EdgeLayer(growing ? CLOSING : OUTLINE, 1);
    int n = points.size();
    if (n > 2) {
      closing.add(n - 1, 0);
    }
    EdgeLayer chain = new EdgeLayer(OUTLINE, n);
    for (int v = 1; v < n; v++) {
      chain.add(v - 1, v);
    }
    List<EdgeLayer> layers = List.of(closing, chain, defectLayer(defects));
    return new Scene(points, layers, null, List.of(), defects, Labels.NONE);
  }

  /** This scene with other labels. */
  public Scene withLabels(Labels wished) {
    return new Scene(points, layers, degrees, counts, defects, wished);
  }

  /** The vertices. */
  public Points points() {
    return points;
  }

  /** The box round all vertices, or nothing if there are none. */
  public Optional<Box> bounds() {
    return points.size() == 0 ? Optional.empty() : Optional.of(Box.of(points));
  }

  /** The lines in the upper right corner: the counts of even and odd vertices. */
  public List<String> counts() {
    return counts;
  }

  /** What is written beside the vertices. */
  public Labels labels() {
    return labels;
  }

  /** The colour of vertex v. */
  public Ink ink(int v) {
    if (degrees == null) {
      return Ink.VERTEX;
    }
    return (degrees[v] & 1) == 0 ? Ink.EVEN : Ink.ODD;
  }

  /** The number of edges. */
  public int edgeCount() {
    return layers.stream().mapToInt(EdgeLayer::size).sum();
  }

  /** The edges, what is drawn first coming first. */
  List<EdgeLayer> layers() {
    return layers;
  }

  /** Whether the degrees are known. */
  boolean hasDegrees() {
    return degrees != null;
  }

  /** What keeps the polygon from being simple. */
  List<Defect> defects() {
    return defects;
  }

  /** What is written beside vertex v; empty if nothing is. */
  String label(int v) {
    String number = labels.numbers() ? "v" + v : "";
    String degree = labels.degrees() && degrees != null ? Integer.toString(degrees[v]) : "";
    return number.isEmpty() || degree.isEmpty() ? number + degree : number + " · " + degree;
  }

  private static String words(DegreeCount count) {
    return "Even " + count.even() + " · Odd " + count.odd();
  }

  private static List<EdgeLayer> layers(Triangulation triangulation) {
    Map<EdgeKind, EdgeLayer> layers = new EnumMap<>(EdgeKind.class);
    STROKES.forEach(
        (kind, stroke) -> layers.put(kind, new EdgeLayer(stroke, triangulation.count(kind))));
    for (int edge = 0; edge < triangulation.edgeCount(); edge++) {
      layers.get(triangulation.kind(edge)).add(triangulation.from(edge), triangulation.to(edge));
    }
    return BACK_TO_FRONT.stream().map(layers::get).toList();
  }

  private static int[] degrees(Triangulation triangulation) {
    int[] degrees = new int[triangulation.vertexCount()];
    for (int v = 0; v < degrees.length; v++) {
      degrees[v] = triangulation.degree(v);
    }
    return degrees;
  }

  private static EdgeLayer defectLayer(List<Defect> defects) {
    EdgeLayer layer = new EdgeLayer(DEFECT, 2 * defects.size());
    for (Defect defect : defects) {
      int n = defect.count();
      switch (defect.kind()) {
        case CROSSING, OVERLAP -> {
          layer.add(defect.first(), (defect.first() + 1) % n);
          layer.add(defect.second(), (defect.second() + 1) % n);
        }
        case TOUCH -> layer.add(defect.second(), (defect.second() + 1) % n);
        case TOO_FEW, COLLINEAR, DUPLICATE, SPIKE -> {}
      }
    }
    return layer;
  }
}
