package dct;

import static org.assertj.core.api.Assertions.assertThat;

import dct.testing.ProgramProcess;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.jar.JarFile;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The jar that the build leaves, and the script that runs it: in the phase after packaging. */
@Tag("jar")
class JarTest {
  private static final Path JAR = Path.of("target", "dct.jar").toAbsolutePath();

  @TempDir Path folder;

  @Test
  void no_licence_and_no_notice_of_a_library_is_lost() throws IOException {
    Set<String> libraries = new LinkedHashSet<>();
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator, -1)) {
      if (entry.endsWith(".jar") && isPacked(Path.of(entry))) {
        libraries.add(Path.of(entry).getFileName().toString().replaceFirst("-[0-9].*", ""));
        assertLegalTextsArePacked(Path.of(entry));
      }
    }
    assertThat(libraries)
        .contains("flatlaf", "picocli", "gson", "xchart", "graphics2d")
        .contains("pdfbox", "pdfbox-io", "fontbox", "commons-logging");
    String notice = text(JAR, "META-INF/NOTICE").toLowerCase(Locale.ROOT);
    for (String library : libraries) {
      assertThat(notice).contains(library.replace('-', ' ').replace('_', ' '));
    }
  }

  /** Whether the classes of a library are in the jar. */
  private static boolean isPacked(Path library) throws IOException {
    try (JarFile packed = new JarFile(JAR.toFile());
        JarFile jar = new JarFile(library.toFile())) {
      return jar.stream()
          .filter(entry -> entry.getName().matches("(?!META-INF|module-info).*\\.class"))
          .findFirst()
          .map(entry -> packed.getEntry(entry.getName()) != null)
          .orElse(false);
    }
  }

  private static void assertLegalTextsArePacked(Path library) throws IOException {
    List<String> names = new ArrayList<>();
    try (JarFile jar = new JarFile(library.toFile())) {
      jar.stream()
          .map(entry -> entry.getName())
          .filter(
              name -> name.matches("(?i)META-INF/(licen[cs]e|notice|dependencies|copying)[^/]*"))
          .forEach(names::add);
    }
    for (String name : names) {
      assertThat(text(JAR, name)).as(library + " " + name).contains(text(library, name).strip());
    }
  }

  @Test
  void the_programs_own_licence_comes_first() throws IOException {
    assertThat(text(JAR, "META-INF/LICENSE")).startsWith(Files.readString(Path.of("LICENSE")));
    assertThat(text(JAR, "META-INF/NOTICE")).startsWith(Files.readString(Path.of("NOTICE")));
    assertThat(text(JAR, "META-INF/LICENSE"))
        .contains(
            "Liberation Fonts", "SIL Open Font License", "www.fontbox.org", "Adobe Font Metrics");
  }

  private static String text(Path jar, String name) throws IOException {
    try (JarFile file = new JarFile(jar.toFile())) {
      assertThat(file.getEntry(name)).as(jar + " " + name).isNotNull();
      byte[] bytes = file.getInputStream(file.getEntry(name)).readAllBytes();
      return new String(bytes, StandardCharsets.UTF_8);
    }
  }

  @Test
  void the_jar_is_small_and_writes_pdf() throws Exception {
    assertThat(Files.size(JAR)).isLessThan(7_000_000);
    Path input = Files.writeString(folder.resolve("a_polygonbased.txt"), "0 0\n9 0\n9 9\n");
    Process run =
        script(
                Path.of("bin/dct").toAbsolutePath(),
                "convert",
                input.toString(),
                "-o",
                "a.pdf",
                "--labels",
                "numbers")
            .start();
    assertThat(ProgramProcess.text(run.getErrorStream())).isEmpty();
    assertThat(run.waitFor()).isZero();
    try (var document = org.apache.pdfbox.Loader.loadPDF(folder.resolve("a.pdf").toFile())) {
      assertThat(new org.apache.pdfbox.text.PDFTextStripper().getText(document)).contains("v2");
    }
  }

  @Test
  void the_script_runs_the_jar_from_anywhere() throws Exception {
    Path link =
        Files.createSymbolicLink(folder.resolve("dct"), Path.of("bin/dct").toAbsolutePath());
    Files.createDirectory(folder.resolve("with blank"));
    Path chain = Files.createSymbolicLink(folder.resolve("with blank/dct"), Path.of("../dct"));
    for (Path script : List.of(Path.of("bin/dct").toAbsolutePath(), link, chain)) {
      Process run = script(script, "--version").start();
      assertThat(ProgramProcess.text(run.getInputStream())).startsWith("dct 1.").contains("Apache");
      assertThat(ProgramProcess.text(run.getErrorStream())).isEmpty();
      assertThat(run.waitFor()).isZero();
    }
    Process bad = script(link, "check", "no such file").start();
    assertThat(ProgramProcess.text(bad.getErrorStream()))
        .isEqualTo("no such file: there is no such file; check its name and folder\n");
    assertThat(bad.waitFor()).isEqualTo(3);
  }

  private ProcessBuilder script(Path script, String... arguments) {
    List<String> command = new ArrayList<>(List.of(script.toString()));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().remove("JAVA_TOOL_OPTIONS");
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    return builder;
  }

  @Test
  void the_script_says_what_is_missing() throws Exception {
    Path script = Files.createDirectory(folder.resolve("bin")).resolve("dct");
    Files.copy(Path.of("bin/dct"), script, StandardCopyOption.COPY_ATTRIBUTES);
    assertFails(script(script), "the program is not built yet; run this first: cd ");
    Files.createDirectory(folder.resolve("target"));
    Files.createFile(folder.resolve("target/dct.jar"));
    ProcessBuilder nowhere = script(script);
    nowhere.environment().put("JAVA_HOME", "/nowhere");
    assertFails(nowhere, "there is no Java at /nowhere/bin/java; install a JDK 17 or newer");
    for (String version : List.of("1.8.0_402", "11.0.2")) {
      ProcessBuilder old = script(script);
      old.environment().put("JAVA_HOME", oldJava(version).toString());
      assertFails(old, "/bin/java is Java " + version + "; install a JDK 17 or newer");
    }
  }

  /** A folder that looks like the home of an old Java. */
  private Path oldJava(String version) throws IOException {
    Path home = folder.resolve("java " + version);
    Files.createDirectories(home.resolve("bin"));
    Path java = home.resolve("bin/java");
    Files.writeString(java, "#!/bin/sh\necho 'java version \"" + version + "\"' >&2\n");
    Files.setPosixFilePermissions(java, PosixFilePermissions.fromString("rwxr-xr-x"));
    return home;
  }

  private static void assertFails(ProcessBuilder program, String sentence) throws Exception {
    Process run = program.start();
    String said = ProgramProcess.text(run.getErrorStream());
    assertThat(said).startsWith("dct: ").contains(sentence);
    assertThat(said.lines()).hasSize(1);
    assertThat(run.waitFor()).isEqualTo(1);
  }
}
