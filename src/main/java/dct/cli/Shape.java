package dct.cli;

import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Domain;
import dct.io.BadInputException;
import dct.io.PointDocument;

/**
 * An input that has been found to be usable: a simple polygon, or sites not all on one line.
 *
 * @param polygon the polygon, or null if these are sites
 * @param sites the sites, or null if this is a polygon
 */
record Shape(SimplePolygon polygon, Sites sites) {

  /**
   * Checks a document; one that does not say what it is has to be a polygon.
   *
   * @throws BadInputException if it is not usable
   */
  static Shape of(PointDocument document) {
    if (document.declared().orElse(Domain.POLYGON) == Domain.SITES) {
      return new Shape(null, document.sitesNotOnOneLine());
    }
    try {
      return new Shape(document.polygon(), null);
    } catch (BadInputException e) {
      throw document.declared().isEmpty() && couldBeSites(document) ? withHint(e) : e;
    }
  }

  private static boolean couldBeSites(PointDocument document) {
    try {
      document.sitesNotOnOneLine();
      return true;
    } catch (BadInputException e) {
      return false;
    }
  }

  private static BadInputException withHint(BadInputException e) {
    return new BadInputException(
        e.file(), e.line(), e.fault() + ", or read the file as sites with --as points");
  }

  Domain domain() {
    return polygon == null ? Domain.SITES : Domain.POLYGON;
  }

  int merged() {
    return polygon == null ? sites.merged() : 0;
  }
}
