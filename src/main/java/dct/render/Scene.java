package dct.render;

import dct.core.Decimals;
import dct.core.dcel.Dcel;
import dct.core.degree.DegreeCount;
import dct.core.degree.FlipResult;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Box;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.MovedSite;
import dct.core.triangulate.Partition;
import dct.core.triangulate.Triangulation;
import dct.problem.Solution;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * What is to be drawn, without saying where and with what; immutable.
 *
 * <p>A scene is made from a triangulation, with its counts, or from a document that is still being
 * drawn. Building one takes linear time.
 */
public final class Scene {
  private static final List<EdgeKind> BACK_TO_FRONT =
      List.of(
          EdgeKind.DIAGONAL,
          EdgeKind.PARTITION,
          EdgeKind.FLIPPED,
          EdgeKind.FIXED,
          EdgeKind.BOUNDARY);
  private static final Map<EdgeKind, Stroke> STROKES =
      new EnumMap<>(
          Map.of(
              EdgeKind.DIAGONAL, Stroke.solid(Ink.DIAGONAL, 1.2),
              EdgeKind.PARTITION, Stroke.solid(Ink.PARTITION, 1.8),
              EdgeKind.FLIPPED, Stroke.solid(Ink.FLIPPED, 2),
              EdgeKind.FIXED, Stroke.solid(Ink.FIXED, 1.8),
              EdgeKind.BOUNDARY, Stroke.solid(Ink.BOUNDARY, 1.6)));
  private static final int DIGITS = 6; // of a coordinate beside its vertex
  private static final int FEW = 3_000; // vertices are sorted within a frame of the screen

  private static final Stroke OUTLINE = Stroke.solid(Ink.BOUNDARY, 1.6);
  private static final Stroke CLOSING = Stroke.dashed(Ink.PROPOSED, 1.4);
  private static final Stroke DEFECT = Stroke.solid(Ink.DEFECT, 3);

  private final Points points;
  private final boolean polygon; // whether the points, in order, are the corners of one
  private final int[] walk; // of a region: along all its rings, see RingWalk; else null
  private final List<EdgeLayer> layers;
  private final int[] degrees; // by vertex; null while nothing is triangulated
  private final List<String> counts;
  private final List<Defect> defects;
  private final Optional<Box> bounds;
  private final Lazy<SceneIndex> index; // takes a while; what is never drawn needs none
  private final int[] unmet; // the vertices that do not have the parity wished
  private final Labels labels;
  private final ParityGoal wishes; // null if every vertex is wished even
  private final ScenePatch patch; // over the index

  /** A scene in which nothing is said of wishes. */
  private Scene(
      Points points,
      boolean polygon,
      List<EdgeLayer> layers,
      int[] degrees,
      List<String> counts,
      List<Defect> defects) {
    this(points, polygon, null, layers, degrees, counts, defects);
  }

  private Scene(
      Points points,
      boolean polygon,
      int[] walk,
      List<EdgeLayer> layers,
      int[] degrees,
      List<String> counts,
      List<Defect> defects) {
    this.points = points;
    this.polygon = polygon;
    this.walk = walk;
    this.layers = List.copyOf(layers);
    this.degrees = degrees;
    this.counts = List.copyOf(counts);
    this.defects = List.copyOf(defects);
    this.bounds = points.size() == 0 ? Optional.empty() : Optional.of(Box.of(points));
    this.index = new Lazy<>(() -> SceneIndex.of(points, degrees, this.layers));
    this.unmet = new int[0];
    this.labels = Labels.NONE;
    this.wishes = null;
    this.patch = ScenePatch.NONE;
  }

  /** The same with other marks at the vertices. */
  private Scene(Scene scene, List<String> counts, int[] unmet, Labels labels, ParityGoal wishes) {
    this(scene, scene.bounds, counts, unmet, labels, wishes, scene.patch);
  }

