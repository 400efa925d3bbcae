package dct.ui.random;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.Area;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.SiteShape;
import dct.ui.shell.ProgramCall;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Which random sites or polygon to make.
 *
 * @param domain sites or a polygon
 * @param n how many vertices
 * @param shape one of those of the domain
 * @param seed which of the random ones
 * @param area where they lie; nothing for as much as so many need
 * @param real whether the coordinates may be other than whole numbers
 */
public record RandomPlan(
    Domain domain, int n, Shape shape, long seed, Optional<Area> area, boolean real) {

  /**
   * A family of random points.
   *
   * @param word its name on the command line
   * @param title its name in the window
   * @param description what is made, in a few words
   */
  record Shape(String word, String title, String description) {
    @Override
    public String toString() {
      return title;
    }
  }

  /** The shapes that there are; the first is the usual one. */
  static List<Shape> shapes(Domain domain) {
    return domain == Domain.SITES
        ? Arrays.stream(SiteShape.values())
            .map(s -> new Shape(s.word(), s.title(), s.description()))
            .toList()
        : Arrays.stream(PolygonShape.values())
            .map(s -> new Shape(s.word(), s.title(), s.description()))
            .toList();
  }

  /**
   * Makes them.
   *
   * @throws dct.experiment.generate.CannotGenerateException if there are none, or none were found
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  Points generate(Progress progress) {
    if (domain == Domain.SITES) {
      SiteShape of = SiteShape.of(shape.word()).orElseThrow();
      return of.generate(n, area(of.areaFor(n)), seed, progress);
    }
    PolygonShape of = PolygonShape.of(shape.word()).orElseThrow();
    return of.generate(n, area(of.areaFor(n)), seed, progress).points();
  }

  private Area area(Area ample) {
    Area chosen = area.orElse(ample);
    return real ? chosen.real() : chosen;
  }

  /** The call of the program that makes the same. */
  ProgramCall call() {
    ProgramCall call = ProgramCall.generate(domain, n, shape.word(), seed);
    if (area.isPresent()) {
      call = call.area(area.get().width(), area.get().height());
    }
    return real ? call.real() : call;
  }

  /** What it is, for the status line. */
  String words() {
    return shape.title() + ", " + n + " " + domain.vertices() + ", seed " + seed;
  }
}
