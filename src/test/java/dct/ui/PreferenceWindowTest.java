package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.Preference;
import dct.core.degree.Preferred;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Method;
import dct.problem.Solution;
import dct.ui.document.Document;
import dct.ui.session.Session;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Triangulate ▸ Prefer, beside Most Even Vertices. */
class PreferenceWindowTest extends WindowTest {
  private static final double[] POLYGON = {
    100, 100, 300, 160, 500, 100, 620, 240, 520, 400, 330, 330, 200, 450, 60, 300
  };

  private void perform(String command) {
    onEventThread(
        () -> {
          window.commands().get(command).perform();
          return null;
        });
    settle();
  }

  private Optional<Solution> solution() {
    return window.workbench().editor(Domain.POLYGON).document().result().map(r -> r.solution());
  }

  private void prefer(String title) {
    frame.menuItem("Triangulate").click();
    clickMenu("Prefer");
    clickMenu("Prefer " + title);
    settle();
  }

  /** Draws, chooses and searches; nothing if nothing was preferred. */
  private Preferred mostEven(String preferred) {
    choose("Polygon Based");
    clickAt(POLYGON);
    if (!preferred.isEmpty()) {
      prefer(preferred);
    }
    perform("Most Even Vertices");
    await("the result", () -> solution().isPresent());
    return onEventThread(() -> solution().orElseThrow().preferred().orElse(null));
  }

  @Test
  void the_largest_smallest_angle_is_preferred_unless_another_is_chosen() {
    Preferred found = mostEven("");
    assertThat(found.preference()).isEqualTo(Preference.ANGLE);
    assertThat(found.isProven()).isTrue();
    await(
        "the words", () -> frame.label("status").text().startsWith("Most Even Vertices: smallest"));
  }

  @Test
  void the_choice_is_followed_and_remembered() throws Exception {
    Preferred found = mostEven("Least Total Length");
    assertThat(found.preference()).isEqualTo(Preference.LENGTH);
    assertThat(found.isProven()).isTrue();
    session.journals().await();
    assertThat(Session.in(state).settings().get("prefer")).contains("length");
  }

  @Test
  void edges_are_kept_of_what_the_search_begins_with() {
    Preferred found = mostEven("Most Edges Kept");
    assertThat(found.preference()).isEqualTo(Preference.keeping(monotone()));
  }

  @Test
  void nothing_need_be_preferred() {
    assertThat(mostEven("Nothing")).isNull();
  }

  private Triangulation monotone() {
    Document drawn = new Document(Domain.POLYGON, points());
    return Solution.of(drawn.instance("", Progress.NONE), Method.MONOTONE, Progress.NONE)
        .triangulation();
  }
}
