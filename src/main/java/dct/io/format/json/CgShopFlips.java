package dct.io.format.json;

import dct.io.format.Input;
import dct.io.format.Shape;
import dct.io.format.StoredFaces;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The flips of a solution of CG:SHOP 2026: for each triangulation of its instance a list of steps,
 * each a list of edges that are flipped at once. They are taken one after the other.
 */
final class CgShopFlips {
  private final JsonScanner scanner;
  private final List<List<int[]>> flips; // of each triangulation, the ends of the edges in turn

  private CgShopFlips(JsonScanner scanner, List<List<int[]>> flips) {
    this.scanner = scanner;
    this.flips = flips;
  }

  /** Reads them: {@code [[[[u, v], …], …], …]}. */
  static CgShopFlips read(JsonScanner scanner) throws IOException {
    List<List<int[]>> all = new ArrayList<>();
    scanner.json.beginArray();
    while (scanner.json.hasNext()) {
      List<int[]> ofOne = new ArrayList<>();
      scanner.json.beginArray();
      while (scanner.json.hasNext()) {
        scanner.json.beginArray();
        while (scanner.json.hasNext()) {
          ofOne.add(edge(scanner));
        }
        scanner.json.endArray();
      }
      scanner.json.endArray();
      all.add(ofOne);
    }
    scanner.json.endArray();
    return new CgShopFlips(scanner, all);
  }

  private static int[] edge(JsonScanner scanner) throws IOException {
    double[] ends = scanner.numbers();
    if (ends.length != 2 || ends[0] != (int) ends[0] || ends[1] != (int) ends[1]) {
      throw scanner.fault("a flip is not the edge [u, v]; write two numbers of points");
    }
    return new int[] {(int) ends[0], (int) ends[1]};
  }

  /** The file of the instance beside that of its solution, if it is there. */
  static Optional<Path> instanceBeside(Input solution, String instance) {
    if (solution.file().isEmpty() || !instance.matches("[\\w][\\w.-]*")) {
      return Optional.empty();
    }
    Path file = solution.file().get();
    String own = file.getFileName().toString().replaceFirst("solution", "instance");
    return Stream.of(own, instance + ".json", instance + ".instance.json")
        .map(file::resolveSibling)
        .filter(beside -> !beside.equals(file) && Files.isRegularFile(beside))
        .findFirst();
  }

  /**
   * The triangulations of the instance, each with its flips.
   *
   * @throws dct.io.text.BadInputException if there are not as many
   */
  List<Shape> appliedTo(List<Shape> instance) {
    List<Shape> triangulated = instance.stream().filter(s -> s.faces().isPresent()).toList();
    if (triangulated.size() != flips.size()) {
      throw scanner.fault(
          "there are flips for "
              + flips.size()
              + " triangulations, but the instance has "
              + triangulated.size()
              + "; put the right instance beside the solution");
    }
    List<Shape> shapes = new ArrayList<>();
    for (int t = 0; t < flips.size(); t++) {
      Shape shape = triangulated.get(t);
      List<int[]> edges = flips.get(t);
      Optional<StoredFaces> faces = shape.faces().map(stored -> stored.flipped(edges));
      shapes.add(new Shape(shape.kind(), shape.label(), shape.points(), shape.lines(), faces));
    }
    return shapes;
  }
}