  private Scene(
      Scene scene,
      Optional<Box> bounds,
      List<String> counts,
      int[] unmet,
      Labels labels,
      ParityGoal wishes,
      ScenePatch patch) {
    this.points = scene.points;
    this.polygon = scene.polygon;
    this.walk = scene.walk;
    this.layers = scene.layers;
    this.degrees = scene.degrees;
    this.counts = List.copyOf(counts);
    this.defects = scene.defects;
    this.bounds = bounds;
    this.index = scene.index;
    this.unmet = unmet;
    this.labels = labels;
    this.wishes = wishes;
    this.patch = patch;
  }

  /** A triangulation and its counts. */
  public static Scene of(Triangulation triangulation) {
    return of(triangulation, List.of(words(DegreeCount.of(triangulation))));
  }

  private static Scene of(FlipResult result) {
    return of(
        result.after(),
        List.of(
            "Before: " + words(DegreeCount.of(result.before())),
            "After: " + words(DegreeCount.of(result.after()))));
  }

  /**
   * A solution: its triangulation with the counts, those before the flips or what is proven of
   * them. Vertices whose wish an optimum does not grant are ringed.
   */
  public static Scene of(Solution solution) {
    return solution
        .flips()
        .map(Scene::of)
        .or(() -> solution.optimum().map(Scene::of))
        .orElseGet(() -> of(solution.triangulation()));
  }

  private static Scene of(Optimum best) {
    Triangulation triangulation = best.triangulation();
    Scene scene = of(triangulation, verdict(best));
    Scene ringed = new Scene(scene, scene.counts, unmet(best), Labels.NONE, null);
    return isOneForAll(best.goal()) ? ringed : ringed.withWishes(best.goal());
  }

  private static boolean isOneForAll(ParityGoal goal) {
    return goal.isAll(Wish.EVEN) || goal.isAll(Wish.ODD);
  }

  private static List<String> verdict(Optimum best) {
    String counts = words(DegreeCount.of(best.triangulation()));
    if (isOneForAll(best.goal())) {
      return List.of(counts + " — " + best.verdict());
    }
    int granted = best.goal().size() - best.unmet();
    return List.of(
        counts,
        String.format(
            Locale.ROOT, "Granted %d · Unmet %d — %s", granted, best.unmet(), best.verdict()));
  }

  private static int[] unmet(Optimum best) {
    return IntStream.range(0, best.goal().size())
        .filter(v -> !best.goal().isGranted(best.triangulation(), v))
        .toArray();
  }

  private static Scene of(Triangulation triangulation, List<String> counts) {
    return new Scene(
        triangulation.points(),
        triangulation.domain() == Domain.POLYGON,
        triangulation.domain() == Domain.REGION ? RingWalk.of(triangulation.dcel()) : null,
        layers(triangulation),
        degrees(triangulation),
        counts,
        List.of());
  }

  /** A polygon in pieces, with their number; its vertices have no degrees yet. */
  public static Scene of(Partition partition) {
    Dcel dcel = partition.dcel();
    EdgeLayer cuts = new EdgeLayer(STROKES.get(EdgeKind.PARTITION), dcel.edgeCount());
    EdgeLayer outline = new EdgeLayer(OUTLINE, partition.region().size());
    for (int edge = 0; edge < dcel.edgeBound(); edge++) {
      if (dcel.hasEdge(edge)) {
        EdgeLayer layer = dcel.isBoundary(edge) ? outline : cuts;
        layer.add(dcel.origin(2 * edge), dcel.target(2 * edge));
      }
    }
    List<String> counts = List.of("Pieces " + partition.pieces());
    boolean isPolygon = partition.region().isPolygon();
    return new Scene(
        partition.region().points(),
        isPolygon,
        isPolygon ? null : RingWalk.of(dcel),
        List.of(cuts, outline),
        null,
        counts,
        List.of());
  }

  /** Points that nothing connects yet. */
  public static Scene sites(Points points) {
    return new Scene(points, false, List.of(), null, List.of(), List.of());
  }

