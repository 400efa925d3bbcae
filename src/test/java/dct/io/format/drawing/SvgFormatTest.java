package dct.io.format.drawing;

import static dct.io.format.drawing.Drawn.read;
import static dct.io.format.drawing.Drawn.refuses;
import static dct.io.format.drawing.Drawn.said;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Decimals;
import dct.core.geometry.Points;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is read of SVG, and what is left out or refused. */
class SvgFormatTest {
  private static final String OPEN = "<svg xmlns=\"http://www.w3.org/2000/svg\">";

  private static String svg(String content) {
    return OPEN + content + "</svg>";
  }

  /** As Inkscape saves a drawing of two layers. */
  private static final String INKSCAPE =
      """
      <?xml version="1.0" encoding="UTF-8" standalone="no"?>
      <!-- Created with Inkscape (http://www.inkscape.org/) -->
      <svg width="210mm" height="297mm" viewBox="0 0 210 297" version="1.1" id="svg8"
         xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
         xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"
         xmlns="http://www.w3.org/2000/svg" xmlns:svg="http://www.w3.org/2000/svg">
        <title>Two lakes</title>
        <sodipodi:namedview id="base"><inkscape:grid type="xygrid" id="grid1" /></sodipodi:namedview>
        <defs id="defs2"><marker id="arrow"><path d="M 0,0 5,-5 -12,0 z" /></marker></defs>
        <g inkscape:groupmode="layer" id="layer1" inkscape:label="Lakes" transform="translate(10,20)">
          <path style="fill:none" d="m 10.1,0.2 20.3,0 0,10.1 -20.3,0 0,-10.1 z" id="path1" />
          <path d="M 0,0 H 10 V 10 H 0 Z m 2,2 v 6 h 6 v -6 z" id="rect7" inkscape:label="square" />
          <path d="M 0,0 C 1,1 2,2 3,0 Z" id="path2" />
          <text x="1" y="2"><tspan>A lake</tspan></text>
        </g>
        <g inkscape:groupmode="layer" id="layer2" style="display:none"><rect width="9" height="9"/></g>
      </svg>
      """;

  @Test
  void a_drawing_of_inkscape_is_read_with_its_labels() throws IOException {
    assertThat(said(INKSCAPE))
        .isEqualTo(
            """
            ring path1: 20.1 20.2, 40.4 20.2, 40.4 30.3, 20.1 30.3, 20.1 20.2
            ring square: 10 20, 20 20, 20 30, 10 30
            ring square: 12 22, 12 28, 18 28, 18 22
            1 curved path is left out
            1 text is left out
            1 shape in definitions is left out
            1 hidden element is left out\
            """);
  }

