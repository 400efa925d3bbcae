package dct.io.format.drawing;

import static dct.io.format.drawing.Drawn.read;
import static dct.io.format.drawing.Drawn.refuses;
import static dct.io.format.drawing.Drawn.said;
import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Decimals;
import dct.core.geometry.Points;
import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is read of the files and selections of Ipe, and what is left out or refused. */
class IpeFormatTest {

  /** As Ipe 7.2 saves a page with a polygon, a spline, marks and a group. */
  private static final String FILE =
      """
      <?xml version="1.0"?>
      <!DOCTYPE ipe SYSTEM "ipe.dtd">
      <ipe version="70218" creator="Ipe 7.2.26">
      <info created="D:20230101120000" modified="D:20230101120100"/>
      <ipestyle name="basic">
      <symbol name="mark/disk(sx)" transformations="translations">
      <path fill="sym-stroke">
      1 0 0 1 0 0 e
      </path>
      </symbol>
      <symbol name="arrow/normal(spx)"><path>0 0 m -1 0.333 l -1 -0.333 l h</path></symbol>
      </ipestyle>
      <page>
      <layer name="alpha"/>
      <layer name="beta"/>
      <view layers="alpha beta" active="beta"/>
      <path layer="alpha" matrix="1 0 0 1 16 -8" stroke="black">
      64 704 m
      128.5 704 l
      128.5 640 l
      64 640 l
      h
      </path>
      <path stroke="black">
      0 0 m
      9 0 9 9 0 9 c
      h
      </path>
      <use layer="beta" name="mark/disk(sx)" pos="80 160" size="normal" stroke="black"/>
      <use matrix="1 0 0 1 0 16" name="mark/circle(sx)" pos="96 176" size="normal" stroke="black"/>
      <group matrix="2 0 0 2 0 0">
      <use name="mark/box(sx)" pos="1 2"/>
      <text pos="1 2" type="label">a &lt; b</text>
      </group>
      </page>
      <page>
      <layer name="alpha"/>
      <path>
      0 0 m
      5 0 l
      5 5 l
      0 0 l
      </path>
      </page>
      </ipe>
      """;

  @Test
  void a_file_is_read_by_page_and_layer() throws IOException {
    assertThat(said(FILE))
        .isEqualTo(
            """
            ring alpha: 80 696, 144.5 696, 144.5 632, 80 632
            sites beta: 80 160, 96 192, 2 4
            ring page 2, alpha: 0 0, 5 0, 5 5
            1 curved path is left out
            1 text is left out\
            """);
    assertThat(read(FILE).shapes().get(0).lines()).containsExactly(18, 19, 20, 21);
    assertThat(new IpeFormat().yUp()).isTrue();
  }

