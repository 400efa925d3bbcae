package dct.ui.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.FileNames;
import dct.io.format.Choice;
import dct.io.text.BadInputException;
import dct.ui.document.Document;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Files and other things under the name of one, opened and saved as by the window. */
class DocumentFileTest {
  private static final Document TRIANGLE =
      new Document(Domain.POLYGON, Points.ofPairs(0, 0, 9, 0, 0, 9));

  @TempDir Path folder;

  private static Document read(Path file) {
    return DocumentFile.read(file, Choice.NONE, Progress.NONE).document();
  }

  private static void refusesToRead(Path file, String sentence) {
    assertThatThrownBy(() -> read(file))
        .isInstanceOf(BadInputException.class)
        .hasMessage(file + sentence);
  }

  private static void refusesToWrite(Path file, String reason) {
    assertThatThrownBy(() -> DocumentFile.write(file, TRIANGLE, Progress.NONE))
        .isInstanceOf(UncheckedIOException.class)
        .cause()
        .hasMessage(
            file
                + ": cannot be written, "
                + reason
                + "; nothing was changed, choose another place");
  }

  @Test
  void a_region_is_read_and_written_again() {
    Document plate = read(Path.of("samples", "plate_region.txt"));
    assertThat(plate.domain()).isEqualTo(Domain.POLYGON);
    assertThat(plate.content()).isEqualTo(Domain.REGION);
    assertThat(plate.layout().holes()).isEqualTo(2);
    for (String name : List.of("plate_region.txt", "plate.json")) {
      Path file = folder.resolve(name);
      DocumentFile.write(file, plate, Progress.NONE);
      assertThat(read(file)).as(name).isEqualTo(plate);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "with a blank.txt",
        " blanks round ",
        "Grüße ÄÖÜ 三角形",
        "50%20#1.txt",
        "-minus",
        "--help.json",
        "a'b\"c$d&e;f.txt",
        "line\nbreak.txt",
        ".hidden",
        "no.ending.at.all"
      })
  void any_name_will_do(String name) throws IOException {
    Path file = FileNames.forSaving(folder.resolve(name), Domain.POLYGON);
    assertThat(DocumentFile.write(file, TRIANGLE, Progress.NONE)).isPresent();
    assertThat(read(folder.resolve(name)).points()).isEqualTo(TRIANGLE.points());
    try (Stream<Path> files = Files.list(folder)) {
      assertThat(files).containsExactly(file);
    }
  }

  @Test
  void a_name_that_is_too_long_is_refused() throws IOException {
    Path file = folder.resolve("n".repeat(300) + ".txt");
    refusesToRead(file, ": there is no such file; check its name and folder");
    assertThatThrownBy(() -> DocumentFile.write(file, TRIANGLE, Progress.NONE))
        .hasMessageContaining(": cannot be written, ");
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void a_folder_is_no_document() throws IOException {
    Path inside = Files.createDirectories(folder.resolve("a_polygonbased.txt"));
    refusesToRead(inside, ": this is a folder; name a file in it");
    refusesToWrite(inside, "it is a folder");
    refusesToWrite(folder.resolve("gone").resolve("a.txt"), "its folder does not exist");
    assertThat(inside).isEmptyDirectory();
  }

  /** Reading or writing it might wait for ever, and what waits in line behind it as long. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void a_device_is_no_document() {
    String device = "it is a device or a pipe, which may never end";
    Path nothing = Path.of("/dev/null");
    refusesToRead(nothing, ": " + device + "; put what it gives into a file and open that");
    refusesToWrite(nothing, device);
  }
}
