package dct.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.render.PictureFile.Picture;
import java.awt.image.BufferedImage;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;

class PictureFileTest {
  private static final Figure FIGURE =
      Figure.DEFAULT.withSize(new Figure.Size(1000, Figure.Unit.PX));

  private final Scene scene = Scene.of(Fixtures.flippedPentagon());

  @Test
  void pngShowsEachColourWhereItBelongs(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("picture.png");
    PictureFile.write(scene, FIGURE, "pentagon", file, Progress.NONE);
    BufferedImage image = ImageIO.read(file.toFile());
    assertThat(image.getWidth()).isEqualTo(1000);
    Viewport view = SheetLayout.of(scene, FIGURE).view();
    // v2 has three edges after the flip, v0 two.
    requireInk(image, view, Ink.ODD, 400, 200);
    requireInk(image, view, Ink.EVEN, 100, 100);
    requireInk(image, view, Ink.FLIPPED, 200, 200);
    requireInk(image, view, Ink.PARTITION, 250, 250);
    requireInk(image, view, Ink.INSIDE, 300, 200);
    assertThat(image.getRGB(2, 2) & 0xFFFFFF).isEqualTo(0xFFFFFF);
  }

  /** The pixel there has this colour, or most of it: lines are smoothed. */
  private static void requireInk(BufferedImage image, Viewport view, Ink ink, double x, double y) {
    int px = (int) Math.round(view.screenX(x));
    int py = (int) Math.round(view.screenY(y));
    for (int shift = 0; shift <= 16; shift += 8) {
      assertThat((image.getRGB(px, py) >> shift) & 0xFF)
          .as("%s at (%s, %s)", ink, x, y)
          .isCloseTo((ink.rgb(Theme.LIGHT) >> shift) & 0xFF, within(60));
    }
  }

  @Test
  void svgIsValidAndHoldsOneElementAShape() throws Exception {
    Document svg = parse(picture().svg());
    assertThat(svg.getElementsByTagName("line").getLength()).isEqualTo(7);
    int discs = svg.getElementsByTagName("circle").getLength();
    int squares = svg.getElementsByTagName("rect").getLength() - 1; // without the ground
    assertThat(svg.getElementsByTagName("polygon").getLength()).isEqualTo(1);
    assertThat(discs).isEqualTo(3);
    assertThat(squares).isEqualTo(2);
    assertThat(svg.getElementsByTagName("text").item(1).getTextContent())
        .isEqualTo("After: Even 3 · Odd 2");
  }

  @Test
  void svgNamesTheColoursOfItsGroups() throws Exception {
    Document svg = parse(picture().svg());
    NodeList groups = svg.getElementsByTagName("g");
    for (int i = 0; i < groups.getLength(); i++) {
      Element group = (Element) groups.item(i);
      Ink ink = Ink.valueOf(group.getAttribute("class").toUpperCase(Locale.ROOT));
      String hex = "#" + Integer.toHexString(0x1000000 | ink.rgb(Theme.LIGHT)).substring(1);
      String rule = "." + group.getAttribute("class") + " { fill: " + hex + "; stroke: " + hex;
      assertThat(svg.getElementsByTagName("style").item(0).getTextContent()).contains(rule);
    }
    assertThat(groups.getLength()).isGreaterThan(4);
  }

  @Test
  void ipeIsValidAndTurnsUpsideDown() throws Exception {
    Document ipe = parse(picture().ipe());
    NodeList paths = ipe.getElementsByTagName("path");
    assertThat(paths.getLength()).isEqualTo(2 + 1 + 7); // the marks' shapes, inside, edges
    assertThat(ipe.getElementsByTagName("use").getLength()).isEqualTo(5);
    for (String layer : List.of("polygon", "diagonals", "partition", "flipped", "vertices")) {
      assertThat(picture().ipe()).contains("<layer name=\"" + layer + "\"/>");
    }
    NodeList texts = ipe.getElementsByTagName("text");
    assertThat(texts.item(1).getTextContent()).isEqualTo("After: Even 3 $\\cdot$ Odd 2");
    String[] place = ((Element) texts.item(0)).getAttribute("pos").split(" ", -1);
    assertThat(Double.parseDouble(place[1]))
        .isGreaterThan(SheetLayout.of(scene, FIGURE).pointsHigh() - 30); // the upper edge
  }

