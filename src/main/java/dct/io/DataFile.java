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
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** Points and triangulations in the formats of other programs. */
public final class DataFile {
  private static final Map<FileEnding, Format> FORMATS = formats();

  /** What people call a format, and what writes it. */
  private record Format(String title, DrawingWriter writer) {}

  private DataFile() {}

  private static Map<FileEnding, Format> formats() {
    Map<FileEnding, Format> all = new EnumMap<>(FileEnding.class);
    all.put(FileEnding.WKT, new Format("Well-known text", WktWriter::write));
    all.put(FileEnding.GEOJSON, new Format("GeoJSON", GeoJsonWriter::write));
    all.put(FileEnding.NODE, new Format("Triangle: vertices", TriangleWriter::writeNode));
    all.put(FileEnding.POLY, new Format("Triangle: outline", TriangleWriter::writePoly));
    all.put(FileEnding.ELE, new Format("Triangle: triangles", TriangleWriter::writeEle));
    all.put(FileEnding.EDGE, new Format("Triangle: edges", TriangleWriter::writeEdge));
    all.put(FileEnding.OFF, new Format("Object File Format", MeshWriter::writeOff));
    all.put(FileEnding.OBJ, new Format("Wavefront object", MeshWriter::writeObj));
    all.put(FileEnding.INSTANCE, new Format("CG:SHOP 2026 instance", CgShopWriter::writeInstance));
    all.put(FileEnding.SOLUTION, new Format("CG:SHOP 2026 flips", CgShopWriter::writeSolution));
    return all;
  }

  /** The endings of these formats. */
  public static List<FileEnding> endings() {
    return List.copyOf(FORMATS.keySet());
  }

  /** What people call the format of one of these endings. */
  public static String title(FileEnding ending) {
    return FORMATS.get(ending).title;
  }

  /**
   * The files that writing makes: beside triangles or edges the vertices that they number, in a
   * {@code .node} of the same name.
   */
  public static List<Path> files(Path file, FileEnding ending) {
    return needsVertices(ending) ? List.of(file, FileEnding.NODE.insteadOf(file)) : List.of(file);
  }

  /** Whether the format only numbers the vertices, and another file has to hold them. */
  public static boolean needsVertices(FileEnding ending) {
    return ending == FileEnding.ELE || ending == FileEnding.EDGE;
  }

  /** Whether it is the ending of such a format; the program's own are none. */
  public static boolean isOf(FileEnding ending) {
    return FORMATS.containsKey(ending);
  }

  /**
   * Writes {@link #files}, each whole or not at all.
   *
   * @return the files that were written
   * @throws CannotWriteException if the format cannot hold it, or writing failed; nothing is
   *     changed then
   * @throws java.util.concurrent.CancellationException if cancelled; nothing is changed then
   */
  public static List<Path> write(Path file, FileEnding ending, Drawing drawing, Progress progress)
      throws CannotWriteException {
    List<Path> files = files(file, ending);
    writeOne(file, ending, drawing, progress);
    for (Path vertices : files.subList(1, files.size())) {
      writeOne(vertices, FileEnding.NODE, drawing, progress);
    }
    return files;
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
    FORMATS.get(ending).writer.write(drawing, text);
    text.flush();
  }
}
