package dct.render.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dct.render.chart.Chart.Look;
import dct.render.chart.Chart.Series;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.apache.pdfbox.Loader;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.text.PDFTextStripper;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;

class ChartFileTest {
  private static final Chart LINES =
      new Chart(
          "lines",
          "Lines & more",
          "n",
          "%",
          false,
          List.of(),
          List.of(
              new Series(
                  "a", Look.GREEN, List.of(1.0, 9.0, 90.0), List.of(1.0, 3.0, 2.0), errors(3)),
              new Series("b", Look.ORANGE, List.of(2.0), List.of(4.0), errors(1))));
  private static final Chart BARS =
      new Chart(
          "bars",
          "Bars",
          "shape",
          "%",
          false,
          List.of("one", "two"),
          List.of(
              new Series("a", Look.BLUE, List.of(), List.of(1.0, 3.0), errors(2)),
              new Series("b", Look.VIOLET, List.of(), List.of(2.0, 1.0), errors(2))));
  private static final Chart EMPTY =
      new Chart(
          "empty",
          "Nothing",
          "n",
          "%",
          false,
          List.of(),
          List.of(new Series("a", Look.GREEN, List.of(), List.of(), List.of())));

  @TempDir Path folder;

  private static List<Double> errors(int n) {
    return java.util.Collections.nCopies(n, 0.5);
  }

  private Path write(Chart chart, String ending) throws IOException {
    Path file = folder.resolve(chart.word() + ending);
    ChartFile.write(chart, file);
    return file;
  }

  @Test
  void an_image_shows_each_series_in_its_colour() throws IOException {
    requireColours(LINES, Look.GREEN, Look.ORANGE);
    requireColours(BARS, Look.BLUE, Look.VIOLET);
    requireColours(EMPTY);
  }

  private void requireColours(Chart chart, Look... looks) throws IOException {
    BufferedImage image = ImageIO.read(write(chart, ".png").toFile());
    for (Look look : looks) {
      int pixels = 0;
      for (int i = 0; i < image.getWidth() * image.getHeight(); i++) {
        int rgb = image.getRGB(i % image.getWidth(), i / image.getWidth()) & 0xFFFFFF;
        pixels += rgb == look.rgb() ? 1 : 0;
      }
      assertThat(pixels).as("%s in %s", look, chart.word()).isGreaterThan(50);
    }
  }

  @Test
  void an_axis_of_shares_ends_at_100_however_long_the_error_bars_are() throws IOException {
    Chart shares =
        new Chart(
            "shares",
            "Shares",
            "shape",
            "%",
            true,
            List.of("one", "two"),
            List.of(
                new Series("a", Look.BLUE, List.of(), List.of(100.0, 98.0), List.of(0.0, 9.0))));
    BufferedImage image = ImageIO.read(write(shares, ".png").toFile());
    int topOfBar = firstRow(image, 0, image.getWidth(), rgb -> rgb == Look.BLUE.rgb());
    int topOfGrid = firstRow(image, 170, 171, rgb -> rgb != 0xFFFFFF); // left of bars and title
    assertThat(topOfGrid).isCloseTo(topOfBar, within(2));
  }

  @Test
  void bars_of_shares_stand_on_the_axis_however_long_the_error_bars_are() throws IOException {
    assertThat(heightOfBar(60)).isEqualTo(heightOfBar(0)).isGreaterThan(100);
  }

  private int heightOfBar(double error) throws IOException {
    Series bar = new Series("a", Look.BLUE, List.of(), List.of(40.0), List.of(error));
    Chart share = new Chart("share", "Share", "shape", "%", true, List.of("one"), List.of(bar));
    BufferedImage image = ImageIO.read(write(share, ".png").toFile());
    int[] column = new int[image.getHeight()];
    image.getRGB(300, 0, 1, column.length, column, 0, 1); // left of the error bar
    return (int) IntStream.of(column).filter(rgb -> (rgb & 0xFFFFFF) == Look.BLUE.rgb()).count();
  }

  private static int firstRow(BufferedImage image, int from, int to, IntPredicate wanted) {
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = from; x < to; x++) {
        if (wanted.test(image.getRGB(x, y) & 0xFFFFFF)) {
          return y;
        }
      }
    }
    throw new AssertionError("no such pixel");
  }

  @Test
  void an_svg_is_well_formed_and_the_same_each_time() throws Exception {
    for (Chart chart : List.of(LINES, BARS, EMPTY)) {
      String text = Files.readString(write(chart, ".svg"));
      Document document =
          DocumentBuilderFactory.newInstance()
              .newDocumentBuilder()
              .parse(new java.io.ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
      assertThat(document.getElementsByTagName("path").getLength()).isPositive();
      assertThat(document.getElementsByTagName("title").item(0).getTextContent())
          .isEqualTo(chart.title());
      for (Series series : chart.series()) {
        assertThat(text.contains("#%06x".formatted(series.look().rgb())))
            .as("%s in %s", series.look(), chart.word())
            .isEqualTo(!series.y().isEmpty());
      }
      assertThat(text.length()).as("characters").isLessThan(100_000);
      assertThat(Files.readString(write(chart, ".svg"))).isEqualTo(text);
    }
  }

  @Test
  void the_words_of_an_svg_are_text() throws IOException {
    String lines = Files.readString(write(LINES, ".svg"));
    assertThat(lines).contains(">Lines &amp; more</text>", ">%</text>", ">a</text>", ">b</text>");
    assertThat(lines).contains(">1</text>", ">3.5</text>");
    assertThat(Files.readString(write(BARS, ".svg"))).contains(">one</text>", ">two</text>");
  }

  @Test
  void a_pdf_has_one_page_and_is_the_same_each_time() throws IOException {
    byte[] bytes = Files.readAllBytes(write(LINES, ".pdf"));
    try (PDDocument document = Loader.loadPDF(bytes)) {
      assertThat(document.getNumberOfPages()).isOne();
      double millimetres = document.getPage(0).getMediaBox().getWidth() * 25.4 / 72;
      assertThat(millimetres).as("both columns of a paper").isCloseTo(174, within(0.1));
      assertThat(new PDFTextStripper().getText(document)).contains("Lines & more", "%", "3.5", "b");
    }
    assertThat(Files.readAllBytes(write(LINES, ".pdf"))).isEqualTo(bytes);
  }

  @Test
  void another_ending_is_refused() {
    assertThatThrownBy(() -> write(LINES, ".gif")).isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void values_without_a_place_are_refused() {
    assertThatThrownBy(() -> new Series("a", Look.BLUE, List.of(1.0), List.of(1.0, 2.0), errors(2)))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
