package dct.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * One contender on one set of sites in a process of its own, which is ended when it takes too long:
 * some peers never come back from sets that break floating point.
 */
final class Probe {
  private static final int LIMIT_SECONDS = 20;

  private Probe() {}

  /** What is wrong, or null. */
  static String remark(String family, int contender) {
    try {
      Process process =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-cp",
                  System.getProperty("java.class.path"),
                  Probe.class.getName(),
                  family,
                  String.valueOf(contender))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      if (!process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly();
        return "over " + LIMIT_SECONDS + " s";
      }
      String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return process.exitValue() != 0 ? "fails" : said.isBlank() ? null : "wrong: " + said.strip();
    } catch (IOException | InterruptedException e) {
      throw new IllegalStateException("the probe cannot be started", e);
    }
  }

  public static void main(String[] args) throws Exception {
    Locale.setDefault(Locale.ROOT);
    SiteFamily family =
        SiteFamily.all().stream().filter(f -> f.title().equals(args[0])).findFirst().orElseThrow();
    Optional<String> problem = SiteComparison.problem(family.make(0), Integer.parseInt(args[1]));
    System.out.println(problem.orElse(""));
  }
}
