package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class InkTest {
  /** What WCAG 2.1 asks of the parts of a picture; of text it asks {@link #TEXT}. */
  private static final double SHAPES = 3;

  private static final double TEXT = 4.5;

  private static final Set<Ink> GROUNDS = EnumSet.of(Ink.BACKGROUND, Ink.INSIDE);

  @ParameterizedTest
  @EnumSource(Theme.class)
  void everyInkStandsOutFromBothGrounds(Theme theme) {
    for (Ink ink : Ink.values()) {
      if (!GROUNDS.contains(ink)) {
        for (Ink ground : GROUNDS) {
          assertThat(contrast(ink.rgb(theme), ground.rgb(theme)))
              .as("%s on %s, %s", ink, ground, theme)
              .isGreaterThanOrEqualTo(ink == Ink.LABEL ? TEXT : SHAPES);
        }
      }
    }
  }

  private static double contrast(int a, int b) {
    double lighter = Math.max(luminance(a), luminance(b));
    double darker = Math.min(luminance(a), luminance(b));
    return (lighter + 0.05) / (darker + 0.05);
  }

  /** The relative luminance of a colour of sRGB. */
  private static double luminance(int rgb) {
    return 0.2126 * linear(rgb >> 16 & 0xFF)
        + 0.7152 * linear(rgb >> 8 & 0xFF)
        + 0.0722 * linear(rgb & 0xFF);
  }

  private static double linear(int part) {
    double c = part / 255.0;
    return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
  }
}
