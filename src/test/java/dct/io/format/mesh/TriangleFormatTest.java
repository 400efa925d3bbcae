package dct.io.format.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.PointFile;
import dct.io.format.Columns;
import dct.io.format.Drawing;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Triangle's files, and what is written for meshes; a slash stands for a line break. */
class TriangleFormatTest {
  private static final String NODES = "4 2 1 1/0 0 0 7 1/1 9 0 7 1/2 9 9 7 1/3 0 9 7 1/";

  private static Shapes read(String text) {
    byte[] bytes = text.replace('/', '\n').getBytes(StandardCharsets.UTF_8);
    try {
      return PointFile.shapes("in", new ByteArrayInputStream(bytes), Columns.TOLD_BY_CONTENT);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "# x/3 2 0 0/1 0 0/2 1 0/3 0 1/ | 3 sites",
        "3 2 0 0/0 0 0/1 1 0/2 0 1/3 0/0 0 1/1 1 2/2 2 0/0/ | ring of 3 vertices",
        "7 2 0 0/0 0 0/1 9 0/2 9 9/3 0 9/4 2 2/5 3 2/6 3 3/7 1/1 0 1/2 1 2/3 2 3/4 3 0/5 4 5/6 5 6"
            + "/7 6 4/1/1 2.8 2.3/ | ring of 4 vertices; hole of 3 vertices",
      })
  void forms(String text, String shapes) {
    List<String> found = read(text).shapes().stream().map(Shape::description).toList();
    assertThat(String.join("; ", found)).isEqualTo(shapes);
  }

  @Test
  void what_is_left_out_is_said() {
    assertThat(read(NODES + "2 0/0 0 1/1 1 2/0/").notes())
        .containsExactly(
            "Attributes and markers of the vertices are left out",
            "4 vertices are on no ring, left out",
            "2 segments that are no part of a ring are left out");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "9 2 0 0/0 1 1/ | 2: the file ends after 1 of 9 vertices; correct the count, or fetch the"
            + " file again if it was cut off",
        "0 2 0 0/3 0/ | 1: the vertices stand in a file .node of the same name; open that, or put"
            + " them in here",
        "2 2 0 0/0 1 1/2 3 3/ | 3: the vertices are not numbered in turn from 0 or 1 on; number"
            + " them so",
        "2 2 0 0/0 1 x/1 3 3/ | 2: \"x\" is not a finite number; correct it",
        "1 2 0 0/0 1 1/1 0/0 0 5/ | 4: there is no vertex 5; correct the segment",
      })
  void faults(String text, String sentence) {
    assertThatThrownBy(() -> read(text))
        .isInstanceOf(BadInputException.class)
        .hasMessage("in:" + sentence);
  }

  @Test
  void what_is_written_is_read_with_every_bit() throws IOException {
    Random random = new Random(6);
    for (int round = 0; round < 200; round++) {
      double[] pairs = new double[6 + 2 * random.nextInt(20)];
      Arrays.setAll(pairs, i -> Math.scalb(random.nextDouble() - 0.5, random.nextInt(200) - 100));
      Points points = Points.ofPairs(pairs);
      for (Domain domain : Domain.applications()) {
        for (FileEnding ending : List.of(FileEnding.POLY, FileEnding.OFF, FileEnding.OBJ)) {
          ByteArrayOutputStream out = new ByteArrayOutputStream();
          DataFile.write(out, ending, Drawing.of("x", domain, points), Progress.NONE);
          Shapes read = read(out.toString(StandardCharsets.UTF_8));
          assertThat(read.shapes()).hasSize(1);
          assertThat(read.shapes().get(0).points()).isEqualTo(points);
          assertThat(read.shapes().get(0).domain().orElse(domain)).isEqualTo(domain);
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        NODES + "4 1/0 0 1 1/1 1 2 1/2 2 3 1/3 3 0 1/1/0 4 4/",
        "3 2 0 0/0 0 0/1 1 0/2 0 1/3 0/0 0 1/1 1 2/2 2 0/0/",
      })
  void cut_or_changed_texts_are_refused_in_a_sentence(String text) {
    for (int end = 1; end < text.length(); end++) {
      tried(text.substring(0, end));
    }
    Random random = new Random(7);
    for (int round = 0; round < 3000; round++) {
      StringBuilder changed = new StringBuilder(text);
      String signs = "0123456789 /-.#fvx\u00e4";
      for (int k = 0; k <= random.nextInt(3); k++) {
        changed.setCharAt(
            random.nextInt(changed.length()), signs.charAt(random.nextInt(signs.length())));
      }
      tried(changed.toString());
    }
  }

  private static void tried(String text) {
    try {
      assertThat(read(text).shapes()).isNotEmpty();
    } catch (BadInputException e) {
      assertThat(e.getMessage()).as(text).startsWith("in:").contains("; ").doesNotContain("\n");
    }
  }
}
