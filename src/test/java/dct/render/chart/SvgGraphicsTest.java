package dct.render.chart;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Rectangle;
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
  void images_are_refused() {
    BufferedImage image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
    assertThatThrownBy(() -> graphics.drawImage(image, 0, 0, null))
        .isInstanceOf(UnsupportedOperationException.class);
  }
}
