package dct.io;

import dct.core.Progress;
import dct.io.format.CannotHold;
import dct.io.format.Drawing;
import dct.io.format.DrawingWriter;
import dct.io.format.TextOut;
import dct.io.format.json.CgShopWriter;
import dct.io.format.json.GeoJsonWriter;
import dct.io.format.mesh.MeshWriter;
import dct.io.format.mesh.TriangleWriter;
import dct.io.format.wkt.WktWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** Points and triangulations in the formats of other programs. */
public final class DataFile {
  private static final Map<FileEnding, DrawingWriter> WRITERS =
      Map.of(
          FileEnding.WKT, WktWriter::write,
          FileEnding.GEOJSON, GeoJsonWriter::write,
          FileEnding.NODE, TriangleWriter::writeNode,
          FileEnding.POLY, TriangleWriter::writePoly,
          FileEnding.ELE, TriangleWriter::writeEle,
          FileEnding.EDGE, TriangleWriter::writeEdge,
          FileEnding.OFF, MeshWriter::writeOff,
          FileEnding.OBJ, MeshWriter::writeObj,
          FileEnding.INSTANCE, CgShopWriter::writeInstance,
          FileEnding.SOLUTION, CgShopWriter::writeSolution);

  private DataFile() {}

  /** Whether it is the ending of such a format; the program's own are none. */
  public static boolean isOf(FileEnding ending) {
    return WRITERS.containsKey(ending);
  }

  /**
   * Writes a file, whole or not at all; beside triangles or edges the vertices that they number,
   * too, in a {@code .node} of the same name.
   *
   * @return the files that were written
   * @throws CannotWriteException if the format cannot hold it, or writing failed; nothing is
   *     changed then
   * @throws java.util.concurrent.CancellationException if cancelled; nothing is changed then
   */
  public static List<Path> write(Path file, FileEnding ending, Drawing drawing, Progress progress)
      throws CannotWriteException {
    writeOne(file, ending, drawing, progress);
    if (ending != FileEnding.ELE && ending != FileEnding.EDGE) {
      return List.of(file);
    }
    Path vertices = FileEnding.NODE.insteadOf(file);
    writeOne(vertices, FileEnding.NODE, drawing, progress);
    return List.of(file, vertices);
  }

  private static void writeOne(Path file, FileEnding ending, Drawing drawing, Progress progress)
      throws CannotWriteException {
    AtomicFile.write(
        file,
        progress,
        out -> {
          try {
            write(out, ending, drawing, progress);
          } catch (CannotHold e) {
            throw new CannotWriteException(file.toString(), e);
          }
        });
  }

  /**
   * Writes to a stream.
   *
   * @throws CannotHold if the format cannot hold it; nothing is written then
   */
  public static void write(OutputStream out, FileEnding ending, Drawing drawing, Progress progress)
      throws IOException {
    TextOut text = new TextOut(out, progress);
    WRITERS.get(ending).write(drawing, text);
    text.flush();
  }
}
