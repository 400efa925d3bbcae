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
  private final boolean pending;

  private Analysis(
      Document document,
      Optional<Triangulation> triangulation,
      List<Defect> defects,
      Scene scene,
      boolean pending) {
    this.document = document;
    this.triangulation = triangulation;
    this.defects = defects;
    this.scene = scene.withWishes(document.wishes());
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
        ? polygon(document, growing)
        : sites(document, progress);
  }

  /** The bare points of a document that is still to be analysed. */
  static Analysis pending(Document document, boolean growing) {
    Points points = document.points();
    Scene scene =
        document.domain() == Domain.POLYGON
            ? Scene.polygon(points, growing, List.of())
            : Scene.sites(points);
    return new Analysis(document, Optional.empty(), List.of(), scene, true);
  }

  private static Analysis polygon(Document document, boolean growing) {
    Points points = document.points();
    List<Defect> defects = defects(points);
    return new Analysis(
        document, Optional.empty(), defects, Scene.polygon(points, growing, defects), false);
  }

  private static List<Defect> defects(Points points) {
    List<Defect> defects = new ArrayList<>();
    SimplicityCheck.firstDefect(points)
        .ifPresent(
            first -> {
              defects.add(first);
              defects.addAll(Crossings.of(points));
            });
    return List.copyOf(defects);
  }

  private static Analysis sites(Document document, Progress progress) {
    if (document.size() < 3) {
      Scene scene = Scene.sites(document.points());
      return new Analysis(document, Optional.empty(), List.of(), scene, false);
    }
    Triangulation delaunay = Delaunay.triangulate(Sites.of(document.points()), progress);
    return sites(document, delaunay, Scene.of(delaunay));
  }

  private static Analysis sites(Document document, Triangulation triangulation, Scene scene) {
    return new Analysis(document, Optional.of(triangulation), List.of(), scene, false);
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
    Scene plain = triangulation.map(Scene::of).orElse(scene);
    return new Analysis(document.with(wishes), triangulation, defects, plain, pending);
  }

  /** The same of a polygon that is, or is no longer, being drawn. */
  public Analysis growing(boolean growing) {
    if (document.domain() != Domain.POLYGON) {
      return this;
    }
    return new Analysis(
        document,
        triangulation,
        defects,
        Scene.polygon(document.points(), growing, defects),
        pending);
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
