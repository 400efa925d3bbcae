package dct.ui.document;

import dct.core.Progress;
import dct.core.degree.FlipResult;
import dct.core.degree.Optimum;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.geometry.SimplicityCheck;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
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
  private final Optional<Triangulation> triangulation;
  private final List<Defect> defects; // the first is the one to name
  private final Scene scene;
  private final boolean growing; // of a polygon: the last edge is still provisional
  private final boolean pending;

  private Analysis(
      Document document,
      Optional<Triangulation> triangulation,
      List<Defect> defects,
      Scene scene,
      boolean growing,
      boolean pending) {
    this.document = document;
    this.triangulation = triangulation;
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

  private static List<Defect> defects(Points points, Progress progress) {
    List<Defect> defects = new ArrayList<>();
    SimplicityCheck.firstDefect(points, progress)
        .ifPresent(
            first -> {
              defects.add(first);
              defects.addAll(Crossings.of(points));
            });
    return List.copyOf(defects);
  }

  private static Analysis sites(Document document, Progress progress) {
    if (document.size() < 3) {
      return untriangulated(document, false);
    }
    Triangulation delaunay = Delaunay.triangulate(Sites.of(document.points(), progress), progress);
    return sites(document, delaunay, Scene.of(delaunay));
  }

  private static Analysis sites(Document document, Triangulation triangulation, Scene scene) {
    return new Analysis(document, Optional.of(triangulation), List.of(), scene, false, false);
  }

  /** This analysis with the triangulation of the sites after flips. */
  public Analysis flipped(FlipResult result) {
    return sites(document, result.after(), Scene.of(result));
  }

  /** This analysis with the best triangulation of the sites that was found. */
  public Analysis optimized(Optimum best) {
    return sites(document, best.triangulation(), Scene.of(best));
  }

  /** Whether this is a whole analysis of these points, wherever it was made. */
  boolean isOf(Points points) {
    return !pending && document.points().equals(points);
  }

  /** This analysis with other wishes; what was said of the old ones is no longer shown. */
  Analysis wishing(ParityGoal wishes) {
    return new Analysis(
        document.with(wishes), triangulation, defects, scene.withoutVerdict(), growing, pending);
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

  /** The triangulation of the sites; nothing for a polygon, or for fewer than three sites. */
  public Optional<Triangulation> triangulation() {
    return triangulation;
  }

  /** What keeps the polygon from being simple. */
  public List<Defect> defects() {
    return defects;
  }

  /** The picture. */
  public Scene scene() {
    return scene;
  }
}
