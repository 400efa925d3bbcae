package dct.ui;

import dct.core.Progress;
import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;

/** The triangulations of polygons that have a button. */
enum PolygonMethod {
  CONVEX_EVEN(
      "Convex Polygon Even Triangulation",
      "shift E",
      "Cuts the polygon into convex pieces and makes most vertices of each even"),
  CONVEX_ODD(
      "Convex Polygon Odd Triangulation",
      "shift O",
      "Cuts the polygon into convex pieces and makes most vertices of each odd"),
  MONOTONE(
      "Monotone Polygon Triangulation",
      "shift M",
      "Cuts the polygon into monotone pieces and triangulates each");

  private final String title;
  private final String key;
  private final String description;

  PolygonMethod(String title, String key, String description) {
    this.title = title;
    this.key = key;
    this.description = description;
  }

  String title() {
    return title;
  }

  String key() {
    return key;
  }

  String description() {
    return description;
  }

  Triangulation triangulate(SimplePolygon polygon, Progress progress) {
    return switch (this) {
      case CONVEX_EVEN -> PartitioningAqt.triangulate(polygon, progress);
      case CONVEX_ODD -> OddFan.triangulate(polygon, progress);
      case MONOTONE -> MonotoneTriangulation.triangulate(polygon, progress);
    };
  }
}
