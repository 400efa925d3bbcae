package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PictureParametersTest {
  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--size=84|--size: 84 is no width; write 84mm or 600px",
        "--size=5mm|--size: 5mm is out of range; take from 10mm to 1000mm",
        "--scale=5|--scale: 5 is out of range; take from 1 to 4",
        "--labels=number|--labels number is unknown",
        "--theme=grey|--theme grey is unknown",
      })
  void what_is_no_option_is_refused(String option, String sentence) {
    Path out = folder.resolve("a.svg");
    CliRun run = CliRun.withInput("0 0\n1 0\n1 1\n", "convert", "-", "-o", out, option);
    assertThat(run.status()).isEqualTo(2);
    assertThat(run.err()).contains(sentence);
    assertThat(Files.exists(out)).isFalse();
  }

  @Test
  void a_foreign_format_has_y_upwards() throws Exception {
    Path own = folder.resolve("own.svg");
    Path wkt = folder.resolve("wkt.svg");
    CliRun.withInput("0 0\n9 0\n0 5\n", "convert", "-", "-o", own).done();
    CliRun.withInput("POLYGON((0 0, 9 0, 0 5, 0 0))", "convert", "-", "-o", wkt).done();
    assertThat(Files.readString(wkt)).isNotEqualTo(Files.readString(own));
    CliRun.withInput("0 0\n9 0\n0 5\n", "convert", "-", "-o", own, "--y-up").done();
    assertThat(Files.readString(wkt)).isEqualTo(Files.readString(own));
  }
}
