package dct.problem.verify;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.degree.FlipResult;
import dct.core.degree.LowerBound;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preferred;
import dct.core.degree.SearchLimits;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.problem.Instance;
import dct.problem.Post;
import dct.problem.Solution;
import java.util.ArrayList;
import java.util.List;

/**
 * The solution that a result file holds. Its edges are checked to be a triangulation; what the file
 * says of bounds is taken as it stands, {@link Verifier} checks that.
 */
public final class Restoration {
  private final Claims claims;
  private final StoredTriangulation stored;

  private Restoration(Claims claims) {
    this.claims = claims;
    this.stored = new StoredTriangulation(claims);
  }

  /**
   * Makes the solution.
   *
   * @throws FalseClaim if the file holds no triangulation of its points
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static Solution of(Claims claims, Progress progress) {
    return new Restoration(claims).solution(progress);
  }

  private Solution solution(Progress progress) {
    stored.checkForm();
    stored.checkPoints(progress);
    stored.checkTriangulation(progress);
    Instance instance = stored.instance();
    Post post = claims.text("post").flatMap(Post::parse).orElse(Post.NONE);
    if (!post.isFlipped()) {
      Solution plain = Solution.of(instance, stored.method(), stored.triangulation());
      return post.isOptimized() ? optimized(plain) : plain;
    }
    FlipResult flips = claims.hasFlips() ? stored.undoListedFlips().result() : kindFlips();
    Solution before = Solution.of(instance, stored.method(), flips.before());
    return (post.isOptimized() ? optimized(before) : before).flipped(flips);
  }

  /** The flips that the kinds of the edges tell of. */
  private FlipResult kindFlips() {
    Triangulation after = stored.triangulation();
    stored.undoFlips();
    List<Integer> flips = new ArrayList<>();
    Dcel dcel = after.dcel().copy();
    for (int edge = 0; edge < after.edgeCount(); edge++) {
      if (after.kind(edge) == EdgeKind.FLIPPED) {
        dcel.flip(2 * edge);
        flips.add(edge);
      }
    }
    Triangulation before =
        new Triangulation(
            after.domain(),
            after.points(),
            dcel,
            edge -> after.kind(edge) == EdgeKind.FLIPPED ? EdgeKind.DIAGONAL : after.kind(edge));
    return new FlipResult(before, after, flips);
  }

  private Solution optimized(Solution plain) {
    int n = plain.instance().size();
    boolean wishes = claims.text("wishes").isPresent();
    ParityGoal goal =
        claims.text("wishes").flatMap(WishLetters::parse).orElse(ParityGoal.allEven(n));
    FalseClaim.unless(goal.size() == n, "the field \"wishes\" is not " + n + " letters e, o or a");
    LowerBound bound =
        new LowerBound(
            (int) claims.required(wishes ? "unsatisfiedLowerBound" : "oddLowerBound"),
            claims.text("boundReason").orElse("no reason given"),
            claims.windows(n));
    Triangulation best = plain.triangulation();
    boolean interrupted = claims.flag("interrupted").orElse(false);
    Optimum optimum = new Optimum(best, goal, goal.unmet(best), bound, interrupted);
    Solution start = Solution.of(plain.instance().with(goal), plain.method(), best);
    return claims.has(PreferenceClaim.PREFERRED)
        ? start.optimized(preferred(optimum), limits())
        : start.optimized(optimum, limits());
  }

  private Preferred preferred(Optimum optimum) {
    boolean isProven = claims.flag(PreferenceClaim.OPTIMAL).orElse(false);
    return Preferred.of(optimum, PreferenceClaim.preference(claims), isProven);
  }

  private SearchLimits limits() {
    SearchLimits usual = SearchLimits.DEFAULT;
    return new SearchLimits(
        claims.whole("seed").orElse(usual.seed()),
        usual.effort(),
        claims.number("timeLimit").orElse(usual.seconds()));
  }
}
