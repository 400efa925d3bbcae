package dct.cli;

import dct.core.Progress;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.SimplicityCheck;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.io.BadInputException;
import dct.io.StoredResult;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Checks a stored result against its own points and edges, and believes nothing else in it.
 *
 * <p>That the edges triangulate the domain is proven so: the faces of the drawing, found from the
 * angles at the vertices, are counter-clockwise triangles but for one; Euler's formula makes them,
 * glued along their edges, a disk; its rim is the polygon itself or a convex polygon. A map of a
 * disk that keeps every triangle's orientation and takes the rim once round a simple polygon covers
 * each point of the inside exactly once and nothing outside. So no two edges cross, and the areas
 * add up.
 *
 * <p>Flips of a Scan-Flip run lie in quadrilaterals that share no triangle. So they can be undone
 * from the result alone: the counts before are recounted, and the Delaunay property is checked of
 * what was there before.
 *
 * <p>Exact; O(n log n) time.
 */
final class ResultVerifier {
  private static final List<String> POSTS = List.of("none", "flip", "optimize");
  private static final String CURE = "; make the result again from its input";

  private final StoredResult stored;
  private final Points points;
  private final int n;
  private Domain domain;
  private PlaneGraph graph;
  private boolean[] outer; // by half-edge: whether the outer face is on its left
  private int boundary; // edges of the outer face
  private FlipUndo flips;
  private String remark = "";

  private ResultVerifier(StoredResult stored) {
    this.stored = stored;
    this.points = stored.points();
    this.n = points.size();
  }

  /**
   * Checks everything.
   *
   * @return what is to be told of a true result besides, empty or beginning with a semicolon
   * @throws BadInputException at the first thing that is not true
   */
  static String verify(StoredResult stored) {
    ResultVerifier verifier = new ResultVerifier(stored);
    verifier.run();
    return verifier.remark;
  }

  private void run() {
    checkForm();
    checkPoints();
    checkEdges();
    checkFaces();
    checkRim();
    checkCounts();
    checkKinds();
    checkFlips();
    checkDegrees();
    checkBound();
    checkDelaunay();
  }

  private void checkForm() {
    domain = stored.domain().orElseThrow(() -> lie("the field \"kind\" is missing"));
    if (!stored.hasEdges()) {
      throw lie("the field \"edgeList\" is missing, these are points without a triangulation");
    }
    String algorithm = stored.text("algorithm").orElse("");
    if (!Algorithm.isOne(algorithm, domain)) {
      throw lie("the algorithm is none of " + Algorithm.words(domain));
    }
    String post = stored.text("post").orElse("");
    if (!POSTS.contains(post)) {
      throw lie("the field \"post\" is none of \"none\", \"flip\", \"optimize\"");
    }
    boolean possible = domain == Domain.SITES ? whole("merged") >= 0 : whole("merged") == 0;
    check(possible, "the field \"merged\" cannot be " + whole("merged"));
  }

  private void checkPoints() {
    check(n >= 3, "there are fewer than three vertices");
    if (domain == Domain.SITES) {
      check(Sites.of(points, Progress.NONE).merged() == 0, "two sites are at the same place");
    } else {
      Optional<Defect> defect = SimplicityCheck.firstDefect(points, Progress.NONE);
      defect.ifPresent(
          d -> {
            throw new BadInputException(
                stored.source(), stored.document().line(d.first()), d.message());
          });
    }
  }

  private void checkEdges() {
    int[] from = new int[stored.edgeCount()];
    int[] to = new int[from.length];
    for (int i = 0; i < from.length; i++) {
      StoredResult.Edge edge = stored.edge(i);
      from[i] = vertex(edge.from(), i);
      to[i] = vertex(edge.to(), i);
      check(from[i] != to[i], i, "the edge leads from vertex v" + from[i] + " to itself");
    }
    graph = new PlaneGraph(points, from, to);
    for (int v = 0; v < n; v++) {
      check(graph.degree(v) > 1, "vertex v" + v + " has fewer than two edges");
    }
    int e = graph.overlapping();
    if (e >= 0) {
      throw lie(e >> 1, "edge " + name(e) + " lies on another edge");
    }
  }

  private int vertex(int v, int edge) {
    check(v >= 0 && v < n, edge, "there is no vertex v" + v);
    return v;
  }

  private void checkFaces() {
    markOuter();
    int inner = 0;
    for (int e = 0; e < graph.halfEdges(); e++) {
      if (!outer[e]) {
        check(graph.isTriangle(e), e >> 1, "on one side of edge " + name(e) + " is no triangle");
        inner++;
      }
    }
    // Each vertex has edges, and a part of its own would have an outer face of its own.
    int euler = n - graph.halfEdges() / 2 + inner / 3 + 1;
    check(euler == 2, "vertices − edges + faces is " + euler + ", not 2");
  }

  private void markOuter() {
    outer = new boolean[graph.halfEdges()];
    boolean[] seen = new boolean[n];
    int start = graph.outer();
    int e = start;
    do {
      int v = graph.origin(e);
      check(!seen[v], e >> 1, "the rim passes twice through vertex v" + v);
      seen[v] = true;
      outer[e] = true;
      boundary++;
      e = graph.next(e);
    } while (e != start);
  }