  /**
   * Points with edges of several looks, and nothing said of degrees.
   *
   * @param polygon whether the points, in order, are the corners of one
   * @param layers the edges, what is drawn first coming first
   * @param counts the lines in the upper right corner
   * @param ringed the vertices to be ringed
   */
  static Scene of(
      Points points, boolean polygon, List<EdgeLayer> layers, List<String> counts, int[] ringed) {
    Scene plain = new Scene(points, polygon, layers, null, counts, List.of());
    return new Scene(plain, counts, ringed, Labels.NONE, null);
  }

  /**
   * Rings and fixed edges that are not triangulated yet.
   *
   * @param growing whether the last edge of the last ring, back to its first vertex, is only
   *     proposed
   * @param defects what keeps them from bounding a region; marked red
   */
  public static Scene outline(Rings rings, boolean growing, List<Defect> defects) {
    EdgeLayer closing = new EdgeLayer(growing ? CLOSING : OUTLINE, rings.count());
    EdgeLayer chain = new EdgeLayer(OUTLINE, rings.ringVertices());
    for (int r = 0; r < rings.count(); r++) {
      boolean last = r == rings.count() - 1;
      addChain(rings, r, last ? closing : chain, chain);
    }
    EdgeLayer fixed = new EdgeLayer(STROKES.get(EdgeKind.FIXED), rings.fixedCount());
    for (int j = 0; j < rings.fixedCount(); j++) {
      fixed.add(rings.fixedFrom(j), rings.fixedTo(j));
    }
    List<EdgeLayer> layers = List.of(closing, fixed, chain, defectLayer(defects));
    int[] walk = rings.isChain() ? null : RingWalk.of(rings);
    return new Scene(rings.points(), rings.isChain(), walk, layers, null, List.of(), defects);
  }

  private static void addChain(Rings rings, int r, EdgeLayer closing, EdgeLayer chain) {
    int n = rings.size(r);
    if (n > 2) {
      closing.add(rings.vertex(r, n - 1), rings.vertex(r, 0));
    }
    for (int k = 1; k < n; k++) {
      chain.add(rings.vertex(r, k - 1), rings.vertex(r, k));
    }
  }

  /**
   * This scene of a Delaunay triangulation, in which nothing has moved, with one of the sites
   * elsewhere: in time for what is different, or in linear time if the site was an outermost one.
   */
  public Scene moved(MovedSite moved) {
    if (moved.isBack()) {
      return this;
    }
    ScenePatch other = new ScenePatch(moved, index(), edge -> BACK_TO_FRONT.indexOf(edge.kind()));
    int odd = index().oddCount() + other.moreOdd();
    int all = points.size() - (moved.merged() ? 1 : 0);
    List<String> words = List.of(words(new DegreeCount(all - odd, odd)));
    return new Scene(this, bounds.map(box -> box(box, moved)), words, unmet, labels, wishes, other);
  }

  private Box box(Box before, MovedSite moved) {
    int v = moved.site();
    Box others = before.isOnBorder(points.x(v), points.y(v)) ? Box.ofOthers(points, v) : before;
    return others.around(moved.x(), moved.y());
  }

  /** This scene with nothing written beside the vertices: others write there. */
  public Scene withoutLabels() {
    return new Scene(this, counts, unmet, Labels.NONE, null);
  }

  /** This scene with other labels. */
  public Scene withLabels(Labels wished) {
    return new Scene(this, counts, unmet, wished, wishes);
  }

  /**
   * This scene with the wishes written beside the vertices that are not wished even. Wishes that
   * are not for these vertices are left out: while a site is dragged over another, one of the two
   * is missing.
   */
  public Scene withWishes(ParityGoal goal) {
    boolean any = goal.size() == points.size() && !goal.isAll(Wish.EVEN);
    return new Scene(this, counts, unmet, labels, any ? goal : null);
  }

