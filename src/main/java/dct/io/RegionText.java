package dct.io;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.io.format.TextOut;
import dct.io.format.plain.VertexText;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Arrays;

/**
 * Writes a region as text: its rings, the holes behind lines {@code hole}, its sites behind a line
 * {@code sites}, then a line {@code fixed i j} for each fixed edge. Where the vertices are not in
 * this order already they get other numbers. Linear.
 */
final class RegionText {
  private final Rings rings;
  private final TextOut text;
  private final int[] number; // by vertex: that in the text
  private int written;

  private RegionText(OutputStream out, Rings rings, Progress progress) {
    this.rings = rings;
    this.text = new TextOut(out, progress);
    this.number = new int[rings.points().size()];
    Arrays.fill(number, Points.NONE);
  }

  static void write(OutputStream out, Rings rings, Progress progress) throws IOException {
    new RegionText(out, rings, progress).write();
  }

  private void write() throws IOException {
    text.add(VertexText.kindLine(Domain.REGION)).add("\n");
    for (int r = 0; r < rings.count(); r++) {
      text.add(r == 0 ? "" : "hole\n");
      for (int k = 0; k < rings.size(r); k++) {
        vertex(rings.vertex(r, k));
      }
    }
    text.add(written < number.length ? "sites\n" : "");
    for (int v = 0; v < number.length; v++) {
      if (!rings.isOnRing(v)) {
        vertex(v);
      }
    }
    for (int j = 0; j < rings.fixedCount(); j++) {
      text.add("fixed ").add(number[rings.fixedFrom(j)]);
      text.add(" ").add(number[rings.fixedTo(j)]).add("\n");
    }
    text.flush();
  }

  private void vertex(int v) throws IOException {
    text.tick(written, number.length);
    number[v] = written++;
    text.add(rings.points().x(v)).add(" ").add(rings.points().y(v)).add("\n");
  }
}
