package dct.io;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.Flip;
import dct.core.degree.FlipList;
import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RandomSites;
import dct.problem.Comparison;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Post;
import dct.problem.Solution;
import dct.problem.verify.Claims;
import dct.problem.verify.Restoration;
import dct.problem.verify.Verdict;
import dct.problem.verify.Verdict.Outcome;
import dct.problem.verify.Verifier;
import dct.testing.HandFlips;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Solutions with flips by hand: what is written of them verifies and comes back. */
class FlippedResultTest {

  /** A solution under the name of how it came to be. */
  record Made(String how, Solution solution) {
    @Override
    public String toString() {
      return how;
    }
  }

  private static Instance sites() {
    return Instance.of(Domain.SITES, "sites", RandomSites.uniform(50, 5), Progress.NONE);
  }

  private static Instance polygon() {
    return Instance.of(
        Domain.POLYGON,
        "polygon",
        PolygonShape.of("two-opt").orElseThrow().generate(40, 3).points(),
        Progress.NONE);
  }

  private static Solution flipped(Solution solution) {
    return solution.flipped(HandFlips.of(solution.triangulation(), 12));
  }

  static Stream<Made> solutions() {
    Stream<Made> byMethod =
        Arrays.stream(Method.values())
            .flatMap(
                method -> {
                  Instance instance = method.application() == Domain.SITES ? sites() : polygon();
                  Solution made = Solution.of(instance, method, Progress.NONE);
                  return Stream.of(
                      new Made(method + ", by hand", flipped(made)),
                      new Made(
                          method + ", Scan-Flip, by hand", flipped(made.flipped(Progress.NONE))));
                });
    Solution delaunay = Solution.of(sites(), Method.DELAUNAY, Progress.NONE);
    Solution best = delaunay.optimized(SearchLimits.DEFAULT, Progress.NONE);
    Solution read = Solution.read(sites(), delaunay.triangulation());
    Solution odd =
        Solution.of(polygon().with(ParityGoal.allOdd(40)), Method.MONOTONE, Progress.NONE)
            .optimized(SearchLimits.DEFAULT, Progress.NONE);
    return Stream.concat(
        byMethod,
        Stream.of(
            new Made("read from a file", read),
            new Made("read, by hand", flipped(read)),
            new Made("read, optimum", read.optimized(SearchLimits.DEFAULT, Progress.NONE)),
            new Made("optimum, by hand", flipped(best)),
            new Made("optimum, Scan-Flip of nothing", best.flipped(Progress.NONE)),
            new Made("most odd, by hand", flipped(odd)),
            new Made("optimum for other wishes", best.wishing(ParityGoal.allOdd(50))),
            new Made("by hand, other wishes", flipped(delaunay).wishing(ParityGoal.allOdd(50)))));
  }

  @ParameterizedTest
  @MethodSource("solutions")
  void it_verifies_and_comes_back(Made made) {
    Solution solution = made.solution;
    Claims claims = ResultJson.claims(solution);
    Verdict verdict = Verifier.verify(claims, Optional.of(solution.instance()), Progress.NONE);
    assertThat(verdict.outcome()).as(verdict.toString()).isEqualTo(Outcome.TRUE);
    Solution back = Restoration.of(claims, Progress.NONE);
    assertThat(Comparison.of(back.triangulation(), solution.triangulation()).isSame()).isTrue();
    assertThat(back.method()).isEqualTo(solution.method());
    assertThat(back.post()).isEqualTo(solution.post());
    assertThat(back.counts()).isEqualTo(solution.counts());
    assertThat(back.countsBefore()).isEqualTo(solution.countsBefore());
    assertThat(back.bound().value()).isEqualTo(solution.bound().value());
    assertThat(back.unmet()).isEqualTo(solution.unmet());
    assertThat(back.isProven()).isEqualTo(solution.isProven());
    assertThat(back.triangulation().count(EdgeKind.FLIPPED))
        .isEqualTo(solution.triangulation().count(EdgeKind.FLIPPED));
    List<Flip> mine = flips(solution);
    List<Flip> its = flips(back);
    assertThat(its).hasSameSizeAs(mine);
    for (int i = 0; i < mine.size(); i++) {
      assertThat(its.get(i).isSameAs(mine.get(i))).isTrue();
    }
    assertThat(ResultJson.summary(back, Optional.empty()))
        .isEqualTo(ResultJson.summary(solution, Optional.empty()));
  }

  private static List<Flip> flips(Solution solution) {
    return solution.flips().map(flips -> FlipList.of(flips).flips()).orElse(List.of());
  }