  private static String selection(String content) {
    return "<ipeselection pos=\"0 0\">\n" + content + "</ipeselection>\n";
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<path layer='a'>0 0 m 1 0 l 1 1 l h</path> | ring a: 0 0, 1 0, 1 1",
        "<path>0 0 m 1 0 l 1 1 l</path> | path: 0 0, 1 0, 1 1",
        "<path>0 0 m 9 0 l 9 9 l h 2 1 m 3 1 l 3 2 l h</path> |"
            + " ring: 0 0, 9 0, 9 9 / ring: 2 1, 3 1, 3 2",
        "<path>0 0 m 9 0 l 9 9 l h 2 1 m 3 1 4 4 q 1 0 0 1 2 2 e 1 2 3 4 5 6 u</path> | ring: 0 0,"
            + " 9 0, 9 9 / 2 curved paths are left out / 1 circle or ellipse is left out",
        "<group matrix='0 1 -1 0 0 0'><path matrix='1 0 0 1 5 0'>0 0 m 1 0 l 1 1 l h</path></group>"
            + " | ring: 0 5, 0 6, -1 6",
        "<use name='mark/disk(sx)' pos='1 2'/><use name='mark/fdisk(sfx)' pos='3 4'/>"
            + "<use name='Background'/><image/> |"
            + " sites: 1 2, 3 4 / 1 image is left out / 1 symbol that is no mark is left out",
        "<use name='mark/disk(sx)' pos='1 2' layer='a'/><use name='mark/disk(sx)' pos='3 4'"
            + " layer='b'/> | sites a: 1 2 / sites b: 3 4",
        "<use name='mark/disk(sx)'/><use name='mark/disk(sx)' pos='100 0'/> | sites: 0 0, 100 0",
        "<path>1 0 0 1 50 50 e</path><path>1 0 0 1 90 70 e</path> | sites: 50 50, 90 70",
      })
  void a_selection_is_read(String content, String shapes) throws IOException {
    assertThat(said(selection(content)).replace("\n", " / ")).isEqualTo(shapes);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<path>0 0 l</path> | l in the path is not preceded by m; add it",
        "<path>0 m</path> | m in the path needs 2 numbers, not 1; correct it",
        "<path>0 0 m 1 2 3 l</path> | l in the path needs 2 numbers, not 3; correct it",
        "<path>0 0 m 1 x2 l</path> | \"x2\" in the path is not a number; correct it",
        "<path>0 0 m 1 2 z</path> | \"z\" in the path is no operator of Ipe; correct it",
        "<path>0 0 m 1 2</path> |"
            + " the path ends without an operator behind its numbers; complete it",
        "<path>0 0 m 1e400 2 l</path> |"
            + " a point is beyond the range of double numbers; scale the drawing down",
        "<path matrix='1 2 3'>0 0 m</path> |"
            + " matrix in the attribute matrix has not as many numbers as it needs; correct it",
        "<use name='mark/disk(sx)' pos='1'/> |"
            + " a number is missing at the end of the attribute pos; add it",
      })
  void what_is_wrong_is_said_with_its_line(String content, String sentence) {
    refuses(selection(content), "2: " + sentence);
  }

  @Test
  void nothing_to_read_is_said() {
    refuses(
        selection("<path>0 0 m 1 0 l</path><path>0 0 m 9 0 9 9 0 9 c h</path>"),
        " this is Ipe without a polygon or path of straight edges (only 1 curved path, 1 line of"
            + " fewer than 3 vertices); draw one with 3 vertices or more");
  }

  @Test
  void damage_is_read_or_refused_in_a_sentence() throws IOException {
    Drawn.survivesDamage(FILE, 2);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void every_double_is_read_as_it_was_written(long seed) throws IOException {
    Random random = new Random(seed);
    double[] x = new double[3 + random.nextInt(200)];
    double[] y = new double[x.length];
    StringBuilder path = new StringBuilder("<path>\n");
    StringBuilder marks = new StringBuilder();
    for (int v = 0; v < x.length; v++) {
      x[v] = random.nextGaussian() * Math.pow(10, random.nextInt(30) - 15);
      y[v] = random.nextGaussian() * Math.pow(10, random.nextInt(600) - 300);
      String place = Decimals.format(x[v]) + " " + Decimals.format(y[v]);
      path.append(place).append(v == 0 ? " m\n" : " l\n");
      marks.append("<use name=\"mark/disk(sx)\" pos=\"").append(place).append("\"/>\n");
    }
    assertThat(read(selection(path + "h\n</path>\n" + marks)).shapes())
        .hasSize(2)
        .allSatisfy(shape -> assertThat(shape.points()).isEqualTo(Points.of(x, y)));
  }

  @Test
  void a_line_of_ten_million_characters_is_read() throws IOException {
    int n = 1_000_000;
    StringBuilder path = new StringBuilder(12 * n).append("0 0 m ");
    for (int v = 1; v < n; v++) {
      path.append(1000 + v % 1000).append(' ').append(1000 + v % 7).append(" l ");
    }
    assertThat(path.length()).isGreaterThan(10_000_000);
    String text = selection("<path>" + path + "h</path>");
    assertThat(read(text).shapes().get(0).points().size()).isEqualTo(n);
  }
}
