package dct.ui.random;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.experiment.generate.Area;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RegionShape;
import dct.experiment.generate.SiteShape;
import dct.ui.document.Document;
import dct.ui.shell.ProgramCall;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Which random sites, polygon or region to make.
 *
 * @param domain sites, a polygon or a region
 * @param n how many vertices
 * @param shape one of those of the domain
 * @param seed which of the random ones
 * @param area where they lie; nothing for as much as so many need
 * @param real whether the coordinates may be other than whole numbers
 * @param holes how many holes; of a region only
 */
public record RandomPlan(
    Domain domain, int n, Shape shape, long seed, Optional<Area> area, boolean real, int holes) {

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
    return switch (domain) {
      case SITES ->
          Arrays.stream(SiteShape.values())
              .map(s -> new Shape(s.word(), s.title(), s.description()))
              .toList();
      case POLYGON ->
          Arrays.stream(PolygonShape.values())
              .map(s -> new Shape(s.word(), s.title(), s.description()))
              .toList();
      case REGION ->
          Arrays.stream(RegionShape.values())
              .map(s -> new Shape(s.word(), s.title(), s.description()))
              .toList();
    };
  }

  /**
   * Makes them, every vertex wished even.
   *
   * @throws dct.experiment.generate.CannotGenerateException if there are none, or none were found
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  Document generate(Progress progress) {
    return switch (domain) {
      case SITES -> {
        SiteShape of = SiteShape.of(shape.word()).orElseThrow();
        yield new Document(domain, of.generate(n, area(of.areaFor(n)), seed, progress));
      }
      case POLYGON -> {
        PolygonShape of = PolygonShape.of(shape.word()).orElseThrow();
        yield new Document(domain, of.generate(n, area(of.areaFor(n)), seed, progress).points());
      }
      case REGION -> {
        RegionShape of = RegionShape.of(shape.word()).orElseThrow();
        yield Document.of(of.generate(n, holes, seed, progress).rings());
      }
    };
  }

  private Area area(Area ample) {
    Area chosen = area.orElse(ample);
    return real ? chosen.real() : chosen;
  }

  /** The call of the program that makes the same. */
  ProgramCall call() {
    ProgramCall call = ProgramCall.generate(domain, n, shape.word(), seed);
    if (domain == Domain.REGION) {
      return call.holes(holes);
    }
    if (area.isPresent()) {
      call = call.area(area.get().width(), area.get().height());
    }
    return real ? call.real() : call;
  }

  /** What it is, for the status line. */
  String words() {
    String of = domain == Domain.REGION ? ", " + holes + (holes == 1 ? " hole" : " holes") : "";
    return shape.title() + ", " + n + " " + domain.vertices() + of + ", seed " + seed;
  }
}
