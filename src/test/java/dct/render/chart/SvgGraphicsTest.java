package dct.render.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import dct.render.OutlinedText;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.font.TextLayout;
import java.awt.geom.AffineTransform;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;

class SvgGraphicsTest {
  private final SvgGraphics graphics = new SvgGraphics("drawn", 100, 50);

  @Test
  void shapes_are_paths_in_device_space() {
    graphics.translate(10, 5);
    graphics.scale(2, 2);
    graphics.setColor(new Color(0x12, 0x34, 0x56, 0x80));
    graphics.fillRect(0, 0, 3, 2);
    assertThat(graphics.finish())
        .contains("viewBox=\"0 0 100 50\"")
        .contains("fill=\"#123456\" fill-opacity=\"0.5\" d=\"m10 5l6 0l0 4l-6 0l0-4z\"");
  }

  @Test
  void a_part_of_a_path_begins_where_the_last_one_was_closed() {
    Path2D path = new Path2D.Double();
    path.moveTo(1, 1);
    path.lineTo(5, 1);
    path.lineTo(5, 4);
    path.closePath();
    path.moveTo(2, 3);
    path.quadTo(2.125, 3, 4, 4);
    graphics.draw(path);
    assertThat(graphics.finish()).contains("d=\"m1 1l4 0l0 3zm1 2q0.13 0 2 1\"");
  }

  @Test
  void lines_have_width_and_dashes() {
    graphics.setStroke(new BasicStroke(1.5f, 0, 0, 1, new float[] {3, 1}, 0));
    graphics.drawLine(0, 0, 4, 4);
    assertThat(graphics.finish())
        .contains("fill=\"none\" stroke=\"#000000\" stroke-width=\"1.5\" stroke-dasharray=\"3 1\"");
  }

  @Test
  void dashes_without_gaps_are_a_line() {
    graphics.setStroke(new BasicStroke(1, 0, 0, 1, new float[] {3, 0}, 0));
    graphics.drawLine(0, 0, 4, 4);
    assertThat(graphics.finish()).doesNotContain("dash");
  }

  @Test
  void a_clip_is_defined_once_and_named() {
    graphics.setClip(new Rectangle(1, 1, 5, 5));
    graphics.fillRect(0, 0, 9, 9);
    graphics.fillRect(0, 0, 8, 8);
    graphics.setClip(null);
    graphics.fillRect(0, 0, 7, 7);
    String svg = graphics.finish();
    assertThat(svg.split("<clipPath", -1)).hasSize(2);
    assertThat(svg.split("clip-path=\"url\\(#c1\\)\"", -1)).hasSize(3);
  }

  @Test
  void letters_that_are_filled_are_text_where_they_are() {
    graphics.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 14));
    graphics.translate(20, 10);
    graphics.fill(outline("il: 50 %  <–> ñ;", AffineTransform.getTranslateInstance(3, 4)));
    assertThat(graphics.finish())
        .containsPattern(
            "x=\"23\" y=\"14\" font-size=\"14\" font-weight=\"bold\" textLength=\"[0-9.]+\"[^>]*>"
                + "il: 50 %  &lt;–> ñ;</text>")
        .doesNotContain("<path");
  }

  @Test
  void letters_that_are_turned_are_text() {
    graphics.scale(2, 2);
    graphics.fill(outline("even, %", AffineTransform.getRotateInstance(-Math.PI / 2)));
    graphics.fill(outline("1.5", AffineTransform.getRotateInstance(Math.toRadians(-25))));
    assertThat(graphics.finish())
        .containsPattern("font-size=\"24\" transform=\"rotate\\(-90 0 0\\)\"[^>]*>even, %</text>")
        .containsPattern("transform=\"rotate\\(-25 0 0\\)\"[^>]*>1.5</text>");
  }

  @Test
  void text_takes_as_much_room_as_its_letters() {
    graphics.drawString("Wide", 1, 2);
    double width = new TextLayout("Wide", graphics.getFont(), OutlinedText.MEASURE).getAdvance();
    String written = graphics.finish().replaceAll("(?s).*textLength=\"|\".*", "");
    assertThat(Double.parseDouble(written)).isCloseTo(width, within(0.01));
  }

  @Test
  void what_is_no_letter_stays_a_path() {
    Path2D path = new Path2D.Double(outline("a", new AffineTransform()));
    path.lineTo(50, 50);
    graphics.fill(path);
    graphics.fill(outline("a\u4e2d", new AffineTransform()));
    graphics.fill(new Path2D.Double(new Rectangle(1, 1, 5, 5)));
    assertThat(graphics.finish()).doesNotContain("<text");
  }

  private Shape outline(String text, AffineTransform at) {
    return new TextLayout(text, graphics.getFont(), OutlinedText.MEASURE).getOutline(at);
  }

  @Test
  void images_are_refused() {
    BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
    assertThatThrownBy(() -> graphics.drawImage(image, 0, 0, null))
        .isInstanceOf(UnsupportedOperationException.class);
  }
}
