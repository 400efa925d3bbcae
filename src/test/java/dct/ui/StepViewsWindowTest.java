package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.render.Viewport;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import org.junit.jupiter.api.Test;

/** What part of the plane is shown after Undo and Redo. */
class StepViewsWindowTest extends WindowTest {
  private static final double[] SITES = {100, 100, 500, 120, 300, 400};

  private Viewport view() {
    return onEventThread(() -> canvas().viewport());
  }

  private void perform(String command) {
    onEventThread(
        () -> {
          window.commands().get(command).perform();
          return null;
        });
    settle();
  }

  private void show(Viewport view) {
    onEventThread(
        () -> {
          canvas().setViewport(view);
          return null;
        });
  }

  private void makeRandomSites() {
    frame.button("Random Sites").click();
    fill(dialog().textBox("vertices"), "60");
    fill(dialog().textBox("area"), "9000x7000");
    answer(dialog(), "OK");
    await("the sites", () -> points().size() == 60);
    settle();
  }

  private void requireAllInSight() {
    assertThat(onEventThread(() -> canvas().isAllInSight())).isTrue();
  }

  @Test
  void undoOfRandomSitesShowsWhatWasShownBefore() {
    choose("Point Sites Based");
    clickAt(SITES);
    Viewport before = view().zoomed(1.5, 100, 100);
    show(before);
    makeRandomSites();
    requireAllInSight();
    Viewport fitted = view();
    assertThat(fitted.scale()).isLessThan(0.2);
    clickAt(1, 1); // on nothing
    perform("Undo");
    assertThat(points()).isEqualTo(Points.ofPairs(SITES));
    assertThat(view()).isEqualTo(before);
    perform("Redo");
    assertThat(view()).isEqualTo(fitted);
    perform("Undo");
    perform("Undo");
    assertThat(points().size()).isEqualTo(2);
    assertThat(view()).isEqualTo(before);
  }

  @Test
  void aClickAfterRandomSitesAddsNone() {
    choose("Point Sites Based");
    frame.checkBox("Draw Vertex").requireSelected();
    makeRandomSites();
    frame.checkBox("Edit Vertex").requireSelected();
    clickAt(4000, 3500);
    assertThat(points().size()).isEqualTo(60);
    perform("Flip Edge");
    makeRandomSites();
    assertThat(onEventThread(() -> window.workbench().tool().orElseThrow().name()))
        .isEqualTo("Flip Edge");
  }

  @Test
  void undoShowsTheDrawingWhereNothingOfItWouldBeInSight() {
    choose("Point Sites Based");
    clickAt(SITES);
    Viewport partly = view().panned(-300, 0);
    show(partly);
    perform("Undo");
    assertThat(view()).isEqualTo(partly);
    show(partly.panned(9000, 0));
    perform("Redo");
    assertThat(points().size()).isEqualTo(3);
    requireAllInSight();
    onEventThread(
        () -> {
          Editor editor = window.workbench().active().orElseThrow();
          editor.perform(
              Edit.replace("Paste", editor.document(), Points.ofPairs(9e6, 0, 9e6, 9, 9e6 + 9, 0)));
          return null;
        });
    perform("Fit");
    perform("Undo");
    requireAllInSight();
    perform("Redo");
    requireAllInSight();
  }
}
