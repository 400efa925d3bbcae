package dct.ui.session;

import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.ui.document.Document;
import dct.ui.document.Layout;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How the vertices of a polygon hang together, as lines of a journal: the rings, each a word of
 * runs of successive numbers, and the ends of the fixed edges. The length grows with the number of
 * runs, not with that of vertices.
 */
final class LayoutText {
  private static final String RINGS = "rings";
  private static final String FIXED = "fixed";
  private static final String EMPTY = "-";

  private LayoutText() {}

  /** The lines; of a plain layout one without rings. */
  static String of(Document document) {
    if (document.layout().isPlain()) {
      return RINGS + "\n";
    }
    Rings rings = document.rings();
    StringBuilder text = new StringBuilder(RINGS);
    for (int r = 0; r < rings.count(); r++) {
      text.append(' ');
      runs(text, rings.ring(r));
    }
    boolean begun = rings.ringVertices() > 0 && document.layout().openSize(document.size()) == 0;
    text.append(begun ? " " + EMPTY : "");
    text.append('\n').append(FIXED);
    for (int j = 0; j < rings.fixedCount(); j++) {
      text.append(' ').append(rings.fixedFrom(j)).append('-').append(rings.fixedTo(j));
    }
    return text.append('\n').toString();
  }

  private static void runs(StringBuilder text, int[] ring) {
    text.append(ring.length == 0 ? EMPTY : "");
    for (int k = 0; k < ring.length; ) {
      int first = k++;
      while (k < ring.length && ring[k] == ring[k - 1] + 1) {
        k++;
      }
      text.append(first == 0 ? "" : ",").append(ring[first]).append('-').append(ring[k - 1]);
    }
  }

  /**
   * The layout of these points that the lines say; a plain one without lines.
   *
   * @throws IllegalArgumentException if they say none
   */
  static Layout parse(List<String> lines, Points points) {
    List<int[]> rings = new ArrayList<>();
    int[] fixed = new int[0];
    for (String line : lines) {
      String[] words = line.split(" ");
      if (RINGS.equals(words[0])) {
        Arrays.stream(words).skip(1).map(LayoutText::ring).forEach(rings::add);
      } else if (FIXED.equals(words[0])) {
        fixed = Arrays.stream(words).skip(1).flatMapToInt(LayoutText::ends).toArray();
      } else {
        throw new IllegalArgumentException("this is no line of a journal");
      }
    }
    if (rings.isEmpty()) {
      return Layout.PLAIN;
    }
    int last = rings.size() - 1;
    boolean begun = last > 0 && rings.get(last).length == 0; // a hole that has no vertices yet
    Layout drawn = Layout.of(Rings.of(points, begun ? rings.subList(0, last) : rings, fixed));
    return begun ? drawn.withHole(points.size()) : drawn;
  }

  private static int[] ring(String word) {
    if (EMPTY.equals(word)) {
      return new int[0];
    }
    return Arrays.stream(word.split(","))
        .flatMapToInt(
            run -> {
              int[] ends = ends(run).toArray();
              return IntStream.rangeClosed(ends[0], ends[1]);
            })
        .toArray();
  }

  /** The two numbers of a word as 3-7. */
  private static IntStream ends(String word) {
    String[] numbers = word.split("-", -1);
    if (numbers.length != 2) {
      throw new IllegalArgumentException("this is no pair of vertices");
    }
    return Arrays.stream(numbers).mapToInt(Integer::parseInt);
  }
}
