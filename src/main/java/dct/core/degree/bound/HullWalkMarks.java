package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.Mark.Tone;
import dct.core.degree.colour.HullRing;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Explains the bound of {@link HullWalkBound}: a cheapest walk round the hull is drawn. */
final class HullWalkMarks {
  private HullWalkMarks() {}

  /**
   * The explanation.
   *
   * @param least what was found of the closed walks
   */
  static Explanation of(HullRing ring, HullWalkBound.Least least, int bound) {
    List<Mark> marks = new ArrayList<>();
    least.route().ifPresent(route -> draw(marks, route));
    List<String> sentences = new ArrayList<>();
    sentences.add(
        "Every hull edge is a side of one triangle. At a hull site the triangles from the one on"
            + " the edge before it to the one on the edge after it are a fan of triangles without a"
            + " site inside; how many there are decides whether its degree is even. Fans at"
            + " different sites may even overlap.");
    sentences.add(
        String.format(
            Locale.ROOT,
            "All closed walks round the %d hull edges were looked at, with every such fan%s: each"
                + " misses %s or more.%s",
            ring.size(),
            least.isColoured()
                ? " whose triangles can be coloured black and white so that neighbours differ, and"
                    + " black less white hull edges is a multiple of 3, as it must be where all"
                    + " sites inside are even"
                : "",
            wishes(least.cost()),
            least.route().isPresent()
                ? " One that misses no more is drawn, with these marked."
                : ""));
    if (least.isColoured() && ring.interior() > 0) {
      sentences.add(
          String.format(
              Locale.ROOT,
              "Or a site inside is not even: then the colours need not agree, the walk misses %s or"
                  + " more, and the site inside one more.",
              wishes(least.plain())));
    } else if (least.plusInside()) {
      sentences.add(
          "Where all sites inside are even the colours must agree, too, and a walk misses more; or"
              + " else a site inside misses its wish. Either way there is one more.");
    }
    sentences.add(
        String.format(
            Locale.ROOT,
            "Every triangulation gives such a walk, so that at least %s missed.",
            bound == 1 ? "1 wish is" : bound + " wishes are"));
    return new Explanation("Round the hull not all wishes can be granted", sentences, marks);
  }

  private static String wishes(int count) {
    return count == 1 ? "1 wish" : count + " wishes";
  }

  private static void draw(List<Mark> marks, HullRoute route) {
    for (HullRoute.Triangle t : route.triangles()) {
      Tone tone = !route.isColoured() ? Tone.MAIN : t.colour() == 0 ? Tone.BLACK : Tone.WHITE;
      marks.add(new Mark.Area(List.of(t.a(), t.b(), t.c()), tone));
    }
    for (int v : route.missed()) {
      marks.add(new Mark.Vertex(v, Tone.FAULT, ""));
    }
  }

  /** Explains the bound of the strips: the straight sides with sites inside are drawn. */
  static Explanation ofStrips(HullRing ring, int bound) {
    List<Mark> marks = new ArrayList<>();
    for (int k = 0; k < ring.size(); k++) {
      if (ring.isFlat(k) || ring.isFlat(k + 1)) {
        marks.add(new Mark.Segment(ring.site(k), ring.site(k + 1), Tone.MAIN));
      }
    }
    return new Explanation(
        "Along the sides of the hull not all wishes can be granted",
        List.of(
            "At a site inside a side of the hull the triangles from the one on the edge before it"
                + " to the one on the edge after it are a fan of triangles without a site inside;"
                + " how many there are decides whether its degree is even.",
            String.format(
                Locale.ROOT,
                "All walks along the sides, with every such fan, were looked at. Together they miss"
                    + " %s or more.",
                wishes(bound))),
        marks);
  }
}
