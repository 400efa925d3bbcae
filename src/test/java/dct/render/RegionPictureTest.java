package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.io.FileEnding;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.testing.RandomRegions;
import dct.testing.RandomSets;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** A picture of a region, or of a polygon, as SVG or for Ipe is read as what it shows. */
class RegionPictureTest {
  private static final List<Figure> FIGURES =
      List.of(
          Figure.DEFAULT,
          Figure.DEFAULT.withYUp(true).withTheme(Theme.DARK),
          Figure.DEFAULT.withLegend(true).withLabels(new Labels(true, true, true)));

  private static String written(Scene scene, Figure figure, FileEnding ending) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PictureFile.write(scene, figure, "it", ending, out, Progress.NONE);
    return out.toString(StandardCharsets.UTF_8);
  }

  private static PointDocument read(String file) throws IOException {
    byte[] bytes = file.getBytes(StandardCharsets.UTF_8);
    return PointFile.read("in", new ByteArrayInputStream(bytes));
  }

  private static Solution made(Instance instance) {
    return Solution.of(instance, Method.CONVEX_EVEN, Progress.NONE).flipped(Progress.NONE);
  }

  /** Two holes, a site, and fixed edges from it and between two vertices of the outline. */
  private static final Rings PLATE =
      Rings.of(
          Points.ofPairs(
              0, 0, 96, 0, 128, 64, 96, 80, 0, 80, 16, 16, 40, 16, 16, 40, 80, 40, 64, 56, 64, 24,
              24, 60.125),
          List.of(new int[] {0, 1, 2, 3, 4}, new int[] {5, 6, 7}, new int[] {8, 9, 10}),
          4,
          11,
          1,
          3);

  /** The sides of rings and the fixed edges, by the numbers that the vertices have in others. */
  private static Set<String> sides(Rings rings, int... numbers) {
    Set<String> sides = new TreeSet<>();
    for (int v = 0; v < numbers.length; v++) {
      if (rings.isOnRing(v)) {
        boolean isOuter = rings.ringOf(v) == 0;
        sides.add((isOuter ? "outer " : "hole ") + side(numbers[v], numbers[rings.after(v)]));
      }
    }
    for (int j = 0; j < rings.fixedCount(); j++) {
      sides.add("fixed " + side(numbers[rings.fixedFrom(j)], numbers[rings.fixedTo(j)]));
    }
    return sides;
  }

  private static String side(int u, int v) {
    return Math.min(u, v) + " " + Math.max(u, v);
  }

  private static Box box(Rings rings) {
    return Box.of(rings.points());
  }

  /**
   * The vertex of the original that each one is: that at its place, if both boxes are laid on each
   * other, with y turned if so asked.
   */
  private static int[] numbers(Rings read, Rings original, boolean isTurned, double within) {
    Box box = box(read);
    Box whole = box(original);
    double scale = (box.maxX() - box.minX()) / (whole.maxX() - whole.minX());
    int[] numbers = new int[read.points().size()];
    for (int v = 0; v < numbers.length; v++) {
      double x = read.points().x(v) - box.minX();
      double y = isTurned ? box.maxY() - read.points().y(v) : read.points().y(v) - box.minY();
      numbers[v] =
          IntStream.range(0, original.points().size())
              .filter(
                  w ->
                      Math.abs((original.points().x(w) - whole.minX()) * scale - x) <= within
                          && Math.abs((original.points().y(w) - whole.minY()) * scale - y)
                              <= within)
              .findFirst()
              .orElseThrow();
    }
    return numbers;
  }

  private static void assertShows(
      PointDocument read, Rings original, boolean isTurned, double within) {
    assertThat(read.domain()).isEqualTo(Domain.REGION);
    Rings rings = read.rings().orElseThrow();
    assertThat(rings.points().size()).isEqualTo(original.points().size());
    int[] all = IntStream.range(0, rings.points().size()).toArray();
    assertThat(sides(rings, numbers(rings, original, isTurned, within)))
        .isEqualTo(sides(original, all));
    assertThat(read.notes()).noneMatch(note -> note.contains("mark") || note.contains("edge"));
  }

  private static List<Scene> scenes(Rings rings) {
    Instance region = Instance.of("it", rings, Progress.NONE);
    return List.of(Scene.outline(rings, false, List.of()), Scene.of(made(region)));
  }

  @Test
  void ipeHoldsARegionExactly() throws IOException {
    for (Figure figure : FIGURES) {
      for (Scene scene : scenes(PLATE)) {
        assertShows(read(written(scene, figure, FileEnding.IPE)), PLATE, false, 0);
      }
    }
  }

  /** The coordinates are those of the picture, with two digits each. */
  @Test
  void svgHoldsARegionAsItIsOnThePage() throws IOException {
    for (int k = 0; k < FIGURES.size(); k++) {
      for (Scene scene : scenes(PLATE)) {
        assertShows(read(written(scene, FIGURES.get(k), FileEnding.SVG)), PLATE, k == 1, 0.02);
      }
    }
  }

  @Test
  void randomRegionsAreReadBack() throws IOException {
    int readBack = 0;
    for (int seed = 0; seed < 20; seed++) {
      RandomSets.Family family = RandomSets.families().get(seed % RandomSets.families().size());
      Rings rings =
          RandomRegions.region(family, 5 + seed, 1 + seed % 3, 2 * (seed % 3), seed).rings();
      if (rings.fixedCount() == 0 && rings.count() > 1) {
        readBack++;
        Scene scene = Scene.outline(rings, false, List.of());
        assertShows(read(written(scene, Figure.DEFAULT, FileEnding.IPE)), rings, false, 0);
      }
    }
    assertThat(readBack).isPositive();
  }

  /** The marks at its vertices are no shapes of their own, neither discs nor squares. */
  @Test
  void aPolygonIsReadAlone() throws IOException {
    Points star = PolygonShape.STAR_SHAPED.generate(24, 3).points();
    Instance polygon = Instance.of(Domain.POLYGON, "it", star, Progress.NONE);
    for (FileEnding ending : List.of(FileEnding.SVG, FileEnding.IPE)) {
      for (Scene scene :
          List.of(Scene.of(made(polygon)), Scene.outline(Rings.ofChain(star), false, List.of()))) {
        PointDocument read = read(written(scene, FIGURES.get(2), ending));
        assertThat(read.rings()).isEmpty();
        assertThat(read.instance(Progress.NONE).size()).isEqualTo(24);
      }
    }
  }

  /** A vertex of the outline has moved on the page, its mark has not; there is one site more. */
  @Test
  void ofRingsThatWereMovedTheMarksAreNoSites() throws IOException {
    String file = written(Scene.outline(PLATE, false, List.of()), Figure.DEFAULT, FileEnding.IPE);
    String moved = file.replaceFirst("\n96 0 l", "\n96 1 l");
    assertThat(moved).isNotEqualTo(file);
    PointDocument read = read(moved);
    assertThat(read.points().size()).isEqualTo(11);
    assertThat(read.notes())
        .contains("2 marks that are at no vertex of a ring left out")
        .contains("2 fixed edges between no vertices left out");
  }
}
