package dct.io.format.mesh;

import dct.io.format.Input;
import dct.io.format.Rows;
import dct.io.text.BadInputException;
import dct.io.text.PlainText;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The file in which the vertices of a file of triangles or edges stand: beside it, with the same
 * name and the ending {@code .node} or {@code .poly}.
 */
final class NodeFile {
  private static final Pattern ENDING = Pattern.compile("(?i)(\\.[a-z]+)?(\\.gz)?$");

  private NodeFile() {}

  /**
   * Reads the vertices.
   *
   * @param input the file of triangles or edges
   * @param things what it holds
   * @param rows its rows, for messages
   * @param notes hears what is left out
   */
  static NodeList read(Input input, String things, Rows rows, List<String> notes)
      throws IOException {
    Path file =
        input
            .file()
            .orElseThrow(
                () ->
                    rows.fault(
                        "the vertices of the "
                            + things
                            + " stand in a file .node; give the name of the file beside it, not its"
                            + " text"));
    Path beside =
        Stream.of(".node", ".node.gz", ".poly", ".poly.gz")
            .map(ending -> sibling(file, ending))
            .filter(Files::isRegularFile)
            .findFirst()
            .orElseThrow(
                () ->
                    rows.fault(
                        "the vertices of the "
                            + things
                            + " stand in "
                            + sibling(file, ".node").getFileName()
                            + ", and there is no such file beside this one; put it there"));
    try (InputStream in = Files.newInputStream(beside)) {
      String name = beside.toString();
      Rows lines = new Rows(Input.of(name, PlainText.of(name, in)));
      lines.next(0, 1, "counts");
      if (lines.count(1) != 2) {
        throw new BadInputException(
            name, lines.line(), "the vertices are not of the plane; give two coordinates each");
      }
      NodeList nodes = NodeList.read(lines);
      if (nodes.hasMore()) {
        notes.add("Attributes and markers of the vertices are left out");
      }
      return nodes;
    }
  }

  private static Path sibling(Path file, String ending) {
    String name = file.getFileName().toString();
    return file.resolveSibling(ENDING.matcher(name).replaceFirst("") + ending);
  }
}
