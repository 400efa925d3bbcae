package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.geometry.SimplicityCheck;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RandomSites;
import dct.problem.Method;
import dct.problem.Solution;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Thousands of edits, flips and results, undone and redone. */
class WholeHistoryTest {
  private static final int STEPS = 2_000;
  private static final long SEED = 11;

  private final SeededRandom random = new SeededRandom(SEED);
  private int views = Result.OPENED;

  @ParameterizedTest
  @EnumSource(
      value = Domain.class,
      names = {"POLYGON", "SITES"})
  void everyStateComesBackWithItsResult(Domain domain) {
    History history = new History(new Document(domain, start(domain)));
    List<Document> states = new ArrayList<>(List.of(history.present()));
    int results = 0;
    for (int i = 0; i < STEPS; i++) {
      history.perform(step(history.present()));
      results += history.present().result().isPresent() ? 1 : 0;
      states.add(history.present());
    }
    assertThat(results).as("states with a result").isGreaterThan(STEPS / 10);
    for (int i = STEPS - 1; i >= 0; i--) {
      history.undo();
      assertThat(history.present()).as("undone to %d", i).isEqualTo(states.get(i));
    }
    for (int i = 1; i <= STEPS; i++) {
      history.redo();
      assertThat(history.present()).as("redone to %d", i).isEqualTo(states.get(i));
    }
  }

  private static Points start(Domain domain) {
    return domain == Domain.SITES
        ? RandomSites.uniform(12, 3)
        : PolygonShape.TWO_OPT.generate(12, 3).points();
  }

  /** A random edit; one that would leave nothing to triangulate is made only now and then. */
  private Edit step(Document document) {
    Edit edit = anyStep(document);
    boolean spoils =
        edit.apply(document).domain() == Domain.POLYGON
            && SimplicityCheck.firstDefect(edit.apply(document).points(), Progress.NONE)
                .isPresent();
    return spoils && random.nextInt(50) > 0
        ? Edit.wish(document, random.nextInt(document.size()), Wish.ODD)
        : edit;
  }

  private Edit anyStep(Document document) {
    int n = document.size();
    int v = random.nextInt(n);
    return switch (random.nextInt(10)) {
      case 0 -> n < 16 ? Edit.draw(document, place(), place()) : Edit.delete(document, v);
      case 1 ->
          n > 5 ? Edit.delete(document, v) : Edit.split(document, v, (v + 1) % n, place(), place());
      case 2 -> Edit.move(document, v, place(), place());
      case 3 -> Edit.wish(document, v, List.of(Wish.values()).get(random.nextInt(3)));
      case 4 -> Edit.result("None", document, Optional.empty());
      default -> made(document).orElseGet(() -> Edit.move(document, v, place(), place()));
    };
  }

  private double place() {
    return random.nextInt(1000);
  }

  /** A result of the points, if they can be triangulated. */
  private Optional<Edit> made(Document document) {
    try {
      Method method = Method.byDefault(document.domain());
      Solution plain =
          document
              .result()
              .map(Result::solution)
              .orElseGet(
                  () -> Solution.of(document.instance("", Progress.NONE), method, Progress.NONE));
      Solution solution =
          switch (random.nextInt(3)) {
            case 0 -> plain.flipped(Progress.NONE);
            case 1 -> plain.optimized(new SearchLimits(1, 0.1, 1), Progress.NONE);
            default -> plain;
          };
      int view = document.domain() == Domain.SITES ? Result.CANVAS : ++views;
      Result result = Result.of(view, "made", solution);
      return Optional.of(Edit.result("Make", document, Optional.of(result)));
    } catch (dct.core.geometry.InvalidGeometryException e) {
      return Optional.empty();
    }
  }
}