  private void checkRim() {
    int turns = 0;
    for (int e = 0; e < outer.length; e++) {
      if (!outer[e]) {
        continue;
      }
      if (domain == Domain.POLYGON) {
        int step = Math.floorMod(graph.target(e) - graph.origin(e), n);
        check(step == 1 || step == n - 1, e >> 1, "edge " + name(e) + " is on the rim and no side");
      } else {
        turns += rimTurn(e);
      }
    }
    check(domain == Domain.SITES ? turns == 2 : boundary == n, "the rim is not that of the domain");
  }

  /** Checks that the rim, clockwise, does not turn left; 1 where it changes between up and down. */
  private int rimTurn(int e) {
    int f = graph.next(e);
    int turn = points.orient(graph.origin(e), graph.target(e), graph.target(f));
    check(turn <= 0, e >> 1, "the rim is not convex at vertex v" + graph.target(e));
    boolean up = points.yxLess(graph.origin(e), graph.target(e));
    boolean goesOnUp = points.yxLess(graph.origin(f), graph.target(f));
    return up == goesOnUp ? 0 : 1;
  }

  private void checkCounts() {
    claim("vertices", n);
    claim("edges", stored.edgeCount());
    claim("boundary", boundary);
    claim("triangles", stored.edgeCount() - n + 1L);
  }

  private void checkKinds() {
    boolean partitions =
        domain == Domain.POLYGON && !stored.text("algorithm").orElse("").equals("ear-clipping");
    for (int i = 0; i < stored.edgeCount(); i++) {
      EdgeKind kind = stored.edge(i).kind();
      boolean rim = outer[2 * i] || outer[2 * i + 1];
      check(
          rim == (kind == EdgeKind.BOUNDARY),
          i,
          String.format(
              Locale.ROOT, "edge %s is %s the boundary", name(2 * i), rim ? "on" : "not on"));
      check(
          kind != EdgeKind.PARTITION || partitions,
          i,
          "edge " + name(2 * i) + " is of a partition, and the algorithm makes none");
    }
  }

  private void checkFlips() {
    boolean flipped = isPost("flip");
    flips = new FlipUndo(points, graph, e -> !isPost("optimize") && isFlipped(e));
    check(flipped || flips.count() == 0, "an edge is flipped, and no flips were asked for");
    int e = flips.wrong();
    if (e >= 0) {
      throw lie(e >> 1, "edge " + name(e) + " cannot have come from a flip");
    }
    if (flipped) {
      claim("flips", flips.count());
    }
  }

  private boolean isPost(String word) {
    return stored.text("post").orElse("").equals(word);
  }

  private boolean isFlipped(int e) {
    return stored.edge(e >> 1).kind() == EdgeKind.FLIPPED;
  }

  private void checkDegrees() {
    int odd = 0;
    int oddBefore = 0;
    for (int v = 0; v < n; v++) {
      odd += graph.degree(v) & 1;
      oddBefore += flips.degreeBefore(v) & 1;
    }
    claim("even", n - odd);
    claim("odd", odd);
    if (isPost("flip")) {
      claim("evenBefore", n - oddBefore);
      claim("oddBefore", oddBefore);
    }
  }

  private void checkBound() {
    long bound = whole("oddLowerBound");
    BoundVerifier verifier = new BoundVerifier(stored, domain, boundary, bound, graph::degree);
    verifier
        .lie()
        .ifPresent(
            text -> {
              throw lie(text);
            });
    remark = verifier.remark();
    boolean optimal =
        verifier.isForWishes()
            ? whole("unsatisfied") == whole("unsatisfiedLowerBound")
            : whole("odd") == bound;
    check(
        stored.flag("optimal").equals(Optional.of(optimal)),
        "the field \"optimal\" is not " + optimal);
  }

  private void checkDelaunay() {
    if (domain == Domain.SITES && !isPost("optimize")) {
      int e = flips.notDelaunay(outer);
      if (e >= 0) {
        throw lie(e >> 1, "the triangulation is not Delaunay at edge " + name(e));
      }
    }
  }

  private void claim(String field, long truth) {
    long said = whole(field);
    check(
        said == truth,
        String.format(Locale.ROOT, "the field \"%s\" says %d, but it is %d", field, said, truth));
  }

  private long whole(String field) {
    return stored
        .whole(field)
        .orElseThrow(() -> lie("the field \"" + field + "\" is missing or no whole number"));
  }

  private void check(boolean truth, String lie) {
    if (!truth) {
      throw lie(lie);
    }
  }

  private void check(boolean truth, int edge, String lie) {
    if (!truth) {
      throw lie(edge, lie);
    }
  }

  private BadInputException lie(String lie) {
    return new BadInputException(stored.source(), 1, lie + CURE);
  }

  private BadInputException lie(int edge, String lie) {
    return new BadInputException(stored.source(), stored.edge(edge).line(), lie + CURE);
  }

  private String name(int e) {
    return "v" + graph.origin(e) + "–v" + graph.target(e);
  }
}
