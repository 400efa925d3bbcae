package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.io.FileEnding.Content;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

class FileEndingTest {

  @Test
  void messages_list_what_can_be_held() {
    assertThat(FileEnding.list(Content.PICTURE)).isEqualTo(".png, .svg, .pdf, .ipe or .tex");
    assertThat(FileEnding.list(Content.TABLES)).isEqualTo(".tex or .md");
    assertThat(FileEnding.list(Content.ROWS)).isEqualTo(".csv");
    assertThat(FileEnding.extensions(Content.CHART)).containsExactly("png", "svg", "pdf");
  }

  @Test
  void one_ending_can_be_a_picture_here_and_none_there() {
    assertThat(FileEnding.of("A.IPE", Content.PICTURE)).contains(FileEnding.IPE);
    assertThat(FileEnding.of("a.ipe", Content.CHART)).isEmpty();
    assertThat(FileEnding.of("aipe", Content.PICTURE)).isEmpty();
    assertThatThrownBy(() -> FileEnding.require(Path.of("a.bmp"), Content.CHART))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("a.bmp does not end in .png, .svg or .pdf");
  }

  @Test
  void the_longest_ending_is_meant() {
    assertThat(FileEnding.of("a.instance.json", Content.TRIANGULATION))
        .contains(FileEnding.INSTANCE);
    assertThat(FileEnding.of("instance.json", Content.TRIANGULATION)).contains(FileEnding.JSON);
    assertThat(FileEnding.of("a.instance.json", Content.POINTS)).contains(FileEnding.JSON);
  }

  @Test
  void an_ending_is_added_where_none_fits() {
    assertThat(FileEnding.PNG.orElseOn(Path.of("f/a.svg"), Content.PICTURE)).hasToString("f/a.svg");
    assertThat(FileEnding.PNG.orElseOn(Path.of("f/a.b"), Content.PICTURE)).hasToString("f/a.b.png");
  }
}
