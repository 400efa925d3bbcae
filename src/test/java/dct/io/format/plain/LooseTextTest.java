package dct.io.format.plain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.geometry.Points;
import dct.io.format.Columns;
import dct.io.format.Input;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Text as people and programs write it. */
class LooseTextTest {
  private static final Points SQUARE = Points.ofPairs(0, 0, 10.5, 0, 10.5, -10, 0, -10);

  private static Shapes read(String text, Columns columns) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return new PlainFormat()
        .read(new Input("in", new ByteArrayInputStream(bytes), Optional.empty(), columns));
  }

  private static Shapes read(String text) throws IOException {
    return read(text, Columns.TOLD_BY_CONTENT);
  }

  private static Columns columns(int x, int y, int skipped) {
    return new Columns(Optional.of(new Columns.Pair(x, y)), skipped);
  }

  private static void refuses(String text, String sentence) {
    assertThatThrownBy(() -> read(text))
        .as(text)
        .isInstanceOf(BadInputException.class)
        .hasMessage("in:" + sentence);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0 0\n10.5 0\n10.5 -10\n0 -10\n",
        "0,0\n10.5,0\n10.5,-10\n0,-10\n",
        "0;0;\n10.5;0;\n10.5;-10;\n0;-10;\n",
        "0\t0\r\n10.5\t0\r\n10.5\t-10\r\n0\t-10\r\n",
        "(0, 0)\n(10.5, 0)\n(10.5, -10)\n(0, -10)\n",
        "(0, 0) (10.5, 0), (10.5, -10); (0, -10)",
        "[\n(0, 0),\n(10.5, 0),\n(10.5, -10),\n(0, -10)\n]\n",
        "{0, 0},\n{10.5, 0},\n{10.5, -10},\n{0, -10},\n",
        "[0 0]\n[10.5 0]\n[10.5 -10]\n[0 -10]\n",
        "\"0\",\"0\"\n\"10.5\",\"0\"\n\"10.5\",\"-10\"\n\"0\",\"-10\"\n",
        "'0' '0'\n'10.5' '0'\n'10.5' '-10'\n'0' '-10'\n",
        "0.D0 0d0\n1.05D+01 0.0\n0.105d2 -1D1\n0 -1.0D+01\n",
        "0\u00A00\n10.5\u20090\n10.5\u202F\u221210\n0\u3000\u201310\n",
        "x y\n0 0\n10.5 0\n10.5 -10\n0 -10\n",
        "\"X\";\"Y\"\n0;0\n10.5;0\n10.5;-10\n0;-10\n",
        "lat,lon\n0,0\n0,10.5\n-10,10.5\n-10,0\n",
        "id,name x,X (m),Y (m)\n7,1,0,0\n3,1,10.5,0\n9,1,10.5,-10\n1,1,0,-10\n",
        "0 0 5\n10.5 0 5\n10.5 -10 6\n0 -10 6\n",
        "1 0 0\n2 10.5 0\n3 10.5 -10\n4 0 -10\n",
        "0,0,0,5\n1,10.5,0,5\n2,10.5,-10,6\n3,0,-10,6\n",
        "% a\n0 0 % b\n! c\n10.5 0 ! d\n// e\n10.5 -10 // f\n; g\n0 -10 # h\n",
        "sep=;\n0;0\n10.5;0\n10.5;-10\n0;-10\n",
        "0 0 10.5 0 10.5 -10 0 -10\n",
      })
  void a_square(String text) throws IOException {
    Shapes shapes = read(text);
    assertThat(shapes.shapes()).hasSize(1);
    assertThat(shapes.shapes().get(0).points()).isEqualTo(SQUARE);
  }

  @Test
  void what_is_left_out_is_said() throws IOException {
    assertThat(read("0 0 5\n1 0.5 5\n1 1 5\n").notes())
        .containsExactly("The column of z behind x and y is left out");
    assertThat(read("1 0.5 5\n2 0 1\n").notes())
        .containsExactly("The first column numbers the rows and is left out");
    assertThat(read("a,b\n0,1\n").notes()).containsExactly("The header row is left out");
    assertThat(read("id,y,x\n7,0,1\n").notes())
        .containsExactly("The header row names x (x) and y (y), 1 other column is left out");
    assertThat(read("sep=,\n0,1\n").notes())
        .containsExactly("The line that names Excel's separator is left out");
    assertThat(read("0 0\n1 0\n").notes()).isEmpty();
  }

  @Test
  void two_readings_are_refused_and_columns_decide() throws IOException {
    String three = "1 4 4\n2 6 4\n3 6 7\n";
    refuses(
        three,
        "1: the three columns can be a number of the row, x and y (--columns 2,3), or x, y and z"
            + " (--columns 1,2); keep those of x and y, or give --columns X,Y");
    refuses(
        "1 2 3 4 5\n2 3 4 5 7\n",
        "1: of the 5 columns any two can be x and y; keep those of x and y, or give --columns X,Y");
    assertThat(points(read(three, columns(2, 3, 0)))).isEqualTo(Points.ofPairs(4, 4, 6, 4, 6, 7));
    assertThat(points(read(three, columns(1, 2, 1)))).isEqualTo(Points.ofPairs(2, 6, 3, 6));
    assertThat(points(read("0 1\n2 3\n", columns(2, 1, 0)))).isEqualTo(Points.ofPairs(1, 0, 3, 2));
    assertThatThrownBy(() -> read("0 1\n", columns(1, 3, 0)))
        .hasMessage("in:1: there are only 2 columns; give --columns with two of them");
    String pandas = "0,1\n0.5,1.5\n1.5,2.5\n";
    refuses(
        pandas,
        "1: this looks like a header that numbers the columns; remove the line, give --skip 1, or"
            + " write 0.0 1.0 if it is a vertex");
    assertThat(points(read(pandas, new Columns(Optional.empty(), 1))))
        .isEqualTo(Points.ofPairs(0.5, 1.5, 1.5, 2.5));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "1,000 2,000\n",
        "1,5;2,5\n",
        "1\u2009000 2\n",
        "1 2 x\n",
        "(1, 2\n",
        "(1, 2) 3\n",
        "x = (1, 2)\n",
        "(1, 2, 3), (4, 5)\n",
        "1,,2\n",
        "[1e999, 2]\n",
        "\"1 2\n",
        "double p[][2] = {\n{0, 0}\n};\n",
      })
  void other_lines_are_refused(String text) {
    assertThatThrownBy(() -> read(text)).isInstanceOf(BadInputException.class);
  }

  @Test
  void signs_of_the_mapping_tools_part_rings() throws IOException {
    Shapes shapes = read("> a\n0 0\n1 0\n1 1\n>\n5 5\n6 5\n6 6\n5 6\n");
    assertThat(shapes.shapes()).extracting(shape -> shape.points().size()).containsExactly(3, 4);
    assertThat(shapes.shapes())
        .extracting(Shape::description)
        .containsExactly("3 points", "4 points");
  }

  /** The same points in forms chosen at random give the same points. */
  @Test
  void random_forms_are_read_alike() throws IOException {
    long seed = 12;
    Random random = new Random(seed);
    for (int round = 0; round < 2000; round++) {
      List<double[]> pairs = new ArrayList<>();
      String text = text(random, pairs);
      Points expected = Points.ofPairs(pairs.stream().flatMapToDouble(Arrays::stream).toArray());
      assertThat(points(read(text)))
          .as("seed %d, round %d:%n%s", seed, round, text)
          .isEqualTo(expected);
    }
  }

  private static String text(Random random, List<double[]> pairs) {
    String[] open = {"", "(", "[", "{", ""};
    String[] close = {"", ")", "]", "}", ""};
    String[] separators = {" ", ", ", "\t", "; ", ",", "  ", " \u00A0"};
    int bracket = random.nextInt(open.length);
    String separator = separators[random.nextInt(separators.length)];
    boolean numbered = random.nextBoolean();
    boolean header = random.nextBoolean();
    StringBuilder text = new StringBuilder(header ? (numbered ? "id,x,y\n" : "x,y\n") : "");
    int n = 3 + random.nextInt(5);
    for (int i = 0; i < n; i++) {
      double x = Math.rint(random.nextGaussian() * 1e4) / 100 + 0.001;
      double y = random.nextGaussian() * 1e3;
      pairs.add(new double[] {x, y});
      text.append(open[bracket]);
      text.append(numbered ? (i + 1) + separator : "");
      text.append(number(random, x)).append(separator).append(number(random, y));
      text.append(close[bracket]).append(random.nextInt(3) == 0 ? " # comment\n" : "\n");
    }
    return text.toString();
  }

  private static String number(Random random, double value) {
    return switch (random.nextInt(4)) {
      case 0 -> Double.toString(value).replace('E', 'D');
      case 1 -> Double.toString(value).replace('-', '\u2212').replace("E\u2212", "E-");
      case 2 -> String.format(Locale.ROOT, "%.17e", value);
      default -> Double.toString(value);
    };
  }

  private static Points points(Shapes shapes) {
    assertThat(shapes.shapes()).hasSize(1);
    return shapes.shapes().get(0).points();
  }
}
