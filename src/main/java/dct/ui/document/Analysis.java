package dct.ui.document;

import dct.core.Progress;
import dct.core.geometry.Crossings;
import dct.core.geometry.Defect;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Rings;
import dct.core.geometry.SimplicityCheck;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.core.triangulate.MovedSite;
import dct.core.triangulate.MovingSite;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What follows from the points of a document at once: for sites, from the third on, the Delaunay
 * triangulation; for a polygon, what keeps it from being simple. Sites of which something else was
 * made are shown with that. A polygon may be triangulated at once, too. Immutable.
 */
public final class Analysis {
  private static final Manner SITES = Manner.plain(false); // the only one

  private final Document document;
  private final Optional<Solution> automatic;
  private final List<Defect> defects; // also of a provisional edge; the first is the one to name
  private final Scene scene; // of the points and what follows from them
  private final Manner manner;
  private final boolean pending;
  private final Scene shown; // with the wishes, and the result where there is one

  private Analysis(
      Document document,
      Optional<Solution> automatic,
      List<Defect> defects,
      Scene scene,
      Manner manner,
      boolean pending) {
    this.document = document;
    this.automatic = automatic;
    this.defects = defects;
    this.scene = scene;
    this.manner = manner;
    this.pending = pending;
    shown = shownResult().map(Result::scene).orElse(scene).withWishes(document.wishes());
  }

  /**
   * Analyses a document, in O(n log n).
   *
   * @param growing whether vertices are being drawn: the last edge of a polygon is then provisional
   * @throws java.util.concurrent.CancellationException if the progress says so
   */
  public static Analysis of(Document document, boolean growing, Progress progress) {
    return of(document, Manner.plain(growing), progress);
  }

  /**
   * Analyses a document, and triangulates a simple polygon if that is the manner.
   *
   * @throws java.util.concurrent.CancellationException if the progress says so
   */
  static Analysis of(Document document, Manner manner, Progress progress) {
    return document.domain() == Domain.POLYGON
        ? polygon(document, manner, progress)
        : sites(document, progress);
  }

  /** The bare points of a document that is still to be analysed. */
  static Analysis pending(Document document, boolean growing) {
    return document.domain() == Domain.POLYGON
        ? outline(document, List.of(), Manner.plain(growing), true)
        : untriangulated(document, true);
  }

  private static Analysis polygon(Document document, Manner manner, Progress progress) {
    return manner
        .live()
        .flatMap(method -> triangulated(document, method, manner, progress))
        .orElseGet(() -> outline(document, defects(document.rings(), progress), manner, false));
  }

  /** The polygon as the method triangulates it, if it is simple. */
  private static Optional<Analysis> triangulated(
      Document document, LiveMethod method, Manner manner, Progress progress) {
    try {
      Instance instance = document.instance("", progress);
      Solution solution = method.solve(instance, manner.hurried(), progress);
      Scene scene = Scene.of(solution);
      return Optional.of(
          new Analysis(document, Optional.of(solution), List.of(), scene, manner, false));
    } catch (InvalidGeometryException e) {
      return Optional.empty();
    }
  }

  private static Analysis outline(
      Document document, List<Defect> defects, Manner manner, boolean pending) {
    boolean growing = manner.growing();
    boolean open = growing && document.layout().openSize(document.size()) > 0;
    Scene scene = Scene.outline(document.rings(), open, named(document, defects, growing));
    return new Analysis(document, Optional.empty(), defects, scene, manner, pending);
  }

  /**
   * While vertices are being drawn, nothing that only the provisional last edge does is a fault.
   */
  private static List<Defect> named(Document document, List<Defect> defects, boolean growing) {
    return growing
        ? defects.stream().filter(defect -> !isOfLastEdge(defect, document)).toList()
        : defects;
  }

  private static boolean isOfLastEdge(Defect defect, Document document) {
    int first = document.layout().first(document.size());
    int last = document.layout().last(document.size());
    boolean one = isEdge(defect.first(), defect.firstEnd(), first, last);
    boolean other = isEdge(defect.second(), defect.secondEnd(), first, last);
    return switch (defect.kind()) {
      case CROSSING, OVERLAP -> one || other;
      case TOUCH -> other;
      case SPIKE -> defect.first() == first || defect.first() == last;
      case SMALL_HOLE -> defect.first() == first; // there will be more
      case TOO_FEW, COLLINEAR -> !document.layout().isHole();
      case FEW_SITES, SITES_ON_ONE_LINE, DUPLICATE, STRAY_HOLE, STRAY_SITE, STRAY_EDGE -> false;
    };
  }

