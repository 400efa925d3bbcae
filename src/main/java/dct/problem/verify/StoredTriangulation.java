package dct.problem.verify;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.problem.Instance;
import dct.problem.Method;
import java.util.Optional;

/**
 * The triangulation that a result file holds, proven to be one from its points and edges alone.
 *
 * <p>That the edges triangulate a polygon or sites is proven so: the faces of the drawing, found
 * from the angles at the vertices, are counter-clockwise triangles but for one; Euler's formula
 * makes them, glued along their edges, a disk; its rim is the polygon itself or a convex polygon. A
 * map of a disk that keeps every triangle's orientation and takes the rim once round a simple
 * polygon covers each point of the inside exactly once and nothing outside. So no two edges cross,
 * and the areas add up.
 *
 * <p>Of a region neither a disk nor Euler's formula is needed. Its rings are known to bound a
 * region; walk each with the region on its left. Every side of a ring is an edge, and its half-edge
 * on the other side is called outer. All other half-edges are shared out among counter-clockwise
 * triangles, three each. In the sum of these triangles the two half-edges of every inner edge
 * cancel, so its border is the sum of all rings. The winding number of the border round a place on
 * no edge is the sum of those of the triangles, which is the number of triangles that hold the
 * place; the winding number of the rings is 1 in the region and 0 elsewhere. So the triangles cover
 * each place of the region exactly once and nothing outside. No vertex lies in a triangle or an
 * edge of others: it has triangles of its own, and those would cover places twice.
 *
 * <p>Exact; O(n log n) time.
 */
final class StoredTriangulation {
  private final Claims claims;
  private final Points points;
  private final int n;
  private Domain domain;
  private Optional<Method> method = Optional.empty(); // nothing if it is not known
  private Instance instance;
  private PlaneGraph graph;
  private boolean[] outer; // by half-edge: whether the outer face is on its left
  private int[] outerCycles; // of a region: one of these half-edges by ring
  private int boundary; // edges of the outer face

  /** What the claims hold; nothing is checked yet. */
  StoredTriangulation(Claims claims) {
    this.claims = claims;
    this.points = claims.points();
    this.n = points.size();
  }

  /**
   * Checks that domain, method and edges are named.
   *
   * @throws FalseClaim if one of them is not
   */
  void checkForm() {
    domain = claims.domain().orElseThrow(() -> new FalseClaim("the field \"kind\" is missing"));
    FalseClaim.unless(
        claims.hasEdges(),
        "the field \"edgeList\" is missing, these are points without a triangulation");
    String word = claims.text("algorithm").orElse("");
    method = Method.of(domain, word);
    FalseClaim.unless(
        method.isPresent() || word.equals(Method.UNKNOWN),
        "the algorithm is none of "
            + String.join(", ", Method.words(domain))
            + " or "
            + Method.UNKNOWN);
  }

  /**
   * Checks that the points are what they are said to be.
   *
   * @throws FalseClaim if they are not
   */
  void checkPoints(Progress progress) {
    FalseClaim.unless(n >= 3, "there are fewer than three vertices");
    try {
      String name = claims.text("input").orElse(claims.source());
      instance =
          domain == Domain.REGION
              ? Instance.of(name, ClaimedRings.of(claims), progress)
              : Instance.of(domain, name, points, progress);
    } catch (InvalidGeometryException e) {
      throw new FalseClaim(claims.line(e.defect().first()), e.defect().message());
    }
    if (instance.merged() > 0) {
      throw new FalseClaim(claims.line(merged()), "two sites are at the same place");
    }
  }

  /** The first site that was merged into an earlier one. */
  private int merged() {
    Points kept = instance.points();
    int v = 0;
    while (v < kept.size() && kept.x(v) == points.x(v) && kept.y(v) == points.y(v)) {
      v++;
    }
    return v;
  }

  /**
   * Checks that the edges triangulate the domain.
   *
   * @throws FalseClaim if they do not
   */
  void checkTriangulation(Progress progress) {
    checkEnds();
    progress.checkCancelled();
    graph = new PlaneGraph(points, claims.edges().fromAll(), claims.edges().toAll());
    progress.checkCancelled();
    for (int v = 0; v < n; v++) {
      FalseClaim.unless(
          graph.degree(v) > 1, claims.line(v), "vertex v" + v + " has fewer than two edges");
    }
    int e = graph.overlapping();
    if (e >= 0) {
      throw lie(e, "edge " + graph.name(e) + " lies on another edge");
    }
    if (instance instanceof Instance.OfRegion of) {
      markRings(of.region());
      checkRegionFaces();
      checkFixed(of.region());
    } else {
      markOuter();
      checkFaces();
      checkRim();
    }
  }

  /** Marks the half-edges on the other side of the rings; all of these are edges. */
  private void markRings(Region region) {
    outer = new boolean[graph.halfEdges()];
    Rings rings = region.rings();
    outerCycles = new int[rings.count()];
    for (int position = 0; position < region.positions(); position++) {
      int u = region.vertex(position);
      int v = region.vertex(region.after(position));
      int e = graph.halfEdge(v, u);
      FalseClaim.unless(e >= 0, claims.line(u), "edge v" + u + "–v" + v + " of a ring is missing");
      outer[e] = true;
      outerCycles[rings.ringOf(u)] = e;
      boundary++;
    }
  }

