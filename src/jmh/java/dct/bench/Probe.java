package dct.bench;

import dct.experiment.generate.PolygonShape;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * One contender on one input in a process of its own, which is ended when it takes too long: some
 * peers never come back from sets that break floating point, or from large polygons.
 */
final class Probe {
  private static final int LIMIT_SECONDS = 20;

  private Probe() {}

  /** What is wrong with a contender on a set of sites that breaks floating point, or null. */
  static String remark(SiteFamily family, int contender) {
    return remark(family.title(), "0", contender);
  }

  /** What is wrong with a contender on a polygon of this shape, or null. */
  static String remark(PolygonShape shape, int n, int contender) {
    return remark(shape.word(), String.valueOf(n), contender);
  }

  private static String remark(String input, String n, int contender) {
    try {
      Process process =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-cp",
                  System.getProperty("java.class.path"),
                  Probe.class.getName(),
                  input,
                  n,
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
    int n = Integer.parseInt(args[1]);
    int contender = Integer.parseInt(args[2]);
    Optional<PolygonShape> shape = PolygonShape.of(args[0]);
    Optional<String> problem =
        shape.isPresent()
            ? PolygonComparison.problem(shape.get(), n, contender)
            : SiteComparison.problem(SiteFamily.of(args[0]).make(n), contender);
    System.out.println(problem.orElse(""));
  }
}
