package dct.ui.shell;

import dct.core.Decimals;
import dct.core.degree.Preference;
import dct.core.degree.SearchLimits;
import dct.core.triangulate.Domain;
import dct.experiment.study.StudyPlan;
import dct.problem.Method;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A call of the program on the command line: {@code dct VERB …}. Files are named by their absolute
 * paths, so that it can be made in every folder.
 *
 * @param words its words behind "dct", the verb first, not yet quoted
 */
public record ProgramCall(List<String> words) {

  /** The list is copied. */
  public ProgramCall {
    words = List.copyOf(words);
  }

  private static ProgramCall of(String... words) {
    return new ProgramCall(List.of(words));
  }

  private ProgramCall with(String... more) {
    List<String> all = new ArrayList<>(words);
    all.addAll(List.of(more));
    return new ProgramCall(all);
  }

  /** With an option and its value; a value that looks like an option is tied to its name. */
  private ProgramCall option(String name, String value) {
    return value.startsWith("-") ? with(name + "=" + value) : with(name, value);
  }

  private static String name(Path file) {
    return file.toAbsolutePath().normalize().toString();
  }

  /** Whether a file can be triangulated. */
  public static ProgramCall check(Path file, Domain domain) {
    return of("check", name(file), "--as", domain.word());
  }

  /** A file, taken for this, triangulated by a method. */
  public static ProgramCall triangulate(Path file, Domain as, Method method) {
    return of("triangulate", name(file), "--as", as.word(), "--algorithm", method.word());
  }

  /** This call with Scan-Flip on what the method made. */
  public ProgramCall flip() {
    return with("--flip");
  }

  /** This call with a search for the best triangulation. */
  public ProgramCall optimize(String goal, SearchLimits limits) {
    SearchLimits usual = SearchLimits.DEFAULT;
    ProgramCall call = option("--optimize", goal).option("--seed", Long.toString(limits.seed()));
    if (limits.effort() != usual.effort()) {
      call = call.option("--effort", Decimals.format(limits.effort()));
    }
    return Double.isFinite(limits.seconds())
        ? call.option("--time-limit", Decimals.format(limits.seconds()))
        : call;
  }

  /** The same with a search for what a file of wishes wishes. */
  public ProgramCall optimize(Path wishes, SearchLimits limits) {
    return optimize(name(wishes), limits);
  }

  /** This call with what is preferred among equally good triangulations, or none. */
  public ProgramCall prefer(Optional<Preference.Kind> kind) {
    if (kind.equals(Optional.of(Preference.Kind.ANGLE))) {
      return this; // the default
    }
    return option("--prefer", kind.map(Preference.Kind::word).orElse("none"));
  }

  /** This call with a file that what it makes is written to. */
  public ProgramCall writing(Path file) {
    return option("-o", name(file));
  }

  /**
   * Random sites, or a random polygon or region, of this shape, in the area that such a number
   * needs.
   */
  public static ProgramCall generate(Domain domain, int n, String shape, long seed) {
    return of("generate", domain.word(), "-n", Integer.toString(n), "--shape", shape)
        .option("--seed", Long.toString(seed));
  }

  /** This call with so many holes. */
  public ProgramCall holes(int count) {
    return with("--holes", Integer.toString(count));
  }

  /** This call with another area. */
  public ProgramCall area(int width, int height) {
    return with("--area", width + "x" + height);
  }

  /** This call with real coordinates. */
  public ProgramCall real() {
    return with("--real");
  }

  /** A study of this plan: of points, polygons or annuli. */
  public static ProgramCall experiment(String what, StudyPlan plan) {
    String sizes =
        plan.sizes().stream().map(size -> Integer.toString(size)).collect(Collectors.joining(","));
    return of(
            "experiment",
            what,
            "--shapes",
            String.join(",", plan.shapes()),
            "--sizes",
            sizes,
            "--sets",
            Integer.toString(plan.sets()))
        .option("--seed", Long.toString(plan.seed()));
  }

  /** The whole line as the shell of this machine takes it. */
  public String line() {
    return "dct " + ShellWords.join(words);
  }
}
