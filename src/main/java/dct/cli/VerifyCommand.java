package dct.cli;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import dct.core.Progress;
import dct.io.ClaimsFile;
import dct.io.format.Choice;
import dct.io.format.NoTriangulation;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.verify.Claims;
import dct.problem.verify.FalseClaim;
import dct.problem.verify.Verdict;
import dct.problem.verify.Verdict.Check;
import dct.problem.verify.Verdict.Outcome;
import dct.problem.verify.Verifier;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** {@code dct verify}: whether a result file tells the truth. */
final class VerifyCommand extends Verb {
  private static final String TRIANGULATION = "a triangulation of the domain";

  private final PositionalParamSpec result =
      parameter(
          "RESULT",
          "The result, or a file of triangles or edges of another program; - is standard input.");
  private final OptionSpec inputFile =
      option(
          "--input",
          "FILE",
          String.class,
          "Compare its points, and how many duplicates were merged, with this input.");
  private final OptionSpec pick =
      option("--pick", "N", Integer.class, "Which of several triangulations in a file, from 1 on.");
  private final OptionSpec json = flag("--json", "Print the checks as one JSON object.");
  private final OptionSpec quiet = flag("--quiet", "Print nothing; the exit status tells.");

  VerifyCommand(Console console) {
    super(
        console,
        "Checks a result independently.",
        "Takes a whole result (triangulate -o RESULT.json) and believes nothing in it: planar,"
            + " covers the domain, degrees recounted, flips undone and recounted, Delaunay or cut"
            + " into convex or monotone pieces where claimed, the lower bound recomputed. Of a file"
            + " of another program, that its triangles or edges are a triangulation.",
        "Exit status: 0 everything claimed was recomputed, 4 something is false, 5 something"
            + " claimed cannot be recomputed.");
    examples("dct verify result.json");
  }

  @Override
  boolean isSilent() {
    return isSet(quiet);
  }

  @Override
  public Integer call() throws IOException {
    String name = result.getValue();
    if (name.equals(STANDARD_STREAM) && name.equals(inputFile.getValue())) {
      throw new UsageException("RESULT and --input both want standard input, name a file");
    }
    Verdict verdict;
    try {
      Claims claims = claims(name);
      verdict = Verifier.verify(claims, input(claims), Progress.NONE);
      if (isPrinted() && verdict.outcome() != Outcome.FALSE) {
        print(name, claims, verdict);
      }
    } catch (NoTriangulation none) {
      Check check = new Check(TRIANGULATION, Outcome.FALSE, none.cause(), none.line());
      verdict = new Verdict(List.of(check));
    }
    if (isSet(json)) {
      console().print(json(name, verdict).toString());
    } else if (isPrinted()) {
      verdict.first(Outcome.FALSE).ifPresent(check -> printFault(name, check));
    }
    return switch (verdict.outcome()) {
      case TRUE -> CommandLineProgram.DONE;
      case FALSE -> CommandLineProgram.FALSE_RESULT;
      case OPEN -> CommandLineProgram.OPEN_RESULT;
    };
  }

  private Optional<Instance> input(Claims claims) throws IOException {
    String file = inputFile.getValue();
    if (file == null) {
      return Optional.empty();
    }
    Choice choice = claims.domain().map(Choice.NONE::otherwise).orElse(Choice.NONE);
    return Optional.of(
        InputParameters.read(file, choice, console(), Progress.NONE).instance(Progress.NONE));
  }

  private Claims claims(String name) throws IOException {
    Integer number = pick.getValue();
    Choice choice = number == null ? Choice.NONE : Choice.NONE.picking(number);
    return name.equals(STANDARD_STREAM)
        ? ClaimsFile.read(name, console().in(), choice)
        : ClaimsFile.read(InputParameters.path(name), choice, Progress.NONE);
  }

  private boolean isPrinted() {
    return !isSet(json) && !isSet(quiet);
  }

  private void printFault(String name, Check check) {
    String sentence = check.detail() + FalseClaim.CURE;
    console().err().println(new BadInputException(name, check.line(), sentence).getMessage());
  }

  private void print(String name, Claims claims, Verdict verdict) throws IOException {
    StringBuilder text = new StringBuilder(Shown.harmless(name)).append(": ");
    text.append(
        verdict.outcome() == Outcome.TRUE ? "verified: " : "true as far as it could be verified: ");
    text.append(claims.points().size());
    text.append(' ').append(claims.domain().orElseThrow().vertices());
    text.append(" triangulated by ").append(method(claims));
    text.append(", ").append(claims.whole("even").orElseThrow()).append(" even");
    text.append(", ").append(claims.whole("odd").orElseThrow()).append(" odd");
    for (Check check : verdict.checks()) {
      text.append(check.detail().isEmpty() ? "" : "; " + check.what() + ": " + check.detail());
    }
    console().print(text.toString());
  }

  private static String method(Claims claims) {
    String word = claims.text("algorithm").orElseThrow();
    return word.equals(Method.UNKNOWN) ? "an unknown method" : word;
  }

  private static JsonObject json(String name, Verdict verdict) {
    JsonArray checks = new JsonArray();
    for (Check check : verdict.checks()) {
      JsonObject each = new JsonObject();
      each.addProperty("what", check.what());
      each.addProperty("outcome", word(check.outcome()));
      each.addProperty("detail", check.detail());
      if (check.outcome() == Outcome.FALSE) {
        each.addProperty("line", check.line());
      }
      checks.add(each);
    }
    JsonObject object = new JsonObject();
    object.addProperty("result", name);
    object.addProperty("verdict", word(verdict.outcome()));
    object.add("checks", checks);
    return object;
  }

  private static String word(Outcome outcome) {
    return outcome.name().toLowerCase(Locale.ROOT);
  }
}