  /** This scene with a remark behind its counts, if there are any and the remark is not empty. */
  public Scene withRemark(String remark) {
    if (remark.isEmpty() || counts.isEmpty()) {
      return this;
    }
    List<String> lines = new ArrayList<>(counts);
    int last = lines.size() - 1;
    lines.set(last, lines.get(last) + " — " + remark);
    return new Scene(this, lines, unmet, labels, wishes);
  }

  /** This scene with plain counts of its vertices and nothing said of how good they are. */
  public Scene withoutVerdict() {
    return new Scene(this, degrees == null ? counts : plainCounts(), new int[0], labels, wishes);
  }

  private List<String> plainCounts() {
    if (patch.moved().isPresent()) {
      return counts; // plain ones already
    }
    int odd = 0;
    for (int degree : degrees) {
      odd += degree & 1;
    }
    return List.of(words(new DegreeCount(degrees.length - odd, odd)));
  }

  /** The vertices; all of them are copied if one has moved. */
  public Points points() {
    return patch.applied(points);
  }

  /** The number of vertices. */
  public int size() {
    return points.size();
  }

  /** The x-coordinate of vertex v. */
  double x(int v) {
    return patch.isMoved(v) ? patch.moved().orElseThrow().x() : points.x(v);
  }

  /** The y-coordinate of vertex v. */
  double y(int v) {
    return patch.isMoved(v) ? patch.moved().orElseThrow().y() : points.y(v);
  }

  /** Whether the points, in their order, are the corners of a polygon. */
  public boolean isPolygon() {
    return polygon;
  }

  /** Whether it has an inside: that of a polygon or a region. */
  boolean hasInside() {
    return polygon || walk != null;
  }

  /** The corners of a closed walk round the inside; see {@link RingWalk}. */
  Points inside() {
    return walk == null
        ? points()
        : Points.of(
            Arrays.stream(walk).mapToDouble(points::x).toArray(),
            Arrays.stream(walk).mapToDouble(points::y).toArray());
  }

  /** The vertices of each ring round the inside, in order; none if it has no inside. */
  List<int[]> rings() {
    if (walk != null) {
      return RingWalk.rings(walk);
    }
    return polygon ? List.of(IntStream.range(0, size()).toArray()) : List.of();
  }

  /** The box round all vertices, or nothing if there are none. */
  public Optional<Box> bounds() {
    return bounds;
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
    return (degree(v) & 1) == 0 ? Ink.EVEN : Ink.ODD;
  }

  private int degree(int v) {
    return patch.degree(v, degrees[v]);
  }

  /** The number of edges. */
  public int edgeCount() {
    int more = patch.moved().map(move -> move.added().size() - move.removed().size()).orElse(0);
    return more + layers.stream().mapToInt(EdgeLayer::size).sum();
  }

  /** Looks at edges. */
  @FunctionalInterface
  public interface EdgeVisitor {
    /**
     * Looks at the edge between two vertices.
     *
     * @return how far from the place that was asked for further edges are still of interest
     */
    double visit(int from, int to);
  }

  /**
   * Visits the edges near a place of the screen: all those that come nearer to it than the distance
   * which the visitor returned last, and some others.
   */
  public void visitNear(Viewport view, double x, double y, EdgeVisitor visitor) {
    double within = Double.POSITIVE_INFINITY;
    List<IndexedEdges> indexed = index().layers();
    for (int layer = 0; layer < indexed.size(); layer++) {
      IndexedEdges edges = indexed.get(layer);
      Few hidden = patch.hidden(layer);
      Blocks blocks = edges.blocks();
      for (int block = 0; block < blocks.count(); block++) {
        if (blocks.distance(block, view, x, y) <= within) {
          for (int k = blocks.first(block); k < blocks.end(block); k++) {
            if (!hidden.holds(k)) {
              within = visitor.visit(index().vertex(edges.from(k)), index().vertex(edges.to(k)));
            }
          }
        }
      }
    }
    patch.moved().ifPresent(m -> m.added().forEach(e -> visitor.visit(e.from(), e.to())));
  }