  private static boolean isEdge(int from, int to, int first, int last) {
    return (from == first && to == last) || (from == last && to == first);
  }

  private static Analysis untriangulated(Document document, boolean pending) {
    Scene scene = Scene.sites(document.points());
    return new Analysis(document, Optional.empty(), List.of(), scene, SITES, pending);
  }

  /** Sites on one line: they are drawn as the path that joins them, and have no solution. */
  private static Analysis path(Document document, Defect defect, Progress progress) {
    Scene scene = Scene.of(Delaunay.triangulate(Sites.of(document.points(), progress), progress));
    return new Analysis(document, Optional.empty(), List.of(defect), scene, SITES, false);
  }

  private static List<Defect> defects(Rings rings, Progress progress) {
    List<Defect> defects = new ArrayList<>();
    SimplicityCheck.firstDefect(rings, progress)
        .ifPresent(
            first -> {
              defects.add(first);
              defects.addAll(Crossings.of(rings, progress));
            });
    return List.copyOf(defects);
  }

  private static Analysis sites(Document document, Progress progress) {
    if (document.size() < 3) {
      return untriangulated(document, false);
    }
    try {
      Instance instance = document.instance("", progress);
      Solution solution = Solution.of(instance, Method.DELAUNAY, progress);
      Scene scene = Scene.of(solution).prepared(); // so that a site can be moved at once
      return new Analysis(document, Optional.of(solution), List.of(), scene, SITES, false);
    } catch (InvalidGeometryException e) {
      return path(document, e.defect(), progress);
    }
  }

  /** Whether everything is known that follows from the points, and not only how they look. */
  public boolean isWhole() {
    return !pending;
  }

  /** Whether this is a whole analysis of such points in this manner, wherever it was made. */
  boolean isOf(Document other, Manner wished) {
    boolean sites = document.domain() == Domain.SITES;
    return isOf(other) && (sites || manner.suits(wished));
  }

  /** Whether this is a whole analysis of such points, wherever it was made. */
  boolean isOf(Document other) {
    return !pending && document.isDrawnAs(other);
  }

  /** The same of a document with the same points; its wishes and its result may be others. */
  Analysis with(Document other) {
    return new Analysis(other, automatic, defects, scene, manner, pending);
  }

  /**
   * The site of this whole analysis to be moved; nothing if that cannot be followed step by step,
   * because sites are merged or its triangulation has nothing but one site beside a line.
   */
  Optional<MovingSite> moving(int site) {
    return automatic
        .filter(delaunay -> delaunay.instance().size() == document.size())
        .flatMap(delaunay -> MovingSite.of(delaunay.triangulation(), site));
  }

  /** The picture of a document in which a site has moved, which is still to be analysed. */
  Analysis moved(Document other, MovedSite site) {
    return new Analysis(
        other, Optional.empty(), List.of(), scene.moved(site), manner, !site.isBack());
  }

  /** The same of a polygon that is, or is no longer, being drawn. */
  public Analysis growing(boolean growing) {
    boolean same = document.domain() != Domain.POLYGON || growing == manner.growing();
    if (same) {
      return this;
    }
    Manner other = manner.growing(growing);
    return automatic.isPresent()
        ? new Analysis(document, automatic, defects, scene, other, pending)
        : outline(document, defects, other, pending);
  }

  /** What was analysed. */
  public Document document() {
    return document;
  }

  /**
   * What was made of the sites, or their Delaunay triangulation; nothing without a triangle. Of a
   * polygon, its live triangulation, if there is one.
   */
  public Optional<Solution> solution() {
    return shownResult().map(Result::solution).or(this::delaunay);
  }

  /** The Delaunay triangulation of sites, whatever else was made of them. */
  public Optional<Solution> delaunay() {
    return automatic.map(delaunay -> wishing(delaunay, document));
  }

  private static Solution wishing(Solution solution, Document document) {
    boolean same = solution.instance().wishes().equals(document.wishes());
    return same || solution.instance().size() != document.size()
        ? solution
        : solution.wishing(document.wishes());
  }

  /** The result that takes the place of the points in the picture: that of sites. */
  private Optional<Result> shownResult() {
    return document.domain() == Domain.SITES ? document.result() : Optional.empty();
  }

  /**
   * What keeps the polygon from being simple, or the sites from having a triangle; while vertices
   * are being drawn, nothing that only the last edge does, which is provisional.
   */
  public List<Defect> defects() {
    return named(document, defects, manner.growing());
  }

  /** The picture. */
  public Scene scene() {
    return shown;
  }
}
