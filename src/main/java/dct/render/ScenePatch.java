package dct.render;

import dct.core.geometry.Points;
import dct.core.triangulate.MovedSite;
import dct.core.triangulate.MovedSite.Edge;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;

/**
 * What a scene shows otherwise than its {@link SceneIndex} says, after one site has moved; small
 * and immutable.
 */
final class ScenePatch {
  /** Nothing is otherwise. */
  static final ScenePatch NONE = new ScenePatch();

  private static final int NOBODY = -1;

  private final Optional<MovedSite> moved;
  private final int site;
  private final int place; // along the curve, where the site was
  private final List<Few> hidden; // by layer: edges of the index that there are no longer
  private final List<List<Edge>> added; // by layer
  private final Map<Integer, Integer> degrees = new HashMap<>(); // that are other ones now
  private final Few turned; // places of vertices that have the other colour now
  private final int moreOdd;

  private ScenePatch() {
    moved = Optional.empty();
    site = NOBODY;
    place = NOBODY;
    hidden = List.of();
    added = List.of();
    turned = Few.NONE;
    moreOdd = 0;
  }

  /**
   * The patch that a move makes, which is not one back to the first place.
   *
   * @param layerOf the layer that an edge belongs to
   */
  ScenePatch(MovedSite move, SceneIndex index, ToIntFunction<Edge> layerOf) {
    moved = Optional.of(move);
    site = move.site();
    place = index.place(site);
    int layers = index.layers().size();
    hidden =
        IntStream.range(0, layers)
            .mapToObj(layer -> numbers(of(layer, move.removed(), layerOf), index, layer))
            .toList();
    added = IntStream.range(0, layers).mapToObj(k -> of(k, move.added(), layerOf)).toList();
    for (int k = 0; k < move.changed().size(); k++) {
      degrees.put(move.changed().get(k), move.degrees().get(k));
    }
    degrees.put(site, move.degree());
    turned =
        Few.of(
            degrees.keySet().stream()
                .mapToInt(index::place)
                .filter(at -> index.isOdd(at) != isOdd(index.vertex(at)))
                .toArray());
    moreOdd = IntStream.of(turned.toArray()).map(at -> index.isOdd(at) ? -1 : 1).sum();
  }

  private static List<Edge> of(int layer, List<Edge> edges, ToIntFunction<Edge> layerOf) {
    return edges.stream().filter(edge -> layerOf.applyAsInt(edge) == layer).toList();
  }

  private static Few numbers(List<Edge> edges, SceneIndex index, int layer) {
    IndexedEdges all = index.layers().get(layer);
    return Few.of(
        edges.stream()
            .mapToInt(edge -> all.find(index.place(edge.from()), index.place(edge.to())))
            .toArray());
  }

  private boolean isOdd(int v) {
    return (degrees.get(v) & 1) == 1;
  }

  /** The move, if there was one. */
  Optional<MovedSite> moved() {
    return moved;
  }

  /** Which edges of a layer of the index there are no longer. */
  Few hidden(int layer) {
    return hidden.isEmpty() ? Few.NONE : hidden.get(layer);
  }

  /** Which edges a layer has besides. */
  List<Edge> added(int layer) {
    return added.isEmpty() ? List.of() : added.get(layer);
  }

  /** Whether any vertex at the places first … end − 1 of the index looks otherwise. */
  boolean meets(int first, int end) {
    return (place >= first && place < end) || turned.meets(first, end);
  }

  /** Whether the vertex at this place of the index has left it. */
  boolean isLeft(int at) {
    return at == place;
  }

  /** The site that has moved; −1 if none has. */
  int site() {
    return site;
  }

  /** Whether this is the site that has moved. */
  boolean isMoved(int v) {
    return v == site;
  }

  /** Whether the site that has moved is to be seen where it is: it is not on another one. */
  boolean isArrived() {
    return moved.isPresent() && !moved.get().merged();
  }

  /** The places of the vertices that have the other colour. */
  Few turned() {
    return turned;
  }

  /** How many more odd vertices there are; a site on another one is none. */
  int moreOdd() {
    return moreOdd;
  }

  /** The degree of a vertex, given that before the move. */
  int degree(int v, int before) {
    return degrees.getOrDefault(v, before);
  }

  /** Where the vertices are, given where they were. */
  Points applied(Points before) {
    return moved.map(m -> before.moved(site, m.x(), m.y())).orElse(before);
  }
}
