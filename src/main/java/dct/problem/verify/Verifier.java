package dct.problem.verify;

import dct.core.Progress;
import dct.core.degree.Flip;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Post;
import dct.problem.verify.Verdict.Check;
import dct.problem.verify.Verdict.Outcome;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Checks everything that a result file claims of its triangulation against the file's own points
 * and edges, and believes nothing in it.
 *
 * <p>{@link StoredTriangulation} proves that it is a triangulation. The flips that are listed are
 * taken back one after the other; where there is no list, they are those of a Scan-Flip run, which
 * lie in quadrilaterals that share no triangle, so that the result alone tells of them. The counts
 * before are recounted, and of what was there before it is checked that it is Delaunay, or that its
 * partition cuts pieces of the right form. The lower bound is computed anew, and so is what was
 * preferred among equally good triangulations. How the result came to be (times, seed, limits, the
 * input's name) is no claim about it, and is not looked at.
 *
 * <p>Exact; O(n log n) time, and what the bound takes.
 */
public final class Verifier {
  private final Claims claims;
  private final Optional<Instance> input;
  private final Progress progress;
  private final List<Check> checks = new ArrayList<>();
  private final StoredTriangulation stored;
  private PlaneGraph before; // the flips
  private Post post;

  private Verifier(Claims claims, Optional<Instance> input, Progress progress) {
    this.claims = claims;
    this.input = input;
    this.progress = progress;
    this.stored = new StoredTriangulation(claims);
  }

  /**
   * Checks everything, up to the first claim that is false.
   *
   * @param input what the file should be a result of, if that is known
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Verdict verify(Claims claims, Optional<Instance> input, Progress progress) {
    return new Verifier(claims, input, progress).run();
  }

  private Verdict run() {
    try {
      check("the form", this::checkForm);
      check("the points", () -> stored.checkPoints(progress));
      if (stored.instance() instanceof Instance.OfRegion of) {
        check("the rings", () -> ClaimedRings.check(claims, of.region()));
      }
      checkInput();
      check("a triangulation of the domain", () -> stored.checkTriangulation(progress));
      check("the counts", this::checkCounts);
      check("the kinds of edges", this::checkKinds);
      check("the flips", this::checkFlips);
      check("the degrees", this::checkDegrees);
      check("the method", this::checkMethod);
      checks.add(new BoundClaim(claims, stored, progress).check());
      if (claims.has(PreferenceClaim.PREFERRED)) {
        checks.add(new PreferenceClaim(claims, stored, progress).check());
      }
    } catch (FalseClaim lie) {
      // the check that failed is the last of the list
    }
    return new Verdict(checks);
  }

  private void check(String what, Runnable step) {
    progress.checkCancelled();
    try {
      step.run();
      checks.add(new Check(what, Outcome.TRUE, "", 1));
    } catch (FalseClaim lie) {
      checks.add(new Check(what, Outcome.FALSE, lie.getMessage(), lie.line()));
      throw lie;
    }
  }

  private void checkForm() {
    stored.checkForm();
    post = claims.post();
    checkFields();
    long merged = claims.required("merged");
    boolean possible = stored.domain() == Domain.SITES ? merged >= 0 : merged == 0;
    FalseClaim.unless(possible, "the field \"merged\" cannot be " + merged);
  }

  /** Fields that only another kind of result has claim what nothing here can bear out. */
  private void checkFields() {
    if (!post.isFlipped()) {
      refuse(List.of("flips", "evenBefore", "oddBefore"), "no flips were asked for");
      FalseClaim.unless(
          !claims.hasFlips(), "the field \"flipList\" is there, and no flips were asked for");
    }
    if (claims.text("wishes").isEmpty()) {
      refuse(
          List.of("satisfied", "unsatisfied", "unsatisfiedLowerBound", "wishes"),
          "no text holds the wishes");
    }
    if (stored.domain() != Domain.REGION) {
      refuse(ClaimedRings.fields(), "the result is not of a region");
    }
    checkPreference();
  }

  private void checkPreference() {
    if (!claims.has(PreferenceClaim.PREFERRED)) {
      refuse(PreferenceClaim.fields(), "nothing was preferred");
    } else if (!post.isOptimized() || post.isFlipped()) {
      refuse(List.of(PreferenceClaim.PREFERRED), "the result is not the optimizer's");
    }
  }

  private void refuse(List<String> fields, String why) {
    for (String field : fields) {
      FalseClaim.unless(!claims.has(field), "the field \"" + field + "\" is there, and " + why);
    }
  }

  /** Compares points and merged duplicates with the input, which alone can tell of duplicates. */
  private void checkInput() {
    long merged = claims.required("merged");
    if (input.isPresent()) {
      check("the input", () -> compare(input.get()));
    } else if (merged > 0) {
      String open = merged + " merged duplicates were not recounted, for want of the input";
      checks.add(new Check("the input", Outcome.OPEN, open, 1));
    }
  }

  private void compare(Instance given) {
    Points mine = stored.instance().points();
    Points its = given.points();
    String name = given.name();
    FalseClaim.unless(
        given.domain() == stored.instance().domain(),
        "the field \"kind\" is not \"" + given.domain().word() + "\", as " + name + " is");
    FalseClaim.unless(
        mine.size() == its.size(),
        mine.size() + " points are here, and " + its.size() + " in " + name);
    for (int v = 0; v < mine.size(); v++) {
      FalseClaim.unless(
          mine.x(v) == its.x(v) && mine.y(v) == its.y(v),
          claims.line(v),
          "vertex v" + v + " is elsewhere in " + name);
    }
    if (given instanceof Instance.OfRegion other
        && stored.instance() instanceof Instance.OfRegion of) {
      compare(of.region(), other.region(), name);
    }
    claim("merged", given.merged());
  }

  /** Compares rings and fixed edges, however the rings run and wherever they begin. */
  private static void compare(Region mine, Region its, String name) {
    boolean isSame =
        mine.positions() == its.positions()
            && mine.rings().fixedCount() == its.rings().fixedCount();
    for (int p = 0; p < mine.positions() && isSame; p++) {
      int v = mine.vertex(p);
      isSame =
          its.rings().isOnRing(v)
              && its.vertex(its.after(its.position(v))) == mine.vertex(mine.after(p))
              && (its.rings().ringOf(v) == 0) == (mine.rings().ringOf(v) == 0);
    }
    FalseClaim.unless(isSame, "the rings are not those of " + name);
    for (int j = 0; j < mine.rings().fixedCount(); j++) {
      int u = mine.rings().fixedFrom(j);
      int v = mine.rings().fixedTo(j);
      FalseClaim.unless(its.isFixed(u, v), "edge v" + u + "–v" + v + " is not fixed in " + name);
    }
  }

  private void checkCounts() {
    int n = stored.instance().size();
    int edges = claims.edges().size();
    claim("vertices", n);
    claim("edges", edges);
    claim("boundary", stored.boundary());
    claim("triangles", edges - n + 1L - stored.holes()); // Euler's formula
  }

  private void checkKinds() {
    boolean partitions =
        stored.method().filter(Method::hasPartition).isPresent() && !post.isOptimized();
    for (int i = 0; i < claims.edges().size(); i++) {
      EdgeKind kind = claims.edges().kind(i);
      boolean rim = stored.isRim(i);
      String edge = "edge " + stored.graph().name(2 * i) + " is ";
      int line = claims.edges().line(i);
      FalseClaim.unless(
          rim == (kind == EdgeKind.BOUNDARY),
          line,
          edge + (rim ? "on the boundary" : "not on the boundary"));
      checkFixed(i, edge);
      FalseClaim.unless(
          kind != EdgeKind.PARTITION || partitions,
          line,
          edge + "of a partition, and the algorithm makes none");
      FalseClaim.unless(
          kind != EdgeKind.FLIPPED || post.isFlipped(),
          line,
          edge + "flipped, and no flips were asked for");
    }
  }

  private void checkFixed(int i, String edge) {
    boolean isFixed = stored.isFixed(claims.edges().from(i), claims.edges().to(i));
    FalseClaim.unless(
        isFixed == (claims.edges().kind(i) == EdgeKind.FIXED),
        claims.edges().line(i),
        edge + (isFixed ? "fixed" : "not fixed"));
  }

  /** Checks that no flip is listed that removed or made a fixed edge. */
  private void checkFlipsOfFixed() {
    for (int i = 0; i < claims.flips().size(); i++) {
      Flip flip = claims.flips().flip(i);
      FalseClaim.unless(
          !stored.isFixed(flip.u(), flip.v()) && !stored.isFixed(flip.x(), flip.y()),
          claims.flips().line(i),
          flip + " cannot have been a flip: one of its edges is fixed");
    }
  }

  private void checkFlips() {
    int count;
    if (claims.hasFlips()) {
      checkFlipsOfFixed();
      FlipListUndo undone = stored.undoListedFlips();
      count = undone.count();
      before = graph(undone.result().before());
    } else {
      FlipUndo undone = stored.undoFlips();
      count = undone.count();
      before = undone.before(stored.instance().points());
    }
    if (post.isFlipped()) {
      claim("flips", count);
    }
  }

  private static PlaneGraph graph(Triangulation triangulation) {
    int[] from = new int[triangulation.edgeCount()];
    int[] to = new int[from.length];
    Arrays.setAll(from, triangulation::from);
    Arrays.setAll(to, triangulation::to);
    return new PlaneGraph(triangulation.points(), from, to);
  }

  private void checkDegrees() {
    int n = stored.instance().size();
    int odd = odd(stored.graph());
    claim("even", n - odd);
    claim("odd", odd);
    if (post.isFlipped()) {
      int oddBefore = odd(before);
      claim("evenBefore", n - oddBefore);
      claim("oddBefore", oddBefore);
    }
  }

  private int odd(PlaneGraph graph) {
    int odd = 0;
    for (int v = 0; v < stored.instance().size(); v++) {
      odd += graph.degree(v) & 1;
    }
    return odd;
  }

  /**
   * Checks what the method promises of the triangulation that it made: that it is Delaunay, or that
   * its pieces have the right form. A flipped edge counts as a cut, for a part of a convex or
   * monotone piece behind a diagonal is convex or monotone too.
   */
  private void checkMethod() {
    if (post.isOptimized() || stored.method().isEmpty()) {
      return;
    }
    switch (stored.method().get().promise()) {
      case TRIANGULATION -> {} // checked already
      case EMPTY_CIRCLES -> checkDelaunay();
      case MONOTONE_PIECES -> pieces().check(false);
      case CONVEX_PIECES -> pieces().check(true);
    }
  }

  private Pieces pieces() {
    return new Pieces(
        stored.instance().points(),
        before,
        edge -> claims.edges().kind(edge) != EdgeKind.DIAGONAL,
        stored::isOuter);
  }

  /**
   * A triangulation is Delaunay if it is so at every inner edge: of the two triangles there, the
   * far corner of one is not inside the circle of the other (Delaunay 1934). A constrained one is
   * if that holds of all inner edges but the fixed ones (Lee and Lin 1986).
   */
  private void checkDelaunay() {
    Points points = stored.instance().points();
    for (int edge = 0; edge < claims.edges().size(); edge++) {
      int e = 2 * edge;
      boolean delaunay =
          stored.isRim(edge)
              || claims.edges().kind(edge) == EdgeKind.FIXED
              || points.inCircle(
                      before.origin(e), before.target(e), before.apex(e), before.apex(e + 1))
                  <= 0;
      if (!delaunay) {
        throw stored.lie(e, "the triangulation is not Delaunay at edge " + stored.graph().name(e));
      }
    }
  }

  private void claim(String field, long truth) {
    long said = claims.required(field);
    FalseClaim.unless(said == truth, FalseClaim.wrong(field, said, truth));
  }
}
