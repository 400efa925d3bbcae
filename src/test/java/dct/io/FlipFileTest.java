package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.Flip;
import dct.core.degree.FlipList;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Points;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FlipFileTest {
  @TempDir private Path folder;

  private static FlipFile read(String text, int n) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return FlipFile.read("flips.txt", new ByteArrayInputStream(bytes), n);
  }

  private static Triangulation delaunay(Points points) {
    return Delaunay.triangulate(Sites.of(points, Progress.NONE), Progress.NONE);
  }

  @Test
  void what_is_written_is_read() throws Exception {
    FlipList list = FlipList.of(ScanFlip.run(delaunay(RandomSites.uniform(500, 3)), Progress.NONE));
    Path file = folder.resolve("flips.txt");
    FlipFile.write(file, list, Progress.NONE);
    assertThat(list.size()).isGreaterThan(50);
    assertThat(FlipFile.read(file, 500, Progress.NONE).list()).isEqualTo(list);
    assertThat(Files.readString(file)).startsWith("# flips: the edge removed -> the edge made\nv");
  }

  @Test
  void blanks_and_comments_are_skipped() throws IOException {
    FlipFile file = read("\uFEFF# a list\n\n v0  v2->v1\tv3 # the first\r\nv4 v2 -> v1 v3", 5);
    assertThat(file.list().flips()).containsExactly(new Flip(0, 2, 1, 3), new Flip(4, 2, 1, 3));
    assertThat(file.line(0)).isEqualTo(3);
    assertThat(file.line(1)).isEqualTo(4);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "v0 v2 v1 v3 | 2: \"v0 v2 v1 v3\" is no flip; FORM",
        "0 2 -> 1 3 | 2: \"0 2 -> 1 3\" is no flip; FORM",
        "v0 v2 -> v1 | 2: \"v0 v2 -> v1\" is no flip; FORM",
        "v0 v2 -> v1 v1 | 2: a flip has four different vertices; FORM",
        "v0 v9 -> v1 v3 | 2: there is no vertex v9, the last one is v4; apply the flips to the"
            + " points that they were made for",
        "v0 v99999999999 -> v1 v3 | 2: \"v0 v99999999999 -> v1 v3\" is no flip; FORM",
        "# v0 v2 -> v1 v3 |  there is no flip in the file; FORM",
      })
  void names_what_is_wrong(String line, String message) {
    assertThatThrownBy(() -> read("\n" + line, 5))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "flips.txt:"
                + (message.startsWith("2") ? "" : " ")
                + message.replace(
                    "FORM", "write the edge removed and the edge made, v0 v2 -> v1 v3"));
  }

  @Test
  void where_not_even_the_first_flip_is_possible_none_is_offered_to_be_kept() throws IOException {
    Triangulation square = delaunay(Points.ofPairs(0, 0, 4, 0, 4, 4, 0, 3));
    FlipFile file = read("v0 v2 -> v1 v3\n", 4);
    assertThat(file.refusal(file.list().applyTo(square, Progress.NONE)))
        .startsWith("flips.txt:1: ")
        .endsWith("apply the flips to the triangulation that they were made for");
  }

  @Test
  void the_first_impossible_flip_is_named_with_its_line() throws IOException {
    Triangulation square = delaunay(Points.ofPairs(0, 0, 4, 0, 4, 4, 0, 3));
    FlipFile file = read("v1 v3 -> v0 v2\n\nv1 v3 -> v0 v2\n", 4);
    FlipList.Applied applied = file.list().applyTo(square, Progress.NONE);
    assertThat(applied.result().flips()).isEqualTo(1);
    assertThat(file.refusal(applied))
        .isEqualTo(
            "flips.txt:3: there is no edge v1–v3 here; apply the flips to the triangulation that"
                + " they were made for, or keep the 1 flip before");
    assertThat(file.list().flips()).isEqualTo(List.of(new Flip(1, 3, 0, 2), new Flip(1, 3, 0, 2)));
  }
}
