package dct.render;

import dct.core.degree.DegreeCount;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.problem.Comparison;
import java.util.List;
import java.util.Locale;

/**
 * The picture of a comparison: the edges that only one of two triangulations has, solid those of
 * the first and dashed those of the second, over the boundary and, faintly, what both have.
 * Vertices are ringed whose parity differs.
 */
public final class ComparisonScene {
  private static final Stroke COMMON = Stroke.solid(Ink.PROPOSED, 0.5);
  private static final Stroke BOUNDARY = Stroke.solid(Ink.BOUNDARY, 1.2);
  private static final Stroke FIRST = Stroke.solid(Ink.FIRST, 2.2);
  private static final Stroke SECOND = Stroke.dashed(Ink.SECOND, 2.2);

  private ComparisonScene() {}

  /**
   * The scene of a comparison, made in linear time.
   *
   * @param first what the first result is called
   * @param second what the second is called
   */
  public static Scene of(Comparison comparison, String first, String second) {
    Triangulation one = comparison.first();
    boolean[] own = new boolean[one.edgeCount()];
    comparison.onlyFirst().forEach(edge -> own[edge] = true);
    EdgeLayer common = new EdgeLayer(COMMON, comparison.common());
    EdgeLayer boundary = new EdgeLayer(BOUNDARY, one.count(EdgeKind.BOUNDARY));
    for (int edge = 0; edge < own.length; edge++) {
      if (!own[edge]) {
        EdgeLayer layer = one.kind(edge) == EdgeKind.BOUNDARY ? boundary : common;
        layer.add(one.from(edge), one.to(edge));
      }
    }
    List<EdgeLayer> layers =
        List.of(
            common,
            boundary,
            layer(FIRST, one, comparison.onlyFirst()),
            layer(SECOND, comparison.second(), comparison.onlySecond()));
    int[] ringed = comparison.parities().stream().mapToInt(v -> v).toArray();
    boolean polygon = one.domain() == Domain.POLYGON;
    return Scene.of(one.points(), polygon, layers, words(comparison, first, second), ringed);
  }

  private static EdgeLayer layer(Stroke stroke, Triangulation of, List<Integer> edges) {
    EdgeLayer layer = new EdgeLayer(stroke, edges.size());
    edges.forEach(edge -> layer.add(of.from(edge), of.to(edge)));
    return layer;
  }

  private static List<String> words(Comparison comparison, String first, String second) {
    return List.of(
        "A: " + first,
        counts(comparison.first()) + own(comparison.onlyFirst().size(), "A, solid"),
        "B: " + second,
        counts(comparison.second()) + own(comparison.onlySecond().size(), "B, dashed"),
        String.format(
            Locale.ROOT,
            "Common edges %d · Parity differs at %d",
            comparison.common(),
            comparison.parities().size()));
  }

  private static String counts(Triangulation triangulation) {
    DegreeCount count = DegreeCount.of(triangulation);
    return String.format(Locale.ROOT, "Even %d · Odd %d", count.even(), count.odd());
  }

  private static String own(int edges, String in) {
    return String.format(Locale.ROOT, " · Edges only in %s: %d", in, edges);
  }
}
