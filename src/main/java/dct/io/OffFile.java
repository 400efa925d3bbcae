package dct.io;

import dct.core.Decimals;
import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Triangulation;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/**
 * Triangulations in the Object File Format of Geomview, which mesh programs read: the vertices in
 * the user's order with z = 0, then the triangles.
 */
public final class OffFile {
  private OffFile() {}

  /**
   * Writes the vertices and triangles, whole or not at all.
   *
   * @throws CannotWriteException if writing failed; nothing is changed then
   */
  public static void write(Path file, Triangulation triangulation, Progress progress)
      throws CannotWriteException {
    AtomicFile.write(
        file, progress, out -> write(out, triangulation.points(), triangulation.triangles()));
  }

  /**
   * Writes points with no faces, whole or not at all.
   *
   * @throws CannotWriteException if writing failed; nothing is changed then
   */
  public static void write(Path file, Points points, Progress progress)
      throws CannotWriteException {
    AtomicFile.write(file, progress, out -> write(out, points, new int[0]));
  }

  private static void write(OutputStream out, Points points, int[] triangles) throws IOException {
    Writer writer = new OutputStreamWriter(out, StandardCharsets.US_ASCII);
    writer.write("OFF\n" + points.size() + " " + triangles.length / 3 + " 0\n");
    for (int v = 0; v < points.size(); v++) {
      writer.write(Decimals.format(points.x(v)) + " " + Decimals.format(points.y(v)) + " 0\n");
    }
    for (int t = 0; t < triangles.length; t += 3) {
      writer.write("3 " + triangles[t] + " " + triangles[t + 1] + " " + triangles[t + 2] + "\n");
    }
    writer.flush();
  }
}