  /** This scene, with what is made when it is first drawn made now, in O(n log n). */
  public Scene prepared() {
    index();
    return this;
  }

  /** Whether {@link #visitNear} and drawing need not wait for what {@link #prepared} makes. */
  public boolean isPrepared() {
    return index.isMade();
  }

  /** Whether vertices in a part of the screen can be counted without a delay. */
  public boolean isAtHand() {
    return isPrepared() || size() <= FEW;
  }

  /**
   * How many vertices there are in a part of the screen; counting ends when so many are found.
   *
   * @param part the part, its border included
   */
  public int verticesIn(Viewport view, Box part, int enough) {
    boolean arrived =
        patch.isArrived()
            && part.holds(view.screenX(x(patch.site())), view.screenY(y(patch.site())));
    int count = arrived ? 1 : 0;
    Blocks blocks = index().blocks();
    int block = blocks.next(0, view, part);
    for (; block < blocks.count() && count < enough; block = blocks.next(block + 1, view, part)) {
      for (int place = blocks.first(block); place < blocks.end(block); place++) {
        double x = view.screenX(index().x(place));
        double y = view.screenY(index().y(place));
        count += part.holds(x, y) && !patch.isLeft(place) ? 1 : 0;
      }
    }
    return count;
  }

  /** The colours and lines of the edges that occur, what is drawn first coming first. */
  List<Stroke> strokes() {
    return layers.stream().filter(layer -> layer.size() > 0).map(EdgeLayer::stroke).toList();
  }

  /** Whether there is a vertex of this colour. */
  boolean hasVertex(Ink ink) {
    return IntStream.range(0, size()).anyMatch(v -> ink(v) == ink);
  }

  /** The vertices and edges by place. */
  SceneIndex index() {
    return index.get();
  }

  /** Whether the other scene shows the same but for where one site is, and neither has labels. */
  boolean isLike(Scene other) {
    boolean sameSite =
        patch.site() < 0 || other.patch.site() < 0 || patch.site() == other.patch.site();
    return index == other.index
        && sameSite
        && unmet == other.unmet
        && !hasLabels()
        && !other.hasLabels();
  }

  /** What is otherwise than the index says. */
  ScenePatch patch() {
    return patch;
  }

  /** Whether the degrees are known. */
  boolean hasDegrees() {
    return degrees != null;
  }

  /** What keeps the polygon from being simple. */
  List<Defect> defects() {
    return defects;
  }

  /** The vertices that do not have the parity wished. */
  int[] unmet() {
    return unmet;
  }

  /** Whether anything is written beside the vertices. */
  boolean hasLabels() {
    return labels.any() || wishes != null;
  }

  /** What is written beside vertex v; empty if nothing is. */
  String label(int v) {
    if (patch.isMoved(v) && !patch.isArrived()) {
      return "";
    }
    List<String> words = new ArrayList<>();
    if (labels.numbers()) {
      words.add("v" + v);
    }
    if (labels.degrees() && degrees != null) {
      words.add(Integer.toString(degree(v)));
    }
    if (labels.coordinates()) {
      words.add("(" + legible(x(v)) + ", " + legible(y(v)) + ")");
    }
    if (wishes != null && wishes.wish(v) != Wish.EVEN) {
      words.add(wishes.wish(v).name().toLowerCase(Locale.ROOT));
    }
    return String.join(" · ", words);
  }

  /** A coordinate of at most so many digits as are read at a glance. */
  private static String legible(double value) {
    return Decimals.format(
        new BigDecimal(value).round(new MathContext(DIGITS, RoundingMode.HALF_EVEN)).doubleValue());
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
      if (defect.firstEnd() != defect.first()) {
        layer.add(defect.first(), defect.firstEnd());
      }
      if (defect.secondEnd() != defect.second()) {
        layer.add(defect.second(), defect.secondEnd());
      }
    }
    return layer;
  }
}
