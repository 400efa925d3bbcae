package dct.io;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Defect;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.text.BadInputException;
import dct.problem.Instance;
import dct.problem.Solution;
import dct.problem.verify.ClaimedRings;
import dct.problem.verify.Claims;
import dct.problem.verify.FalseClaim;
import dct.problem.verify.Restoration;
import dct.problem.verify.Verdict;
import dct.problem.verify.Verdict.Outcome;
import dct.problem.verify.Verifier;
import dct.problem.verify.WishLetters;
import java.util.Arrays;
import java.util.List;
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
  private final Domain domain;
  private final Points points;
  private final int[] lines; // the line of each point
  private final Optional<Rings> rings; // of a region, through these points
  private final Optional<Claims> claims; // what a file of JSON says, and whatever else it holds
  private final List<String> notes;
  private final boolean own;
  private final boolean yUp;
  private final Optional<Solution> found; // of a foreign file, which makes no claims

  PointDocument(
      String source,
      Optional<Domain> declared,
      Domain otherwise,
      Points points,
      int[] lines,
      Optional<Rings> rings,
      Optional<Claims> claims,
      List<String> notes,
      boolean own,
      boolean yUp,
      Optional<Solution> found) {
    this.source = source;
    this.declared = declared;
    this.domain = declared.orElse(otherwise);
    this.points = points;
    this.lines = lines;
    this.rings = rings;
    this.claims = claims;
    this.notes = List.copyOf(notes);
    this.own = own;
    this.yUp = yUp;
    this.found = found;
  }

  /** The same with a triangulation of its points that the file holds. */
  PointDocument triangulated(Solution solution) {
    return new PointDocument(
        source,
        declared,
        domain,
        points,
        lines,
        rings,
        claims,
        notes,
        own,
        yUp,
        Optional.of(solution));
  }

  /** Points that come from no file, each on the line that a file without comments gives it. */
  public static PointDocument of(String source, Domain domain, Points points) {
    return of(source, domain, points, Optional.empty());
  }

  /** A region that comes from no file. */
  public static PointDocument of(String source, Rings rings) {
    return of(source, Domain.REGION, rings.points(), Optional.of(rings));
  }

  private static PointDocument of(
      String source, Domain domain, Points points, Optional<Rings> rings) {
    int[] lines = new int[points.size()];
    Arrays.setAll(lines, i -> i + 1);
    return new PointDocument(
        source,
        Optional.of(domain),
        domain,
        points,
        lines,
        rings,
        Optional.empty(),
        List.of(),
        true,
        false,
        Optional.empty());
  }

  /**
   * What a file of the program's own JSON says.
   *
   * @param choice a triangulation of another domain than that asked for is left out
   */
  static PointDocument of(Claims claims, Choice choice) {
    return new PointDocument(
        claims.source(),
        choice.as().or(claims::domain),
        choice.otherwise(),
        claims.points(),
        claims.lines(),
        rings(claims, choice),
        Optional.of(claims).filter(said -> fits(said, choice.as())),
        List.of(),
        true,
        false,
        Optional.empty());
  }

  private static Optional<Rings> rings(Claims claims, Choice choice) {
    boolean isRegion = choice.as().or(claims::domain).orElse(choice.otherwise()) == Domain.REGION;
    try {
      return isRegion ? Optional.of(ClaimedRings.of(claims)) : Optional.empty();
    } catch (FalseClaim e) {
      String cure = "; correct \"rings\" and \"fixed\"";
      throw new BadInputException(claims.source(), e.line(), e.getMessage() + cure);
    }
  }

  private static boolean fits(Claims claims, Optional<Domain> as) {
    return as.isEmpty() || claims.domain().map(as.get()::equals).orElse(!claims.hasEdges());
  }

  /** The file's name as the user gave it, or "-" for standard input. */
  public String source() {
    return source;
  }

  /** What the file's name, or else its contents, say that the points are; nothing if neither. */
  public Optional<Domain> declared() {
    return declared;
  }

  /**
   * Whether the file is of the program's own kind and holds nothing but what was read, so that
   * writing it anew loses nothing.
   */
  public boolean isOwn() {
    return own;
  }

  /** Whether y grows upwards in the file's format. */
  public boolean yUp() {
    return yUp;
  }

  /** What was left out of the file, a sentence each without a full stop. */
  public List<String> notes() {
    return notes;
  }

  /** What the points are taken for: what they are declared to be, or else what the reader chose. */
  public Domain domain() {
    return domain;
  }

  /** The points, in the order of the file. */
  public Points points() {
    return points;
  }

  /** The rings through the points, and the fixed edges, if it is a region. */
  public Optional<Rings> rings() {
    return rings;
  }

  /** The rings of what has an outline: those of a region, or that of a polygon. */
  public Rings outline() {
    return rings.orElseGet(() -> Rings.ofChain(points));
  }

  /** The line of the file that point i stands on, from 1 on. */
  public int line(int i) {
    return lines[i];
  }

  /**
   * The points as an instance.
   *
   * @throws BadInputException if they are not usable
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public Instance instance(Progress progress) {
    try {
      return rings.isPresent()
          ? Instance.of(source, rings.get(), progress)
          : Instance.of(domain, source, points, progress);
    } catch (InvalidGeometryException e) {
      String sites = declared.isEmpty() && couldBeSites(progress) ? SITES_HINT : "";
      throw bad(e.defect(), TouchHint.of(e.defect(), points, rings, progress) + sites);
    }
  }

  /**
   * The solution that the file holds, if it holds more than points.
   *
   * @throws BadInputException if its edges are no triangulation of its points
   */
  public Optional<Solution> solution(Progress progress) {
    try {
      return found.or(
          () -> claims.filter(Claims::hasEdges).map(said -> Restoration.of(said, progress)));
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
