package dct.render;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.PointFile;
import dct.io.ResultJson;
import dct.io.format.Drawing;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Reading and writing that is cancelled in any moment: nothing is changed, nothing is left. */
class CancelledFilesTest {
  private static Solution solution;

  @TempDir Path folder;

  /** Cancels when it is asked for this time. */
  private static final class Impatient implements Progress {
    private final int last;
    private int asked;
    private double fraction;

    Impatient(int last) {
      this.last = last;
    }

    @Override
    public void report(double done, String message) {
      assertThat(done).isBetween(fraction, 1.0);
      fraction = done;
    }

    @Override
    public synchronized boolean isCancelled() {
      return ++asked >= last;
    }
  }

  /** Does something with a file. */
  private interface Use {
    void of(Path file, Progress progress) throws IOException;
  }

  @BeforeAll
  static void solve() {
    Instance sites =
        Instance.of(Domain.SITES, "sites", RandomSites.uniform(20_000, 1), Progress.NONE);
    solution = Solution.of(sites, Method.byDefault(Domain.SITES), Progress.NONE);
  }

  private static Use writer(String ending) {
    Instance sites = solution.instance();
    return switch (ending) {
      case "txt" -> (file, p) -> PointFile.write(file, sites.domain(), sites.points(), p);
      case "json" -> (file, p) -> ResultJson.write(file, solution, Optional.empty(), p);
      case "off" -> (file, p) -> DataFile.write(file, FileEnding.OFF, Drawing.of(solution), p);
      default -> (file, p) -> PictureFile.write(Scene.of(solution), Figure.DEFAULT, "", file, p);
    };
  }

  @ParameterizedTest
  @ValueSource(strings = {"txt", "json", "off", "svg", "ipe", "tex", "png", "pdf"})
  void a_cancelled_write_leaves_the_old_file_and_nothing_else(String ending) throws IOException {
    Path file = folder.resolve("x." + ending);
    Files.writeString(file, "old");
    int questions = questions(writer(ending), file, "old");
    assertThat(questions).as("questions").isGreaterThan(2);
    assertThat(Files.size(file)).isGreaterThan(1000);
  }

  /** Cancels at the first question, the second, the fourth …; returns how many there are. */
  private int questions(Use use, Path file, String before) throws IOException {
    for (int last = 1; ; last *= 2) {
      Impatient progress = new Impatient(last);
      try {
        use.of(file, progress);
        return progress.asked;
      } catch (CancellationException e) {
        assertThat(progress.asked).as("asked after the cancel").isBetween(last, last + 8);
        assertThat(file).hasContent(before);
        assertThat(folder).isDirectoryNotContaining("glob:**/.dct*");
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"txt", "json"})
  void reading_can_be_cancelled_and_says_how_far_it_is(String ending) throws IOException {
    Path file = folder.resolve("x_pointbased." + ending);
    writer(ending).of(file, Progress.NONE);
    Use read = (path, progress) -> PointFile.read(path, progress);
    int questions = questions(read, file, Files.readString(file));
    assertThat(questions).as("questions").isGreaterThan(2);
    Impatient patient = new Impatient(Integer.MAX_VALUE);
    assertThat(PointFile.read(file, patient).points()).isEqualTo(solution.instance().points());
    assertThat(patient.fraction).isEqualTo(1);
  }

  @Test
  void a_result_is_read_alike() throws IOException {
    Path file = folder.resolve("x.json");
    writer("json").of(file, Progress.NONE);
    Use read = (path, progress) -> ResultJson.read(path, progress);
    assertThat(questions(read, file, Files.readString(file))).isGreaterThan(2);
  }
}
