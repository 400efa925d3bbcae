package dct.ui.document;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Crossings;
import dct.core.geometry.Defect;
import dct.core.geometry.InvalidGeometryException;
import dct.core.geometry.Points;
import dct.core.geometry.SimplicityCheck;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.render.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What follows from the points of a document at once: for sites, from the third on, the Delaunay
 * triangulation, with or without flips; for a polygon, what keeps it from being simple. Immutable.
 */
public final class Analysis {
  private final Document document;
  private final Optional<Solution> solution;
  private final List<Defect> defects; // the first is the one to name
  private final Scene scene;
  private final boolean growing; // of a polygon: the last edge is still provisional
  private final boolean pending;

  private Analysis(
      Document document,
      Optional<Solution> solution,
      List<Defect> defects,
      Scene scene,
      boolean growing,
      boolean pending) {
    this.document = document;
    this.solution = solution;
    this.defects = defects;
    this.scene = scene.withWishes(document.wishes());
    this.growing = growing;
    this.pending = pending;
  }

  /**
   * Analyses a document, in O(n log n).
   *
   * @param growing whether vertices are being drawn: the last edge of a polygon is then provisional
   * @throws java.util.concurrent.CancellationException if the progress says so
   */
  public static Analysis of(Document document, boolean growing, Progress progress) {
    return document.domain() == Domain.POLYGON
        ? polygon(document, defects(document.points(), progress), growing, false)
        : sites(document, progress);
  }

  /** The bare points of a document that is still to be analysed. */
  static Analysis pending(Document document, boolean growing) {
    return document.domain() == Domain.POLYGON
        ? polygon(document, List.of(), growing, true)
        : untriangulated(document, true);
  }

  private static Analysis polygon(
      Document document, List<Defect> defects, boolean growing, boolean pending) {
    Scene scene = Scene.polygon(document.points(), growing, defects);
    return new Analysis(document, Optional.empty(), defects, scene, growing, pending);
  }

  private static Analysis untriangulated(Document document, boolean pending) {
    Scene scene = Scene.sites(document.points());
    return new Analysis(document, Optional.empty(), List.of(), scene, false, pending);
  }

  /** Sites on one line: they are drawn as the path that joins them, and have no solution. */
  private static Analysis path(Document document, Defect defect, Progress progress) {
    Scene scene = Scene.of(Delaunay.triangulate(Sites.of(document.points(), progress), progress));
    return new Analysis(document, Optional.empty(), List.of(defect), scene, false, false);
  }

  private static List<Defect> defects(Points points, Progress progress) {
    List<Defect> defects = new ArrayList<>();
    SimplicityCheck.firstDefect(points, progress)
        .ifPresent(
            first -> {
              defects.add(first);
              defects.addAll(Crossings.of(points, progress));
            });
    return List.copyOf(defects);
  }

  private static Analysis sites(Document document, Progress progress) {
    if (document.size() < 3) {
      return untriangulated(document, false);
    }
    try {
      Instance instance = document.instance("", progress);
      return sites(document, Solution.of(instance, Method.DELAUNAY, progress));
    } catch (InvalidGeometryException e) {
      return path(document, e.defect(), progress);
    }
  }

  private static Analysis sites(Document document, Solution solution) {
    Scene scene = Scene.of(solution);
    return new Analysis(document, Optional.of(solution), List.of(), scene, false, false);
  }

  /** This analysis with another solution for the sites. */
  public Analysis with(Solution other) {
    return sites(document, other);
  }

  /** Whether this is a whole analysis of these points, wherever it was made. */
  boolean isOf(Points points) {
    return !pending && document.points().equals(points);
  }

  /** This analysis with other wishes; what was said of the old ones is no longer shown. */
  Analysis wishing(ParityGoal wishes) {
    return new Analysis(
        document.with(wishes), solution, defects, scene.withoutVerdict(), growing, pending);
  }

  /** The same of a polygon that is, or is no longer, being drawn. */
  public Analysis growing(boolean growing) {
    boolean same = document.domain() != Domain.POLYGON || growing == this.growing;
    return same ? this : polygon(document, defects, growing, pending);
  }

  /** What was analysed. */
  public Document document() {
    return document;
  }

  /** The triangulation of the sites; nothing for a polygon, or for sites without a triangle. */
  public Optional<Solution> solution() {
    return solution;
  }

  /** What keeps the polygon from being simple, or the sites from having a triangle. */
  public List<Defect> defects() {
    return defects;
  }

  /** The picture. */
  public Scene scene() {
    return scene;
  }
}
