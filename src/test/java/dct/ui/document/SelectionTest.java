package dct.ui.document;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.ui.job.Jobs;
import java.util.BitSet;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Selections, the edits of all that is selected, and how selections follow the history. */
class SelectionTest {
  private static final Points SEVEN = Points.ofPairs(0, 0, 9, 0, 9, 9, 5, 9, 5, 5, 3, 5, 0, 9);

  @Test
  void theNumbersOfTheSelectedVerticesComeInTheirOrder() {
    Selection selection = Selection.of(5, 2, 3).toggled(3).toggled(0);
    assertThat(selection.numbers()).containsExactly(0, 2, 5);
    assertThat(selection.count()).isEqualTo(3);
    assertThat(selection.last()).isEqualTo(5);
    assertThat(selection.has(3)).isFalse();
    assertThat(selection.of(SEVEN)).isEqualTo(Points.ofPairs(0, 0, 9, 9, 3, 5));
    assertThat(selection.or(Selection.range(1, 4)).numbers()).containsExactly(0, 1, 2, 3, 5);
  }

  @Test
  void revertUndoesApplyForEveryEditOfMany() {
    long seed = 31;
    Random random = new Random(seed);
    for (int i = 0; i < 200; i++) {
      Document document = randomDocument(random);
      Selection some = randomSelection(random, document.size());
      Points places = Selection.range(0, some.count()).of(randomPoints(random, some.count()));
      int first = random.nextInt(document.size() + 1);
      Points added = randomPoints(random, 1 + random.nextInt(4));
      for (Edit edit :
          List.of(
              BulkEdit.move(document, some, places),
              BulkEdit.delete("Cut", document, some),
              BulkEdit.insert("Paste", document, first, added, wishes(random, added.size())))) {
        Document after = edit.apply(document);
        assertThat(after.wishes().size()).isEqualTo(after.size());
        assertThat(edit.revert(after)).as("seed %d, %d, %s", seed, i, edit).isEqualTo(document);
      }
    }
  }

  @Test
  void editsOfManyDoWhatTheirNamesSay() {
    Document document =
        new Document(Domain.POLYGON, Points.ofPairs(0, 0, 9, 0, 9, 9, 0, 9))
            .with(ParityGoal.of(Wish.EVEN, Wish.ODD, Wish.ANY, Wish.EVEN));
    Edit delete = BulkEdit.delete("Delete", document, Selection.of(0, 2));
    assertThat(delete.label()).isEqualTo("Delete 2 Vertices");
    assertThat(delete.apply(document).points()).isEqualTo(Points.ofPairs(9, 0, 0, 9));
    assertThat(delete.apply(document).wishes()).isEqualTo(ParityGoal.of(Wish.ODD, Wish.EVEN));
    Edit insert =
        BulkEdit.insert("Paste", document, 1, Points.ofPairs(4, -1), ParityGoal.allOdd(1));
    assertThat(insert.label()).isEqualTo("Paste 1 Vertex");
    assertThat(insert.apply(document).points())
        .isEqualTo(Points.ofPairs(0, 0, 4, -1, 9, 0, 9, 9, 0, 9));
    Edit move = BulkEdit.move(document, Selection.of(1, 3), Points.ofPairs(8, 1, 1, 8));
    assertThat(move.label()).isEqualTo("Move 2 Vertices");
    assertThat(move.apply(document).points()).isEqualTo(Points.ofPairs(0, 0, 8, 1, 9, 9, 1, 8));
    assertThat(BulkEdit.words(5, Domain.SITES)).isEqualTo("5 Sites");
  }

  private static Document randomDocument(Random random) {
    int n = 1 + random.nextInt(12);
    return new Document(Domain.SITES, randomPoints(random, n)).with(wishes(random, n));
  }

  private static Points randomPoints(Random random, int n) {
    return Points.ofPairs(random.doubles(2L * n).toArray());
  }

  private static ParityGoal wishes(Random random, int n) {
    Wish[] wishes = new Wish[n];
    java.util.Arrays.setAll(wishes, v -> List.of(Wish.values()).get(random.nextInt(3)));
    return ParityGoal.of(wishes);
  }

  private static Selection randomSelection(Random random, int n) {
    BitSet set = new BitSet();
    for (int v = 0; v < n; v++) {
      set.set(v, random.nextBoolean());
    }
    set.set(random.nextInt(n));
    return Selection.of(set);
  }

  @Test
  void aSelectionFollowsEditsAndTheHistory() {
    Editor editor = new Editor(Domain.SITES, new Jobs());
    editor.load(new Document(Domain.SITES, SEVEN), "seven");
    editor.select(Selection.of(2, 5));
    editor.perform(Edit.delete(editor.document(), 0));
    assertThat(editor.selection()).isEqualTo(Selection.of(1, 4));
    editor.perform(Edit.move(editor.document(), 3, 6, 6));
    assertThat(editor.selection()).isEqualTo(Selection.of(1, 4));
    Points nine = Points.ofPairs(9, 4);
    editor.perform(BulkEdit.insert("Paste", editor.document(), 1, nine, ParityGoal.allEven(1)));
    assertThat(editor.selection()).isEqualTo(Selection.of(2, 5));
    editor.perform(BulkEdit.delete("Delete", editor.document(), Selection.of(0, 1)));
    assertThat(editor.selection()).isEqualTo(Selection.of(0, 3));
    editor.undo();
    editor.undo();
    editor.undo();
    editor.undo();
    assertThat(editor.document().points()).isEqualTo(SEVEN);
    assertThat(editor.selection()).isEqualTo(Selection.of(2, 5));
  }

  @Test
  void otherPointsAltogetherAreNotSelected() {
    Editor editor = new Editor(Domain.SITES, new Jobs());
    editor.load(new Document(Domain.SITES, SEVEN), "seven");
    editor.select(Selection.of(2, 5));
    editor.perform(
        Edit.replace(
            "Other", editor.document(), Points.ofPairs(new Random(3).doubles(14).toArray())));
    assertThat(editor.selection().isEmpty()).isTrue();
  }

  @Test
  void thousandsOfAMillionAreDeletedInOneStep() {
    int n = 1_000_000;
    Document document = new Document(Domain.SITES, randomPoints(new Random(5), n));
    BitSet odd = new BitSet();
    for (int v = 1; v < n; v += 2) {
      odd.set(v);
    }
    Selection selection = Selection.of(odd);
    Edit edit = BulkEdit.delete("Delete", document, selection);
    Document after = edit.apply(document);
    assertThat(after.size()).isEqualTo(n / 2);
    assertThat(after.points().x(1234)).isEqualTo(document.points().x(2468));
    assertThat(edit.revert(after)).isEqualTo(document);
    assertThat(Selection.of(0, 2).following(document.points(), after.points()))
        .isEqualTo(Selection.of(0, 1));
  }
}