  @Test
  void y_grows_downwards() {
    assertThat(new SvgFormat().yUp()).isFalse();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<polygon points='0,0 10,0 10,10'/> | ring: 0 0, 10 0, 10 10",
        "<polygon points=' 0 0,10-0 ,10.5.5 '/> | ring: 0 0, 10 0, 10.5 0.5",
        "<polygon points='0,0 10,0 10,10 0,0'/> | ring: 0 0, 10 0, 10 10, 0 0",
        "<polyline points='0,0 10,0 10,10'/> | path: 0 0, 10 0, 10 10",
        "<polyline points='0,0 10,0 10,10 0,0'/> | ring: 0 0, 10 0, 10 10",
        "<rect x='1' y='2px' width='10' height='20'/> | ring: 1 2, 11 2, 11 22, 1 22",
        "<path d='M0 0L10 0 10 10z'/> | ring: 0 0, 10 0, 10 10",
        "<path d='M0 0 10 0 10 10'/> | path: 0 0, 10 0, 10 10",
        "<path d='m5,5h10v10h-10z'/> | ring: 5 5, 15 5, 15 15, 5 15",
        "<path d='m5 5 10 0 0 10-10 0V5z'/> | ring: 5 5, 15 5, 15 15, 5 15, 5 5",
        "<path d='M.1.1l.2 0l.3 1l-.5-1z'/> | ring: 0.1 0.1, 0.3 0.1, 0.6 1.1, 0.1 0.1",
        "<path d='M1e1-2E+0L+3,4 5e-1 6M9 9'/> | path: 10 -2, 3 4, 0.5 6",
        "<path d=''/><path/><path d='none'/><rect width='1' height='1'/> | ring: 0 0, 1 0, 1 1, 0"
            + " 1",
      })
  void edges_that_are_straight_are_read(String content, String shape) throws IOException {
    assertThat(said(svg(content))).isEqualTo(shape);
  }

  @Test
  void a_subpath_may_go_on_where_the_last_one_closed() throws IOException {
    assertThat(said(svg("<path d='m1 1 2 0 0 2zl-2 0 0-2z'/>")))
        .isEqualTo("ring: 1 1, 3 1, 3 3\nring: 1 1, -1 1, -1 -1");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "matrix(1 0 0 -1 0 100) | 0 100, 10 100, 10 90",
        "translate(5) | 5 0, 15 0, 15 10",
        "translate(5, -5) | 5 -5, 15 -5, 15 5",
        "scale(2) | 0 0, 20 0, 20 20",
        "scale(2,3) | 0 0, 20 0, 20 30",
        "rotate(90) | 0 0, 0 10, -10 10",
        "rotate(-450) | 0 0, 0 -10, 10 -10",
        "rotate(180 5 5) | 10 10, 0 10, 0 0",
        "translate(1,2) scale(2) | 1 2, 21 2, 21 22",
        "scale(2),translate(1,2) | 2 4, 22 4, 22 24",
        "none | 0 0, 10 0, 10 10",
        "'' | 0 0, 10 0, 10 10",
      })
  void a_transform_is_applied(String transform, String points) throws IOException {
    String polygon = "<polygon points='0,0 10,0 10,10' transform='" + transform + "'/>";
    assertThat(said(svg(polygon))).isEqualTo("ring: " + points);
    String group = "<g transform='" + transform + "'><polygon points='0,0 10,0 10,10'/></g>";
    assertThat(said(svg(group))).isEqualTo("ring: " + points);
  }

  @Test
  void a_skew_and_a_turn_agree_with_their_matrices() throws IOException {
    Points skewed =
        read(svg("<polygon transform='skewX(45)skewY(30)rotate(30)' points='0,0 1,0 0,1'/>"))
            .shapes()
            .get(0)
            .points();
    double tan = Math.tan(Math.PI / 6);
    double cos = Math.cos(Math.PI / 6);
    double y = tan * cos + 0.5;
    assertThat(skewed.y(1)).isCloseTo(y, within(1e-15));
    assertThat(skewed.x(1)).isCloseTo(cos + y, within(1e-15));
  }

  @Test
  void transforms_of_groups_are_applied_from_the_inside_out() throws IOException {
    assertThat(
            said(
                svg(
                    "<g transform='translate(100,0)'><a transform='scale(2)'>"
                        + "<rect transform='translate(1,1)' width='1' height='1'/></a></g>")))
        .isEqualTo("ring: 102 2, 104 2, 104 4, 102 4");
  }

  @ParameterizedTest
  @ValueSource(strings = {"svg", "s"})
  void the_namespace_may_have_any_prefix_and_others_are_passed_over(String prefix)
      throws IOException {
    String text =
        "<P:svg xmlns:P='http://www.w3.org/2000/svg' xmlns='urn:other'><rect width='1' height='1'/>"
            + "<P:polygon points='0,0 10,0 10,10'/></P:svg>";
    assertThat(said(text.replace("P:", prefix + ":").replace(":P=", ":" + prefix + "=")))
        .isEqualTo("ring: 0 0, 10 0, 10 10");
  }

  @Test
  void a_label_is_inkscapes_or_the_title_or_the_id_or_that_of_the_group() throws IOException {
    String shape = "points='0,0 1,0 1,1'";
    assertThat(
            said(
                "<svg xmlns:i='http://www.inkscape.org/namespaces/inkscape'><title>All</title>"
                    + ("<polygon " + shape + "/>")
                    + ("<polygon id='a' i:label='b' " + shape + "><title>c</title></polygon>")
                    + ("<polygon id='a' " + shape + "><title> c </title></polygon>")
                    + ("<g id='d'><g><polygon " + shape + "/></g></g></svg>")))
        .isEqualTo(
            "ring: 0 0, 1 0, 1 1\nring b: 0 0, 1 0, 1 1\nring c: 0 0, 1 0, 1 1\n"
                + "ring d: 0 0, 1 0, 1 1");
  }

  @Test
  void small_circles_alone_are_sites_by_group() throws IOException {
    String circles =
        "<circle cx='0' cy='0' r='1'/><g id='b'><ellipse cx='50' cy='9' rx='1' ry='2'/>"
            + "<circle cx='9' cy='9' r='1' transform='translate(1,1)'/></g>";
    assertThat(said(svg(circles))).isEqualTo("sites: 0 0\nsites b: 50 9, 10 10");
    assertThat(said(svg("<rect width='2' height='2.5'/>" + circles)))
        .isEqualTo("ring: 0 0, 2 0, 2 2.5, 0 2.5\n3 circles and ellipses are left out");
    assertThat(said(svg("<rect x='20' width='2' height='2'/>" + circles)))
        .isEqualTo("sites: 0 0, 21 1\nsites b: 50 9, 10 10");
  }

  @Test
  void large_circles_are_no_sites() {
    refuses(
        svg("<circle cx='0' cy='0' r='20'/><circle cx='9' cy='9' r='1'/><text>a</text>"),
        " this is SVG without a polygon or path of straight edges (only 2 circles and ellipses,"
            + " 1 text); draw one with 3 vertices or more");
  }

  @Test
  void the_background_is_left_out_unless_it_is_all_there_is() throws IOException {
    String page = "<svg width='9px' height='8'><rect width='9' height='8'/>";
    assertThat(said(page + "</svg>")).isEqualTo("ring: 0 0, 9 0, 9 8, 0 8");
    assertThat(said(page + "<polygon points='0,0 1,0 1,1'/></svg>"))
        .isEqualTo("ring: 0 0, 1 0, 1 1\n1 background is left out");
    assertThat(
            said(
                "<svg viewBox='-5 -5 9 8'><rect x='-5' y='-5' width='9' height='8'/>"
                    + "<circle r='0.1'/><circle r='0.1' cx='3'/></svg>"))
        .isEqualTo("sites: 0 0, 3 0\n1 background is left out");
  }

  @Test
  void a_background_of_that_class_is_left_out() throws IOException {
    String ground = "<g class='background'><rect width='1' height='1'/></g>";
    assertThat(said(svg(ground + "<polygon points='0,0 1,0 1,1'/>")))
        .isEqualTo("ring: 0 0, 1 0, 1 1\n1 background is left out");
  }

  @Test
  void what_is_left_out_is_counted() throws IOException {
    assertThat(
            said(
                svg(
                    "<polygon points='0,0 1,0 1,1'/><path d='M0 0A1 1 0 0 0 2 2z'/>"
                        + "<path d='M0 0q1 1 2 0z'/><rect rx='1' width='4' height='4'/>"
                        + "<rect width='100%' height='1cm'/><line x2='1'/><path d='M0 0 1 1'/>"
                        + "<use href='#a'/><image/><g display='none'><rect/></g>"
                        + "<svg><polygon points='0,0 1,0 1,1'/></svg>")))
        .isEqualTo(
            """
            ring: 0 0, 1 0, 1 1
            3 curved paths are left out
            2 lines of fewer than 3 vertices are left out
            1 rectangle without a plain size is left out
            1 image is left out
            1 copy by reference is left out
            1 hidden element is left out
            1 embedded drawing is left out\
            """);
  }

  @Test
  void curves_alone_are_refused() {
    refuses(
        svg("<path d='M0 0C1 1 2 2 3 0z'/><path d='M0 0s1 1 2 2z'/>"),
        " this is SVG without a polygon or path of straight edges (only 2 curved paths); draw one"
            + " with 3 vertices or more");
    refuses(
        svg(""),
        " this is SVG without a polygon or path of straight edges; draw one with 3 vertices or"
            + " more");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<polygon points='0,0 1'/> | a number is missing at the end of the attribute points; add"
            + " it",
        "<polygon points='0,0 1,a 2,2'/> | \"a\" in the attribute points is not a number; correct"
            + " it",
        "<polygon points='0,0 1,,2'/> | \",\" in the attribute points is not a number; correct it",
        "<polygon points='0,0 1px,2 3,4'/> |"
            + " \"px\" in the attribute points is not a number; correct it",
        "<polygon points='0,0 1e999,2 3,4'/> |"
            + " a point is beyond the range of double numbers; scale the drawing down",
        "<g transform='scale(1e300)'><rect width='1e9' height='1'/></g> |"
            + " a point is beyond the range of double numbers; scale the drawing down",
        "<path d='0 0 1 1'/> | \"0\" in the path data is no command to move or draw there; correct"
            + " it",
        "<path d='L0 0 1 1'/> |"
            + " \"L0\" in the path data is no command to move or draw there; correct it",
        "<path d='M0 0 1 1 2'/> | a number is missing at the end of the path data; add it",
        "<path d='M0 0 Lx'/> | \"x\" in the path data is not a number; correct it",
        "<path d='M0 0 1 1 &#9731;'/> |"
            + " \"☃\" in the path data is no command to move or draw there; correct it",
        "<g transform='turn(3)'/> | \"turn\" in the attribute transform is not known; use matrix",
        "<g transform='scale(1 2 3)'/> |"
            + " scale in the attribute transform has not as many numbers as it needs; correct it",
        "<g transform='scale(1'/> |"
            + " a closing parenthesis is missing in the attribute transform; add it",
        "<g transform='rotate(45deg)'/> |"
            + " \"deg\" in the attribute transform is not a number; correct it",
        "<g transform='5'/> | \"5\" in the attribute transform is no map with numbers; correct it",
        "<g style='transform: scale(2)'/> |"
            + " a style turns or moves the element; write an attribute transform instead",
        "<g><rect></g> | the XML is not well-formed here; mend it, or save the drawing anew",
        "<g i:label='a'/> | the XML is not well-formed here; mend it, or save the drawing anew",
      })
  void what_is_wrong_is_said_with_its_line(String content, String sentence) {
    refuses(svg("\n\n" + content), "3: " + sentence);
  }

  @Test
  void an_end_that_comes_too_early_is_said() {
    refuses(
        OPEN + "\n<polygon points='0,0 1,0 1,1'/>\n<g>",
        "3: the XML ends before its last element is closed; restore the rest of the file");
  }

  @Test
  void a_vertex_is_in_the_line_in_which_its_element_starts() throws IOException {
    Shape shape = read(svg("\n\n<polygon\n points='0,0\n1,0\n1,1'/>")).shapes().get(0);
    assertThat(shape.lines()).containsExactly(3, 3, 3);
  }

  @Test
  void damage_is_read_or_refused_in_a_sentence() throws IOException {
    Drawn.survivesDamage(INKSCAPE, 1);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6})
  void every_double_is_read_as_it_was_written(long seed) throws IOException {
    Random random = new Random(seed);
    double[] x = new double[3 + random.nextInt(200)];
    double[] y = new double[x.length];
    StringBuilder list = new StringBuilder();
    for (int v = 0; v < x.length; v++) {
      x[v] = random.nextGaussian() * Math.pow(10, random.nextInt(30) - 15);
      y[v] = random.nextGaussian() * Math.pow(10, random.nextInt(600) - 300);
      list.append(Decimals.format(x[v])).append(v % 2 == 0 ? "," : " ");
      list.append(Decimals.format(y[v])).append(' ');
    }
    String text =
        svg(
            ("<g transform='scale(1)'><polygon points='" + list + "'/></g>")
                + ("<path d='M" + list + "z'/>"));
    Shapes shapes = read(text);
    assertThat(shapes.shapes())
        .hasSize(2)
        .allSatisfy(shape -> assertThat(shape.points()).isEqualTo(Points.of(x, y)));
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void moves_are_added_up_as_decimals(long seed) throws IOException {
    Random random = new Random(seed);
    long x = 0;
    long y = 0;
    StringBuilder data = new StringBuilder("m 0,0");
    StringBuilder places = new StringBuilder("0,0");
    for (int v = 0; v < 300; v++) {
      long dx = random.nextInt(2_000_001) - 1_000_000L;
      long dy = random.nextInt(2_000_001) - 1_000_000L;
      x += dx;
      y += dy;
      data.append(' ').append(dx / 1000.0).append(',').append(dy / 1000.0);
      places.append(' ').append(x / 1000.0).append(',').append(y / 1000.0);
    }
    Shapes shapes = read(svg("<path d='" + data + "z'/><polygon points='" + places + "'/>"));
    assertThat(shapes.shapes().get(0).points()).isEqualTo(shapes.shapes().get(1).points());
  }

  @Test
  void a_move_of_many_digits_or_places_takes_no_memory() throws IOException {
    String far = "1e-999999999 1e999 1e-300";
    refuses(
        svg("<path d='m 0 0 1 " + far + "z'/>"),
        "1: a point is beyond the range of double numbers; scale the drawing down");
    String digits = "0." + "1".repeat(1_000_000);
    String path = "<path d='m 0 0 " + digits + " 1e-999999999 1e300 1 -1e300 1 1 1e-300z'/>";
    assertThat(read(svg(path)).shapes().get(0).points().x(3)).isEqualTo(0.1111111111111111);
  }

  @Test
  void a_move_too_small_for_a_number_is_none() throws IOException {
    assertThat(said(svg("<path d=\"M1 0l2e-99999999999 1 3-2z\"/>")))
        .isEqualTo("ring: 1 0, 1 1, 4 -1");
  }

  @Test
  void a_line_of_ten_million_characters_is_read() throws IOException {
    int n = 1_000_000;
    StringBuilder points = new StringBuilder(12 * n);
    for (int v = 0; v < n; v++) {
      points.append(1000 + v % 1000).append(',').append(10000 + v % 7).append(' ');
    }
    String text = svg("<polygon points='" + points + "'/>");
    assertThat(text.length()).isGreaterThan(10_000_000);
    assertThat(read(text).shapes().get(0).points().size()).isEqualTo(n);
    assertThat(read(svg("<path d='m" + points + "'/>")).shapes().get(0).points().size())
        .isEqualTo(n);
  }

  @Test
  void a_label_of_any_encoding_is_read() throws IOException {
    String polygon = "<polygon id='Größe' points='0,0 1,0 1,1'/>";
    byte[] latin =
        ("<?xml version='1.0' encoding='ISO-8859-1'?>" + svg(polygon))
            .getBytes(StandardCharsets.ISO_8859_1);
    assertThat(read(latin).shapes().get(0).label()).isEqualTo("Größe");
    assertThat(said("<?xml version='1.0' encoding='UTF-16'?>" + svg(polygon)))
        .isEqualTo("ring Größe: 0 0, 1 0, 1 1");
    refuses(
        "<?xml version='1.0' encoding='klingon'?>" + svg(polygon),
        "1: the encoding klingon is not known here; save the file in UTF-8");
  }
}