  private void checkRegionFaces() {
    for (int e = 0; e < graph.halfEdges(); e++) {
      if (!outer[e] && (!graph.isTriangle(e) || outer[graph.next(e)])) {
        String why =
            outer[e ^ 1]
                ? "inside of edge " + graph.name(e ^ 1) + " of a ring is no triangle"
                : "on one side of edge " + graph.name(e) + " is no triangle of the region";
        throw lie(e, why);
      }
    }
  }

  private void checkFixed(Region region) {
    Rings rings = region.rings();
    for (int j = 0; j < rings.fixedCount(); j++) {
      int u = rings.fixedFrom(j);
      int v = rings.fixedTo(j);
      FalseClaim.unless(
          graph.halfEdge(u, v) >= 0,
          claims.line(u),
          "the fixed edge v" + u + "–v" + v + " is missing");
    }
  }

  private void checkEnds() {
    ClaimedEdges edges = claims.edges();
    for (int i = 0; i < edges.size(); i++) {
      checkVertex(edges.from(i), edges.line(i));
      checkVertex(edges.to(i), edges.line(i));
      FalseClaim.unless(
          edges.from(i) != edges.to(i),
          edges.line(i),
          "the edge leads from vertex v" + edges.from(i) + " to itself");
    }
  }

  private void checkVertex(int v, int line) {
    FalseClaim.unless(v >= 0 && v < n, line, "there is no vertex v" + v);
  }

  private void markOuter() {
    outer = new boolean[graph.halfEdges()];
    boolean[] seen = new boolean[n];
    int start = graph.outer();
    int e = start;
    do {
      int v = graph.origin(e);
      FalseClaim.unless(!seen[v], line(e), "the rim passes twice through vertex v" + v);
      seen[v] = true;
      outer[e] = true;
      boundary++;
      e = graph.next(e);
    } while (e != start);
  }

  private void checkFaces() {
    int inner = 0;
    for (int e = 0; e < graph.halfEdges(); e++) {
      if (!outer[e]) {
        if (!graph.isTriangle(e)) {
          throw lie(e, "on one side of edge " + graph.name(e) + " is no triangle");
        }
        inner++;
      }
    }
    // Each vertex has edges, and a part of its own would have an outer face of its own.
    int euler = n - graph.halfEdges() / 2 + inner / 3 + 1;
    FalseClaim.unless(euler == 2, "vertices − edges + faces is " + euler + ", not 2");
  }

  private void checkRim() {
    int turns = 0;
    for (int e = 0; e < outer.length; e++) {
      if (outer[e]) {
        switch (domain) {
          case POLYGON -> checkSide(e);
          case SITES -> turns += rimTurn(e);
          case REGION -> throw new IllegalStateException("a region has rings");
        }
      }
    }
    boolean whole =
        switch (domain) {
          case POLYGON -> boundary == n;
          case SITES -> turns == 2;
          case REGION -> false;
        };
    FalseClaim.unless(whole, "the rim is not that of the domain");
  }

  /** Checks that an edge of the rim is a side of the polygon. */
  private void checkSide(int e) {
    int step = Math.floorMod(graph.target(e) - graph.origin(e), n);
    if (step != 1 && step != n - 1) {
      throw lie(e, "edge " + graph.name(e) + " is on the rim and no side");
    }
  }

  /** Checks that the rim, clockwise, does not turn left; 1 where it changes between up and down. */
  private int rimTurn(int e) {
    int f = graph.next(e);
    int turn = points.orient(graph.origin(e), graph.target(e), graph.target(f));
    if (turn > 0) {
      throw lie(e, "the rim is not convex at vertex v" + graph.target(e));
    }
    return graph.isUpper(e) == graph.isUpper(f) ? 0 : 1;
  }

  FalseClaim lie(int e, String text) {
    return new FalseClaim(line(e), text);
  }

  private int line(int e) {
    return claims.edges().line(e >> 1);
  }

  /** The method that is named; nothing if it is said to be unknown. */
  Optional<Method> method() {
    return method;
  }

  Domain domain() {
    return domain;
  }

  Instance instance() {
    return instance;
  }

  PlaneGraph graph() {
    return graph;
  }

  /** The number of edges on the rim or the rings, which is that of the vertices there. */
  int boundary() {
    return boundary;
  }

  boolean isOuter(int e) {
    return outer[e];
  }

  boolean isRim(int edge) {
    return outer[2 * edge] || outer[2 * edge + 1];
  }

  /** Whether the instance has this edge fixed. */
  boolean isFixed(int u, int v) {
    return instance instanceof Instance.OfRegion of && of.region().isFixed(u, v);
  }

  /** The number of holes. */
  int holes() {
    return instance instanceof Instance.OfRegion of ? of.region().holes() : 0;
  }

  boolean isFlipped(int edge) {
    return claims.edges().kind(edge) == EdgeKind.FLIPPED;
  }

  /** The triangulation, its edges in the order of the file. */
  Triangulation triangulation() {
    Dcel dcel = outerCycles == null ? graph.toDcel() : graph.toDcel(outerCycles);
    return new Triangulation(domain, points, dcel, claims.edges()::kind);
  }

  /** The edges before the flips that the kinds of the edges tell of. */
  FlipUndo undoFlips() {
    return new FlipUndo(points, graph, claims.edges(), this::isFlipped);
  }

  /** The triangulation before the flips that the file lists. */
  FlipListUndo undoListedFlips() {
    return new FlipListUndo(triangulation(), claims.edges(), claims.flips());
  }
}
