package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.SearchLimits;
import dct.core.triangulate.Domain;
import dct.experiment.study.StudyPlan;
import dct.problem.Method;
import dct.ui.shell.ProgramCall;
import dct.ui.shell.ShellWords;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import picocli.CommandLine;
import picocli.CommandLine.ParseResult;

/** The calls that the window copies are understood by the command line as they were meant. */
class ProgramCallTest {
  private static final Path FILE = Path.of("odd folder/it's $5.txt").toAbsolutePath();

  private static ParseResult parse(Verb verb, ProgramCall call) {
    CommandLine command = new CommandLine(verb.spec()).setExpandAtFiles(false);
    List<String> arguments = call.words().subList(1, call.words().size());
    return command.parseArgs(arguments.toArray(String[]::new));
  }

  private static Console console() {
    return new Console(InputStream.nullInputStream(), System.out, System.err);
  }

  @SuppressWarnings("TypeParameterUnusedInFormals") // as picocli has it
  private static <T> T option(ParseResult parsed, String name) {
    return parsed.matchedOptionValue(name, null);
  }

  @ParameterizedTest
  @EnumSource(Method.class)
  void aMethodIsCalledByItsWord(Method method) {
    Domain domain = method.application();
    ProgramCall call = ProgramCall.triangulate(FILE, domain, method).flip();
    assertThat(call.words()).startsWith("triangulate");
    ParseResult parsed = parse(new TriangulateCommand(console()), call);
    assertThat(parsed.<String>matchedPositionalValue(0, null)).isEqualTo(FILE.toString());
    assertThat(ProgramCallTest.<String>option(parsed, "--algorithm")).isEqualTo(method.word());
    assertThat(ProgramCallTest.<String>option(parsed, "--as")).isEqualTo(domain.word());
    assertThat(ProgramCallTest.<Boolean>option(parsed, "--flip")).isTrue();
    assertThat(parsed.matchedOptions()).hasSize(3);
  }

  @Test
  void aSearchKeepsItsLimits() {
    SearchLimits limits = new SearchLimits(-7, 2.5, 0.1);
    ProgramCall call =
        ProgramCall.triangulate(FILE, Domain.SITES, Method.DELAUNAY)
            .optimize("odd", limits)
            .writing(FILE);
    ParseResult parsed = parse(new TriangulateCommand(console()), call);
    assertThat(ProgramCallTest.<String>option(parsed, "--optimize")).isEqualTo("odd");
    assertThat(ProgramCallTest.<Long>option(parsed, "--seed")).isEqualTo(-7);
    assertThat(ProgramCallTest.<Double>option(parsed, "--effort")).isEqualTo(2.5);
    assertThat(ProgramCallTest.<Double>option(parsed, "--time-limit")).isEqualTo(0.1);
    assertThat(ProgramCallTest.<List<String>>option(parsed, "-o")).containsExactly(FILE.toString());
    assertThat(parsed.matchedOptions()).hasSize(7);
  }

  @Test
  void theUsualLimitsAreNotSaid() {
    ProgramCall call =
        ProgramCall.triangulate(FILE, Domain.REGION, Method.MONOTONE)
            .optimize(FILE, SearchLimits.DEFAULT);
    assertThat(call.words()).doesNotContain("--effort", "--time-limit");
    ParseResult parsed = parse(new TriangulateCommand(console()), call);
    assertThat(ProgramCallTest.<String>option(parsed, "--optimize")).isEqualTo(FILE.toString());
  }

  @Test
  void randomPointsKeepShapeSeedAndArea() {
    ProgramCall call =
        ProgramCall.generate(Domain.SITES, 50, "clusters", -3).area(2000, 300).real();
    ParseResult parsed = parse(new GenerateCommand(console()), call);
    assertThat(parsed.<String>matchedPositionalValue(0, null)).isEqualTo("points");
    assertThat(ProgramCallTest.<Integer>option(parsed, "-n")).isEqualTo(50);
    assertThat(ProgramCallTest.<String>option(parsed, "--shape")).isEqualTo("clusters");
    assertThat(ProgramCallTest.<Long>option(parsed, "--seed")).isEqualTo(-3);
    assertThat(ProgramCallTest.<String>option(parsed, "--area")).isEqualTo("2000x300");
    assertThat(ProgramCallTest.<Boolean>option(parsed, "--real")).isTrue();
    assertThat(parsed.matchedOptions()).hasSize(5);
  }

  @Test
  void aStudyKeepsItsPlan() {
    StudyPlan plan = new StudyPlan(List.of("uniform", "disk"), List.of(50, 100), 3, 9);
    ProgramCall call = ProgramCall.experiment("points", plan);
    ParseResult parsed = parse(new ExperimentCommand(console()), call);
    assertThat(parsed.<String>matchedPositionalValue(0, null)).isEqualTo("points");
    assertThat(ProgramCallTest.<String>option(parsed, "--shapes")).isEqualTo("uniform,disk");
    assertThat(ProgramCallTest.<String>option(parsed, "--sizes")).isEqualTo("50,100");
    assertThat(ProgramCallTest.<Integer>option(parsed, "--sets")).isEqualTo(3);
    assertThat(ProgramCallTest.<Long>option(parsed, "--seed")).isEqualTo(9);
    assertThat(parsed.matchedOptions()).hasSize(4);
  }

  @Test
  void aCheckNamesTheKind() {
    ParseResult parsed = parse(new CheckCommand(console()), ProgramCall.check(FILE, Domain.SITES));
    assertThat(parsed.<String>matchedPositionalValue(0, null)).isEqualTo(FILE.toString());
    assertThat(ProgramCallTest.<String>option(parsed, "--as")).isEqualTo("points");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void aShellReadsTheWordsAsTheyAre() throws Exception {
    List<String> words =
        new ArrayList<>(
            List.of("plain", "two words", "it's", "$HOME", "a\"b", "`x`", "*", "é ü", "~", "a;b"));
    words.addAll(List.of("back\\slash", "", "line\nbreak", "#no", "!x", "{a,b}", "--seed=-5"));
    String line = "printf '%s\\0' " + ShellWords.join(words);
    Process shell = new ProcessBuilder("sh", "-c", line).redirectErrorStream(true).start();
    String out = new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(out.split("\0", -1)).containsExactly(with(words, ""));
  }

  private static String[] with(List<String> words, String last) {
    List<String> all = new ArrayList<>(words);
    all.add(last);
    return all.toArray(String[]::new);
  }

  @Test
  void theLineBeginsWithTheProgram() {
    assertThat(ProgramCall.generate(Domain.POLYGON, 9, "comb", 1).line())
        .isEqualTo("dct generate polygon -n 9 --shape comb --seed 1");
  }
}
