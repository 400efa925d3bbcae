package dct.io;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Defect;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.problem.Instance;
import dct.problem.Solution;
import dct.problem.verify.Claims;
import dct.problem.verify.FalseClaim;
import dct.problem.verify.Restoration;
import dct.problem.verify.Verdict;
import dct.problem.verify.Verdict.Outcome;
import dct.problem.verify.Verifier;
import dct.problem.verify.WishLetters;
import java.util.Arrays;
import java.util.Optional;

/**
 * What a file of points holds, and where in the file each point stands; immutable.
 *
 * <p>The points are finite numbers, no more has been checked: {@link #instance} does that.
 */
public final class PointDocument {
  private static final String SITES_HINT = ", or read the file as sites with --as points";

  private final String source;
  private final Optional<Domain> declared;
  private final Points points;
  private final int[] lines; // the line of each point
  private final Optional<Claims> claims; // what a file of JSON says, and whatever else it holds
  private final int secondRing; // the line where another ring may begin, 0 if there is none

  PointDocument(
      String source, Optional<Domain> declared, Points points, int[] lines, int secondRing) {
    this(source, declared, points, lines, Optional.empty(), secondRing);
  }

  private PointDocument(
      String source,
      Optional<Domain> declared,
      Points points,
      int[] lines,
      Optional<Claims> claims,
      int secondRing) {
    this.source = source;
    this.declared = declared;
    this.points = points;
    this.lines = lines;
    this.claims = claims;
    this.secondRing = secondRing;
  }

  /** Points that come from no file, each on the line that a file without comments gives it. */
  public static PointDocument of(String source, Domain domain, Points points) {
    int[] lines = new int[points.size()];
    Arrays.setAll(lines, i -> i + 1);
    return new PointDocument(source, Optional.of(domain), points, lines, 0);
  }

  /** What a file of the program's own JSON says. */
  static PointDocument of(Claims claims) {
    return new PointDocument(
        claims.source(), claims.domain(), claims.points(), claims.lines(), Optional.of(claims), 0);
  }

  /** The same points, said to be of this domain; a triangulation of another is left out. */
  public PointDocument declared(Domain domain) {
    return new PointDocument(
        source,
        Optional.of(domain),
        points,
        lines,
        claims.filter(said -> said.domain().map(domain::equals).orElse(!said.hasEdges())),
        secondRing);
  }

  /** The file's name as the user gave it, or "-" for standard input. */
  public String source() {
    return source;
  }

  /** What the file's name, or else its contents, say that the points are; nothing if neither. */
  public Optional<Domain> declared() {
    return declared;
  }

  /** The points, in the order of the file. */
  public Points points() {
    return points;
  }

  /** The line of the file that point i stands on, from 1 on. */
  public int line(int i) {
    return lines[i];
  }

  /**
   * The points as an instance; points that are not said to be sites have to be a polygon.
   *
   * @throws BadInputException if they are not usable, or a polygon may be several rings
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Instance instance(Progress progress) {
    checkOneRing();
    try {
      return Instance.of(declared.orElse(Domain.POLYGON), source, points, progress);
    } catch (InvalidGeometryException e) {
      throw declared.isEmpty() && couldBeSites(progress)
          ? bad(e.defect(), SITES_HINT)
          : bad(e.defect(), "");
    }
  }

  /**
   * Sees that the points, unless they are said to be sites, are those of one ring.
   *
   * @throws BadInputException if a blank line parts them where another ring may begin
   */
  public void checkOneRing() {
    if (secondRing > 0 && declared.orElse(Domain.POLYGON) == Domain.POLYGON) {
      throw new BadInputException(
          source,
          secondRing,
          "another ring seems to begin here, behind a blank line; only one ring can be read: remove"
              + " the blank line if it is the same one, or split the file"
              + (declared.isEmpty() ? SITES_HINT : ""));
    }
  }

  /**
   * The points as a polygon, whatever they are said to be.
   *
   * @throws BadInputException if they do not bound a simple polygon
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Instance.OfPolygon polygon(Progress progress) {
    return (Instance.OfPolygon) declared(Domain.POLYGON).instance(progress);
  }

  /**
   * The solution that the file holds, if it holds more than points.
   *
   * @throws BadInputException if its edges are no triangulation of its points
   */
  public Optional<Solution> solution(Progress progress) {
    try {
      return claims.filter(Claims::hasEdges).map(said -> Restoration.of(said, progress));
    } catch (FalseClaim e) {
      throw falseClaim(e.line(), e.getMessage());
    }
  }

  /**
   * What came of checking everything that the file says of its triangulation, if it holds one.
   *
   * @throws BadInputException if some of it is false
   */
  public Optional<Verdict> verified(Progress progress) {
    Optional<Verdict> verdict =
        claims
            .filter(Claims::hasEdges)
            .map(said -> Verifier.verify(said, Optional.empty(), progress));
    verdict
        .flatMap(checked -> checked.first(Outcome.FALSE))
        .ifPresent(
            lie -> {
              throw falseClaim(lie.line(), lie.detail());
            });
    return verdict;
  }

  private BadInputException falseClaim(int line, String what) {
    return new BadInputException(source, line, what + FalseClaim.CURE);
  }

  /**
   * The parities that the file wishes of the vertices, if it holds wishes: those of the document,
   * or else those that its triangulation was made for.
   *
   * @throws BadInputException if they are not one for each point
   */
  public Optional<ParityGoal> wishes() {
    return claims.flatMap(this::wishes);
  }

  private Optional<ParityGoal> wishes(Claims said) {
    String field =
        said.text(ResultJson.DRAWN_WISHES).isPresent() ? ResultJson.DRAWN_WISHES : "wishes";
    Optional<String> letters = said.text(field);
    Optional<ParityGoal> goal = letters.flatMap(WishLetters::parse);
    if (letters.isPresent() && goal.filter(g -> g.size() == points.size()).isEmpty()) {
      throw falseClaim(
          1,
          "the field \""
              + field
              + "\" is not "
              + points.size()
              + (points.size() == 1 ? " letter" : " letters")
              + " e, o or a");
    }
    return goal;
  }

  private boolean couldBeSites(Progress progress) {
    try {
      Instance.of(Domain.SITES, source, points, progress);
      return true;
    } catch (InvalidGeometryException e) {
      return false;
    }
  }

  private BadInputException bad(Defect defect, String hint) {
    return new BadInputException(source, lineOf(defect), defect.message() + hint);
  }

  private int lineOf(Defect defect) {
    if (points.size() == 0) {
      return 1;
    }
    return switch (defect.kind()) {
      case TOO_FEW, FEW_SITES -> lines[points.size() - 1];
      case DUPLICATE -> lines[Math.max(defect.first(), defect.second())]; // the one to remove
      default -> lines[defect.first()];
    };
  }
}
