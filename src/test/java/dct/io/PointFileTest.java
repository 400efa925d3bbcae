package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.io.text.BadInputException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class PointFileTest {
  private static final Points TRIANGLE = Points.ofPairs(0, 0, 4.5, -1e-9, 2, 3);

  private static PointDocument read(String text) throws IOException {
    return read(text.getBytes(StandardCharsets.UTF_8));
  }

  private static PointDocument read(byte[] bytes) throws IOException {
    return PointFile.read("in.txt", new ByteArrayInputStream(bytes));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "0 0\n4.5 -1e-9\n2 3\n",
        "0 0\n4.5 -1e-9\n2 3",
        "0 0\r\n4.5 -1e-9\r\n2 3\r\n",
        "0 0\r4.5 -1e-9\r2 3\r",
        "\uFEFF0 0\n4.5 -1e-9\n2 3\n",
        "0\t0\n4.5\t\t-1e-9\n2\t3\n",
        "0,0\n4.5,-1e-9\n2,3\n",
        "0;0\n4.5;-1e-9\n2;3\n",
        "0 , 0\n 4.5, -1e-9 \n\t2 ;3\t\n",
        "0,0,\n4.5;-1e-9;\n2,3,\n",
        "# Größe π\n\n  \n0 0 # first\n4.5 -1e-9 #second\n\t# between\n2 3\n\n#end",
        "+0 -0\n4.50 -.000000001\n002 3.\n",
      })
  void reads_every_form_of_the_text(String text) throws IOException {
    assertThat(read(text).points()).isEqualTo(TRIANGLE);
  }

  @Test
  void a_comment_may_be_of_any_length() throws IOException {
    for (int length : new int[] {65_530, 65_534, 65_535, 65_536, 65_537, 131_072, 300_000}) {
      for (String end : new String[] {"\n", "\r\n", "\r"}) {
        String text = "#" + "a".repeat(length) + end + "0 0" + end + "4.5 -1e-9" + end + "2 3";
        PointDocument document = read(text);
        assertThat(document.points()).as(length + " " + end).isEqualTo(TRIANGLE);
        assertThat(document.line(2)).isEqualTo(4);
      }
    }
    assertThat(read("0 0\n4.5 -1e-9\n2 3\n#" + "x".repeat(200_000)).points()).isEqualTo(TRIANGLE);
  }

  @Test
  void a_count_alone_in_front_is_no_vertex() throws IOException {
    PointDocument document = read("# n\n3 # vertices\n\n0 0\n4.5 -1e-9\n2 3\n");
    assertThat(document.points()).isEqualTo(TRIANGLE);
    assertThat(document.line(0)).isEqualTo(4);
  }

  @Test
  void a_vertex_that_looks_like_a_count_is_written_so_that_it_is_read_back(@TempDir Path folder)
      throws IOException {
    for (Points points :
        List.of(
            Points.ofPairs(3, 0, 6, 3, 3, 6, 0, 3),
            Points.ofPairs(3, 1, 0, 1, 1, 2, 2, 0, 0, 2),
            Points.ofPairs(0, 1, 2.5, 2.5, 1.5, 3.5))) {
      Path file = folder.resolve("x_polygonbased.txt");
      PointFile.write(file, Domain.POLYGON, points, Progress.NONE);
      assertThat(PointFile.read(file, Progress.NONE).points()).isEqualTo(points);
    }
  }

  @Test
  void knows_the_line_of_each_point() throws IOException {
    PointDocument document = read("# head\r\n0 0\r\n\r\n1 0\r1 1\n\n0 1");
    assertThat(document.line(0)).isEqualTo(2);
    assertThat(document.line(1)).isEqualTo(4);
    assertThat(document.line(2)).isEqualTo(5);
    assertThat(document.line(3)).isEqualTo(7);
  }

  @Test
  void reads_the_same_however_the_stream_is_cut() throws IOException {
    StringBuilder text = new StringBuilder("\uFEFF# head\r\n");
    SeededRandom random = new SeededRandom(2);
    for (int i = 0; i < 30_000; i++) {
      text.append(random.nextInt(1000)).append("   ").append(random.nextDouble()).append("\r\n");
    }
    byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
    PointDocument whole = read(bytes);
    InputStream trickle =
        new ByteArrayInputStream(bytes) {
          @Override
          public synchronized int read(byte[] b, int off, int len) {
            return super.read(b, off, Math.min(len, 1 + random.nextInt(7)));
          }
        };
    PointDocument cut = PointFile.read("in.txt", trickle);
    assertThat(cut.points()).isEqualTo(whole.points());
    assertThat(cut.points().size()).isEqualTo(30_000);
    assertThat(cut.line(29_999)).isEqualTo(30_001).isEqualTo(whole.line(29_999));
  }

  @ParameterizedTest
  @EnumSource(
      value = Domain.class,
      names = {"POLYGON", "SITES"})
  void a_comment_or_the_name_says_what_the_points_are(Domain domain, @TempDir Path folder)
      throws IOException {
    assertThat(read("0 0\n").declared()).isEmpty();
    assertThat(read("# kind: " + domain.word() + "\n0 0\n").declared()).contains(domain);
    assertThat(read("0 0\n# kind: " + domain.word() + "\n").declared()).isEmpty();
    assertThat(read("# kind: something\n0 0\n").declared()).isEmpty();
    Path file = folder.resolve("x" + FileNames.suffix(domain) + ".txt");
    Files.writeString(file, "0 0\n");
    assertThat(PointFile.read(file, Progress.NONE).declared()).contains(domain);
    assertThat(PointFile.read(folder.resolve("x"), Progress.NONE).declared()).contains(domain);
  }

  @ParameterizedTest
  @EnumSource(
      value = Domain.class,
      names = {"POLYGON", "SITES"})
  void writes_what_it_reads(Domain domain, @TempDir Path folder) throws IOException {
    for (String name : new String[] {"x" + FileNames.suffix(domain) + ".txt", "x.txt"}) {
      Path file = folder.resolve(name);
      PointFile.write(file, domain, TRIANGLE, Progress.NONE);
      PointDocument document = PointFile.read(file, Progress.NONE);
      assertThat(document.points()).isEqualTo(TRIANGLE);
      assertThat(document.declared()).contains(domain);
    }
    assertThat(folder.resolve("x" + FileNames.suffix(domain) + ".txt"))
        .hasContent("0 0\n4.5 -1e-9\n2 3\n");
    assertThat(folder.resolve("x.txt"))
        .hasContent("# kind: " + domain.word() + "\n0 0\n4.5 -1e-9\n2 3\n");
  }

  @Test
  void writes_and_reads_many_points(@TempDir Path folder) throws IOException {
    Points many = RandomSites.uniform(100_000, 3);
    Path file = folder.resolve("many_pointbased.txt");
    PointFile.write(file, Domain.SITES, many, Progress.NONE);
    assertThat(PointFile.read(file, Progress.NONE).points()).isEqualTo(many);
  }

  /** As {@code dct check <(command)} gives it. */
  @Test
  @EnabledOnOs(OS.LINUX)
  void reads_a_pipe_to_its_end(@TempDir Path folder) throws Exception {
    Path pipe = folder.resolve("pipe");
    assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
    Points many = RandomSites.uniform(10_000, 7);
    Path file = folder.resolve("many_pointbased.txt");
    PointFile.write(file, Domain.SITES, many, Progress.NONE);
    Process writer = new ProcessBuilder("cp", file.toString(), pipe.toString()).start();
    assertThat(PointFile.read(pipe, Progress.NONE).points()).isEqualTo(many);
    assertThat(writer.waitFor()).isZero();
  }

  @Test
  void stops_at_the_first_line_of_garbage() {
    InputStream endless =
        new InputStream() {
          private long given;

          @Override
          public int read() {
            return given++ % 8 == 7 ? '\n' : 'x';
          }

          @Override
          public int read(byte[] bytes, int from, int length) {
            assertThat(given).as("bytes read").isLessThan(200_000);
            for (int i = from; i < from + length; i++) {
              bytes[i] = (byte) read();
            }
            return length;
          }
        };
    assertThatThrownBy(() -> PointFile.read("-", endless))
        .isInstanceOf(BadInputException.class)
        .hasMessage(
            "-:1: \"xxxxxxx\" is not a number; write one vertex a line, as two numbers x y");
  }
}
