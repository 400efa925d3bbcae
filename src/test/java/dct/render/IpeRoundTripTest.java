package dct.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.PointFile;
import dct.io.format.Columns;
import dct.io.format.Shape;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A figure that was written for Ipe is read as the points that it shows, and as nothing else. */
class IpeRoundTripTest {
  private static final Pattern NUMBER = Pattern.compile("(?<![\\w#.])-?[0-9]+\\.[0-9]+(?![\\w.])");

  @TempDir Path folder;

  private static Solution solution(Domain domain, Points points) {
    Instance instance = Instance.of(domain, "of it", points, Progress.NONE);
    Method method = domain == Domain.SITES ? Method.DELAUNAY : Method.CONVEX_EVEN;
    return Solution.of(instance, method, Progress.NONE).flipped(Progress.NONE);
  }

  private static Points sites(double offset) {
    double[] pairs = new Random(7).doubles(80).map(x -> offset + 1000 * x).toArray();
    return Points.ofPairs(pairs);
  }

  private static Points star(double offset) {
    Random random = new Random(8);
    double[] pairs = new double[60];
    for (int i = 0; i < pairs.length; i += 2) {
      double radius = 50 + 50 * random.nextDouble();
      pairs[i] = offset + radius * Math.cos(i * Math.PI / 30);
      pairs[i + 1] = offset + radius * Math.sin(i * Math.PI / 30);
    }
    return Points.ofPairs(pairs);
  }

  private String written(Solution solution, Figure figure) throws IOException {
    Path file = folder.resolve("figure.ipe");
    PictureFile.write(Scene.of(solution), figure, "it", file, Progress.NONE);
    return Files.readString(file);
  }

  private static List<Shape> read(String file) throws IOException {
    byte[] bytes = file.getBytes(StandardCharsets.UTF_8);
    return PointFile.shapes("f.ipe", new ByteArrayInputStream(bytes), Columns.TOLD_BY_CONTENT)
        .shapes();
  }

  private static void assertIsRead(String file, Shape.Kind kind, Points points) throws IOException {
    List<Shape> shapes = read(file);
    assertThat(shapes).extracting(Shape::kind).containsExactly(kind);
    assertThat(shapes.get(0).points()).isEqualTo(points);
  }

  @ParameterizedTest
  @EnumSource(Theme.class)
  void everything_but_the_points_is_passed_over(Theme theme) throws IOException {
    Figure figure =
        Figure.DEFAULT.withTheme(theme).withLegend(true).withLabels(new Labels(true, true, true));
    for (double offset : new double[] {0, 5e6}) {
      Points polygon = star(offset);
      assertIsRead(written(solution(Domain.POLYGON, polygon), figure), Shape.Kind.RING, polygon);
      Points sites = sites(offset);
      assertIsRead(
          written(solution(Domain.SITES, sites), figure.withYUp(true)), Shape.Kind.SITES, sites);
    }
  }

  /** Ipe keeps some six digits of each number, whether or not anything was changed. */
  @Test
  void what_ipe_has_saved_is_read_to_its_digits() throws IOException {
    Points sites = sites(0);
    String file = written(solution(Domain.SITES, sites), Figure.DEFAULT);
    int page = file.indexOf("<page>");
    Matcher numbers = NUMBER.matcher(file.substring(page));
    String saved = file.substring(0, page) + numbers.replaceAll(IpeRoundTripTest::rounded);
    assertThat(saved).isNotEqualTo(file);
    List<Shape> shapes = read(saved);
    assertThat(shapes).hasSize(1);
    Points points = shapes.get(0).points();
    assertThat(points.size()).isEqualTo(sites.size());
    for (int v = 0; v < sites.size(); v++) {
      assertThat(points.x(v)).isCloseTo(sites.x(v), within(0.01));
      assertThat(points.y(v)).isCloseTo(sites.y(v), within(0.01));
    }
  }

  private static String rounded(MatchResult number) {
    return String.format(Locale.ROOT, "%.6g", Double.parseDouble(number.group()));
  }

  @Test
  void what_was_moved_or_added_in_ipe_is_read_where_it_is_now() throws IOException {
    Points sites = Points.ofPairs(0, 0, 1000, 0, 1000, 500, 0, 500, 400, 300);
    String file = written(solution(Domain.SITES, sites), Figure.DEFAULT);
    Matcher matrix =
        Pattern.compile("keywords=\"dct-points ([^ ]+) 0 0 [^ ]+ ([^ ]+) ").matcher(file);
    assertThat(matrix.find()).isTrue();
    double scale = Double.parseDouble(matrix.group(1));
    double left = Double.parseDouble(matrix.group(2));
    int last = file.lastIndexOf("<use layer=\"vertices");
    String moved =
        file.substring(0, last)
            + file.substring(last)
                .replaceFirst(" " + Pattern.quote(matrix.group(2)), " " + (left + 50 * scale))
                .replace("</page>", "<path layer=\"mine\">0 0 m 9 0 l 9 9 l h</path></page>");
    List<Shape> shapes = read(moved);
    assertThat(shapes).extracting(Shape::kind).containsExactly(Shape.Kind.SITES, Shape.Kind.RING);
    Points points = shapes.get(0).points();
    assertThat(points.x(3)).isZero();
    assertThat(points.x(4)).isCloseTo(450, within(1e-6));
    assertThat(points.y(4)).isCloseTo(300, within(1e-6));
  }
}
