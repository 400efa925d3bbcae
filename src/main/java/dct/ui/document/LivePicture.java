package dct.ui.document;

import dct.core.geometry.Points;
import dct.core.triangulate.MovingSite;
import java.util.Optional;

/**
 * The picture of sites of which one is elsewhere than when they were analysed: right at once,
 * however many there are. Their triangulation, as the program numbers its edges and decides among
 * cocircular sites, is left to an analysis in the background.
 */
final class LivePicture {
  private Analysis base; // null before the first
  private Optional<MovingSite> moving = Optional.empty(); // of the base; the one asked for last
  private int site = Points.NONE; // which one that is

  /** Takes note of an analysis, which replaces that before unless it is itself such a picture. */
  void note(Analysis analysis) {
    if (analysis.isWhole() && analysis != base) {
      base = analysis;
      site = Points.NONE;
      moving = Optional.empty();
    }
  }

  /** Forgets all analyses. */
  void forget() {
    base = null;
    site = Points.NONE;
    moving = Optional.empty();
  }

  /** The document with its picture, if at most one site is elsewhere than in the last analysis. */
  Optional<Analysis> of(Document document) {
    if (base == null || base.document().size() != document.size()) {
      return Optional.empty();
    }
    if (base.isOf(document)) {
      return Optional.of(base.with(document));
    }
    int other = base.document().points().onlyDifference(document.points());
    return other < 0 ? Optional.empty() : moved(document, other);
  }

  private Optional<Analysis> moved(Document document, int other) {
    if (other != site) {
      site = other;
      moving = base.moving(other);
    }
    Points points = document.points();
    return moving.map(m -> base.moved(document, m.to(points.x(other), points.y(other))));
  }
}