  @Test
  void a_flip_by_hand_is_one_step_more_and_keeps_the_bound() {
    Solution best =
        Solution.of(sites(), Method.DELAUNAY, Progress.NONE)
            .optimized(SearchLimits.DEFAULT, Progress.NONE);
    Triangulation triangulation = best.triangulation();
    int edge = 0;
    while (Flip.at(triangulation, edge).stream().noneMatch(f -> f.evenGain(triangulation) < 0)) {
      edge++;
    }
    Solution worse = best.flippedAt(edge);
    int loss = -Flip.at(triangulation, edge).orElseThrow().evenGain(triangulation);
    assertThat(best.post()).isEqualTo(Post.OPTIMIZE);
    assertThat(worse.post()).isEqualTo(Post.OPTIMIZE_FLIP);
    assertThat(worse.counts().odd()).isEqualTo(best.counts().odd() + loss);
    assertThat(worse.bound()).isEqualTo(best.bound());
    assertThat(best.isProven()).isTrue();
    assertThat(worse.isProven()).isFalse();
    assertThat(worse.verdict()).doesNotContain("optimal").doesNotContain("best found");
    Solution again = worse.flippedAt(edge);
    assertThat(again.flips().orElseThrow().edges()).containsExactly(edge, edge);
    assertThat(again.isProven()).isTrue();
    assertThat(again.verdict()).isEqualTo(best.verdict());
    assertThat(again.countsBefore()).contains(best.counts());
  }

  @Test
  void flips_by_hand_follow_those_of_scan_flip() {
    Solution delaunay = Solution.of(sites(), Method.DELAUNAY, Progress.NONE);
    Solution scanned = delaunay.flipped(Progress.NONE);
    Solution both = flipped(scanned);
    int first = scanned.flips().orElseThrow().flips();
    assertThat(both.flips().orElseThrow().edges().subList(0, first))
        .isEqualTo(scanned.flips().orElseThrow().edges());
    assertThat(both.countsBefore()).contains(DegreeCount.of(delaunay.triangulation()));
    Solution part = both.withFlips(scanned.flips().orElseThrow());
    assertThat(part.triangulation()).isSameAs(scanned.triangulation());
  }

  private static String text(Solution solution) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ResultJson.write(out, solution, Optional.empty());
    return out.toString(StandardCharsets.UTF_8);
  }

  private static Verdict verify(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    Claims claims = ResultJson.read("forged.json", new ByteArrayInputStream(bytes));
    return Verifier.verify(claims, Optional.empty(), Progress.NONE);
  }

  @Test
  void without_a_list_the_flips_of_scan_flip_still_verify() throws IOException {
    Solution scanned = Solution.of(sites(), Method.DELAUNAY, Progress.NONE).flipped(Progress.NONE);
    String listed = text(scanned);
    String unlisted = listed.replaceFirst("(?s), \"flipList\": \\[[^\"]*]]", "");
    assertThat(unlisted).isNotEqualTo(listed).doesNotContain("flipList");
    assertThat(verify(unlisted).outcome()).isEqualTo(Outcome.TRUE);
    assertThat(
            verify(text(flipped(scanned)).replaceFirst("(?s), \"flipList\": \\[[^\"]*]]", ""))
                .outcome())
        .isEqualTo(Outcome.FALSE);
  }

  @Test
  void a_forged_list_is_refuted_at_its_line() throws IOException {
    String truth = text(flipped(Solution.of(sites(), Method.DELAUNAY, Progress.NONE)));
    String[] lines = truth.split("\n", -1);
    int first = 0;
    while (!lines[first].contains("flipList")) {
      first++;
    }
    assertThat(lines.length - first).isGreaterThan(12);
    for (int i = first + 1; i < lines.length - 2; i++) {
      String[] forged = lines.clone();
      forged[i] = Pattern.compile("\\d+, ").matcher(lines[i]).replaceFirst("48, ");
      Verdict verdict = verify(String.join("\n", forged));
      Verdict.Check last = verdict.checks().get(verdict.checks().size() - 1);
      assertThat(verdict.outcome()).as(forged[i]).isEqualTo(Outcome.FALSE);
      assertThat(last.what()).isEqualTo("the flips");
      forged[i] = "[7, 50, 8, 9],";
      assertThat(verify(String.join("\n", forged)).outcome()).isEqualTo(Outcome.FALSE);
    }
  }

  @Test
  void kinds_that_the_list_does_not_bear_out_are_refuted() throws IOException {
    String truth = text(flipped(Solution.of(sites(), Method.DELAUNAY, Progress.NONE)));
    Verdict less = verify(truth.replaceFirst("\"flipped\"", "\"diagonal\""));
    Verdict more = verify(truth.replaceFirst("\"diagonal\"", "\"flipped\""));
    assertThat(less.first(Outcome.FALSE).orElseThrow().detail()).endsWith("came from a flip");
    assertThat(more.first(Outcome.FALSE).orElseThrow().detail())
        .endsWith("did not come from a flip");
    assertThat(verify(truth.replaceFirst("\"flips\": \\d+", "\"flips\": 3")).outcome())
        .isEqualTo(Outcome.FALSE);
  }
}
