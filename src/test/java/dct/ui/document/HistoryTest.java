package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class HistoryTest {
  private static final int STEPS = 400;

  private final History history = new History(Document.empty(Domain.SITES));

  @Test
  void revertUndoesApplyForEveryEdit() {
    Document document =
        new Document(
            Domain.POLYGON,
            Points.ofPairs(0, 0, 9, 0, 5, 7),
            ParityGoal.of(Wish.EVEN, Wish.ODD, Wish.EVEN));
    List<Edit> edits =
        List.of(
            Edit.draw(document, 1, 6),
            Edit.split(document, 0, 1, 4, 0),
            Edit.delete(document, 1),
            Edit.move(document, 2, 8, 8),
            Edit.wish(document, 2, Wish.ANY),
            Edit.wishes("Load Wishes", document, ParityGoal.allOdd(3)),
            Edit.replace("Clear Canvas", document, Points.ofPairs()));
    for (Edit edit : edits) {
      Document after = edit.apply(document);
      assertThat(after).as(edit.label()).isNotEqualTo(document);
      assertThat(after.wishes().size()).as(edit.label()).isEqualTo(after.size());
      assertThat(edit.revert(after)).as(edit.label()).isEqualTo(document);
    }
    assertThat(edits)
        .extracting(Edit::label)
        .containsExactly(
            "Draw Vertex v3",
            "Split Vertex v1",
            "Delete Vertex v1",
            "Edit Vertex v2",
            "Wish Parity v2",
            "Load Wishes",
            "Clear Canvas");
  }

  @ParameterizedTest
  @EnumSource(
      value = Domain.class,
      names = {"POLYGON", "SITES"})
  void undoAndRedoWalkThroughAllStates(Domain domain) {
    long seed = 7;
    Random random = new Random(seed);
    History history = new History(Document.empty(domain));
    List<Document> states = new ArrayList<>(List.of(history.present()));
    for (int i = 0; i < STEPS; i++) {
      history.perform(randomEdit(random, history.present()));
      states.add(history.present());
    }
    for (int i = STEPS - 1; i >= 0; i--) {
      history.undo();
      assertThat(history.present()).as("seed %d, state %d", seed, i).isEqualTo(states.get(i));
    }
    history.undo();
    assertThat(history.present()).isEqualTo(states.get(0));
    for (int i = 1; i <= STEPS; i++) {
      history.redo();
      assertThat(history.present()).as("seed %d, state %d", seed, i).isEqualTo(states.get(i));
    }
  }

  private static Edit randomEdit(Random random, Document document) {
    int n = document.size();
    double x = random.nextInt(100);
    double y = random.nextInt(100);
    int v = n == 0 ? 0 : random.nextInt(n);
    int w = (v + 1) % Math.max(1, n);
    int kinds = document.domain() == Domain.SITES ? 6 : 9;
    return switch (n < 3 ? 0 : random.nextInt(kinds)) {
      case 0 -> Edit.draw(document, x, y);
      case 1 -> Edit.split(document, v, w, x, y);
      case 5 -> BulkEdit.delete("Delete", document, Selection.of(v, w));
      case 6 -> Edit.layout("New Hole", document, document.layout().withHole(n));
      case 7 -> Edit.site(document, x, y);
      case 8 -> fixed(document, v, random.nextInt(n));
      case 2 -> Edit.delete(document, random.nextInt(n));
      case 3 ->
          Edit.wish(document, random.nextInt(n), List.of(Wish.values()).get(random.nextInt(3)));
      default -> Edit.move(document, random.nextInt(n), x, y);
    };
  }

  private static Edit fixed(Document document, int u, int v) {
    return u == v || (document.rings().isEdge(u, v) && !document.rings().isFixed(u, v))
        ? Edit.wish(document, u, Wish.ANY)
        : Edit.layout("Fix", document, document.layout().toggled(u, v, document.size()));
  }

  @Test
  void aWishStaysWithItsVertex() {
    history.perform(Edit.draw(history.present(), 0, 0));
    history.perform(Edit.draw(history.present(), 9, 0));
    history.perform(Edit.wish(history.present(), 1, Wish.ODD));
    Points four = Points.ofPairs(4, 0);
    history.perform(BulkEdit.insert("Paste", history.present(), 1, four, ParityGoal.allEven(1)));
    assertThat(wishes()).isEqualTo(ParityGoal.of(Wish.EVEN, Wish.EVEN, Wish.ODD));
    history.perform(Edit.delete(history.present(), 0));
    history.perform(Edit.move(history.present(), 1, 8, 8));
    assertThat(wishes()).isEqualTo(ParityGoal.of(Wish.EVEN, Wish.ODD));
    history.perform(Edit.delete(history.present(), 1));
    assertThat(wishes()).isEqualTo(ParityGoal.of(Wish.EVEN));
    history.undo();
    assertThat(wishes()).isEqualTo(ParityGoal.of(Wish.EVEN, Wish.ODD));
  }

  private ParityGoal wishes() {
    return history.present().wishes();
  }

  @Test
  void wishesAreUnsavedUntilTheyAreSavedOrGone() {
    history.perform(Edit.draw(history.present(), 0, 0));
    assertThat(history.hasUnsavedWishes()).isFalse();
    history.perform(Edit.wish(history.present(), 0, Wish.ODD));
    assertThat(history.hasUnsavedWishes()).isTrue();
    history.markSaved(history.present());
    assertThat(history.isChanged()).as("the points").isFalse();
    assertThat(history.hasUnsavedWishes()).isTrue();
    history.markWishesSaved(history.present());
    assertThat(history.hasUnsavedWishes()).isFalse();
    history.perform(Edit.wish(history.present(), 0, Wish.ANY));
    assertThat(history.hasUnsavedWishes()).isTrue();
    history.perform(Edit.wish(history.present(), 0, Wish.EVEN));
    assertThat(history.hasUnsavedWishes()).isFalse();
  }

  @Test
  void wishesThatTheFileStillHoldsAreUnsavedWhenTheyAreTakenBack() {
    history.perform(Edit.draw(history.present(), 0, 0));
    history.perform(Edit.wish(history.present(), 0, Wish.ODD));
    history.markWholeSaved(history.present());
    assertThat(history.isUnsaved()).isFalse();
    history.undo();
    assertThat(history.isUnsaved()).isTrue();
    history.redo();
    assertThat(history.isUnsaved()).isFalse();
  }

  @Test
  void anEditForgetsWhatWasUndone() {
    history.perform(Edit.draw(history.present(), 1, 1));
    history.undo();
    assertThat(history.redoLabel()).contains("Draw Vertex v0");
    history.perform(Edit.draw(history.present(), 2, 2));
    assertThat(history.redoLabel()).isEmpty();
    assertThat(history.undoLabel()).contains("Draw Vertex v0");
  }

  @Test
  void aDocumentIsChangedUntilItIsSavedOrBackAtWhatWasSaved() {
    assertThat(history.isChanged()).isFalse();
    history.perform(Edit.draw(history.present(), 1, 1));
    assertThat(history.isChanged()).isTrue();
    history.undo();
    assertThat(history.isChanged()).isFalse();
    history.redo();
    history.markSaved(history.present());
    assertThat(history.isChanged()).isFalse();
    history.undo();
    assertThat(history.isChanged()).isTrue();
  }

  @Test
  void whatNoFileHoldsIsUnsavedUntilItIsSavedAndIsWhereUndoEnds() {
    History recovered =
        History.unsaved(new Document(Domain.SITES, Points.ofPairs(1, 1), ParityGoal.allOdd(1)));
    assertThat(recovered.isUnsaved()).isTrue();
    assertThat(recovered.hasUnsavedWishes()).isTrue();
    assertThat(recovered.undoLabel()).isEmpty();
    recovered.perform(Edit.delete(recovered.present(), 0));
    assertThat(recovered.isUnsaved()).as("also without any point").isTrue();
    recovered.undo();
    assertThat(recovered.isUnsaved()).isTrue();
    recovered.markWholeSaved(recovered.present());
    assertThat(recovered.isUnsaved()).isFalse();
  }
}