  @Test
  void tikzDrawsEveryEdgeAndVertexInNamedColours() {
    String tex = picture().tex();
    assertThat(tex.lines().filter(line -> line.matches("\\([^ ]*\\) -- \\(.*"))).hasSize(7);
    assertThat(tex).contains("\\fill[dct-inside, even odd rule]\n(").contains("\n -- cycle;\n");
    assertThat(tex.lines().filter(line -> line.contains(" circle["))).hasSize(3);
    assertThat(tex.lines().filter(line -> line.matches("\\(.*\\) rectangle \\(.*"))).hasSize(2);
    assertThat(tex).contains("\\providecolor{dct-flipped}{HTML}{");
    assertThat(tex).contains("Even 3 $\\cdot$ Odd 2").doesNotContain("documentclass");
    assertThat(tex).endsWith("\\end{tikzpicture}\n");
  }

  @Test
  void pdfIsOnePageAndAlwaysTheSame(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("picture.pdf");
    Path again = folder.resolve("again.pdf");
    PictureFile.write(scene, FIGURE, "pentagon", file, Progress.NONE);
    PictureFile.write(scene, FIGURE, "pentagon", again, Progress.NONE);
    assertThat(again).hasSameBinaryContentAs(file);
    try (var document = org.apache.pdfbox.Loader.loadPDF(file.toFile())) {
      assertThat(document.getNumberOfPages()).isEqualTo(1);
      assertThat(document.getPage(0).getMediaBox().getWidth()).isEqualTo(750);
      assertThat(document.getDocumentInformation().getTitle()).isEqualTo("pentagon");
    }
  }

  @Test
  void texEscapesWhatItWouldTakeForCommands() {
    assertThat(TexText.of("50 % of v_1 & {v2} ≡ 0 → #1"))
        .isEqualTo("50 \\% of v\\_1 \\& \\{v2\\} $\\equiv$ 0 $\\to$ \\#1");
  }

  @Test
  void svgNumbersHaveAPointInEveryLocale() throws Exception {
    String here = picture().svg();
    Locale old = Locale.getDefault();
    try {
      for (String tag : new String[] {"de-DE", "ar-EG-u-nu-arab", "hi-IN-u-nu-deva"}) {
        Locale.setDefault(Locale.forLanguageTag(tag));
        assertThat(picture().svg()).as(tag).isEqualTo(here);
      }
    } finally {
      Locale.setDefault(old);
    }
  }

  @Test
  void svgEscapesText() throws Exception {
    SvgPen pen = new SvgPen(SheetLayout.of(scene, FIGURE), new Title("", ""));
    pen.style(Stroke.fill(Ink.LABEL));
    pen.text(1, 2, Pen.Anchor.START, 10, "a < b & c > d");
    Document svg = parse(pen.finish());
    assertThat(svg.getElementsByTagName("text").item(0).getTextContent())
        .isEqualTo("a < b & c > d");
  }

  @Test
  void anEndingThatIsNoPictureIsRefused(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("picture.bmp");
    assertThatThrownBy(() -> PictureFile.write(scene, FIGURE, "pentagon", file, Progress.NONE))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(".png");
    assertThat(Files.exists(file)).isFalse();
  }

  @Test
  void theEndingMayBeInCapitals(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("PICTURE.SVG");
    PictureFile.write(scene, FIGURE, "pentagon", file, Progress.NONE);
    assertThat(Files.readString(file)).startsWith("<?xml");
  }

  private static Document parse(String svg) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new InputSource(new StringReader(svg)));
  }

  private Picture picture() {
    return Picture.of(scene, FIGURE, "pentagon", Progress.NONE);
  }
}
