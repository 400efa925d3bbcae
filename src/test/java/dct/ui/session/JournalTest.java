package dct.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.FileStamp;
import dct.problem.Method;
import dct.problem.Solution;
import dct.ui.document.BulkEdit;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.document.Layout;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import dct.ui.document.Selection;
import dct.ui.job.Jobs;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What an editor holds and no file does is in its journal. */
class JournalTest {
  @TempDir Path folder;
  private final Lane lane = new Lane();
  private final List<IOException> failures = new ArrayList<>();
  private final List<String> unread = new ArrayList<>();
  private Editor editor;

  @BeforeEach
  void begin() throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          editor = new Editor(Domain.POLYGON, new Jobs());
          new Journals(folder, lane).of(editor, failures::add);
        });
  }

  private void edit(Runnable edits) throws Exception {
    SwingUtilities.invokeAndWait(edits);
    lane.await();
    assertThat(failures).isEmpty();
  }

  private void perform(Edit edit) throws Exception {
    edit(() -> editor.perform(edit));
  }

  private List<Path> files() throws IOException {
    return files(folder);
  }

  private static List<Path> files(Path folder) throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.toList();
    }
  }

  /** The text of the one journal that there is. */
  private String text() throws IOException {
    Path journal =
        files().stream().filter(f -> f.toString().endsWith(".journal")).findFirst().orElseThrow();
    return Files.readString(journal);
  }

  /** What comes back of journals that a program left which was killed: copies without a lease. */
  private List<Orphan> comingBack(Path copies, String... texts) throws IOException {
    Files.createDirectories(copies);
    for (int i = 0; i < texts.length; i++) {
      Files.writeString(copies.resolve(i + ".journal"), texts[i]);
    }
    return new Journals(copies, lane).orphans(unread::add);
  }

  private Document back() throws IOException {
    Path copies = Files.createTempDirectory(folder, "copies");
    return comingBack(copies, text()).get(0).document();
  }

  @Test
  void everyKindOfEditComesBack() throws Exception {
    Random random = new Random(3);
    for (int i = 0; i < 150; i++) {
      Document document = editor.document();
      int n = document.size();
      int v = n == 0 ? 0 : random.nextInt(n);
      double x = random.nextDouble() * 1e-7;
      perform(
          switch (n < 3 ? 0 : random.nextInt(9)) {
            case 0 -> Edit.draw(document, x, i / 3.0);
            case 1 -> Edit.split(document, v, (v + 1) % n, x, -i);
            case 6 -> Edit.layout("New Hole", document, document.layout().withHole(n));
            case 7 -> Edit.site(document, x, i);
            case 8 -> Edit.layout("Fix", document, fixed(document, v, random.nextInt(n)));
            case 2 -> Edit.delete(document, v);
            case 3 -> Edit.move(document, v, 1e300, x);
            case 4 -> Edit.wish(document, v, i % 2 == 0 ? Wish.ANY : Wish.ODD);
            default ->
                Edit.replace(
                    "Random", document, Points.ofPairs(random.doubles(2 + 2L * v).toArray()));
          });
      assertThat(back()).as("edit " + i).isEqualTo(editor.document());
      if (i % 7 == 6) {
        edit(editor::undo);
        assertThat(back()).as("undone " + i).isEqualTo(editor.document());
      }
    }
  }

  private static Layout fixed(Document document, int u, int v) {
    return u == v || document.rings().isEdge(u, v)
        ? document.layout()
        : document.layout().toggled(u, v, document.size());
  }

  @Test
  void smallEditsOfManyVerticesAreSmall() throws Exception {
    Points many = Points.ofPairs(new Random(1).doubles(200_000).toArray());
    perform(Edit.replace("Many", editor.document(), many));
    int whole = text().length();
    perform(Edit.move(editor.document(), 50_000, 3, 4));
    perform(Edit.delete(editor.document(), 7));
    assertThat(text().length() - whole).isLessThan(100);
    assertThat(back()).isEqualTo(editor.document());
  }

  @Test
  void editsOfSomeOfManyVerticesAreAsLargeAsTheirNumber() throws Exception {
    Points many = Points.ofPairs(new Random(1).doubles(200_000).toArray());
    perform(Edit.replace("Many", editor.document(), many));
    int[] some = new Random(2).ints(1_000, 0, many.size()).distinct().toArray();
    Selection which = Selection.of(some);
    Points places = Points.ofPairs(new Random(3).doubles(2L * which.count()).toArray());
    int longest = 70 * which.count(); // two doubles and the line that says where
    for (Edit edit :
        List.of(
            BulkEdit.move(editor.document(), which, places),
            BulkEdit.delete("Delete", editor.document(), which))) {
      int length = text().length();
      perform(edit);
      assertThat(text().length() - length).as(edit.label()).isLessThan(longest);
      assertThat(back()).as(edit.label()).isEqualTo(editor.document());
    }
    for (Runnable step : List.<Runnable>of(editor::undo, editor::redo, editor::undo)) {
      int length = text().length();
      edit(step);
      assertThat(text().length() - length).isLessThan(longest);
      assertThat(back()).isEqualTo(editor.document());
    }
  }

  @Test
  void aLineWrittenByHalfIsIgnored() throws Exception {
    perform(Edit.draw(editor.document(), 10, 20));
    perform(Edit.draw(editor.document(), 30, 40));
    String before = text();
    Document two = editor.document();
    perform(Edit.draw(editor.document(), 50, 60));
    String after = text();
    for (int end = before.length(); end < after.length() - 1; end++) {
      Path copies = Files.createTempDirectory(folder, "half");
      boolean whole = after.substring(0, end).endsWith("\nend");
      assertThat(comingBack(copies, after.substring(0, end)).get(0).document())
          .as(after.substring(before.length(), end))
          .isEqualTo(whole ? editor.document() : two);
    }
  }

  @Test
  void aJournalWithoutAWholeStepIsNeitherOfferedNorKept() throws Exception {
    Path copies = folder.resolve("begun");
    List<Orphan> orphans =
        comingBack(
            copies,
            "",
            "dct-jour",
            "dct-journal/1\n",
            "dct-journal/1\nkind polygon\nname a\n",
            "dct-journal/1\nkind polygon\nname a\nstep 0 0 1\n1 2");
    assertThat(orphans).isEmpty();
    assertThat(unread).isEmpty();
    assertThat(copies).isEmptyDirectory();
  }

  @Test
  void whatCannotBeReadIsKeptAndSaid() throws Exception {
    Path copies = folder.resolve("strange");
    String[] strange = {
      "dct-journal/2\nkind polygon\nname a\nstep 0 0 1\n1 2 e\nend\n",
      "dct-journal/10\nkind polygon\nname a\nstep 0 0 1\n1 2 e\nend\n",
      "dct-journal/1\nkind circle\nname a\nstep 0 0 1\n1 2 e\nend\n",
      "dct-journal/1\nkind polygon\nname a\nstep 0 0 1\n1 two e\nend\n",
      "dct-journal/1\nkind polygon\nname a\nstep 5 0 1\n1 2 e\nend\n",
      "\0\0\0\0"
    };
    assertThat(comingBack(copies, strange)).isEmpty();
    for (int i = 0; i < strange.length; i++) {
      assertThat(copies.resolve(i + ".journal")).hasContent(strange[i]);
      assertThat(unread.get(i)).endsWith(".journal").contains("is kept as it is: " + copies);
    }
    assertThat(unread).hasSameSizeAs(strange).doesNotHaveDuplicates();
    assertThat(files(copies)).as("no lease is left").hasSameSizeAs(strange);
  }

  @Test
  void whatIsNoTextIsKept() throws Exception {
    Path copies = Files.createDirectories(folder.resolve("strange"));
    Path journal = copies.resolve("0.journal");
    Files.write(journal, new byte[] {(byte) 0xff, (byte) 0xfe, 'd', 0, 'c', 0, 't', 0, '\n', 0});
    assertThat(comingBack(copies)).isEmpty();
    assertThat(unread).hasSize(1);
    assertThat(journal).exists();
  }

  @Test
  void anOptimumComesBackWithItsCertificate() throws Exception {
    perform(
        Edit.replace("Seven", editor.document(), Points.ofPairs(0, 0, 9, 1, 12, 6, 8, 11, 1, 9)));
    Document document = editor.document();
    Solution best =
        Solution.of(document.instance("a", Progress.NONE), Method.MONOTONE, Progress.NONE)
            .optimized(SearchLimits.DEFAULT, Progress.NONE);
    edit(() -> editor.accept("Most Even Vertices", document, Result.of(3, "Best", best)));
    Path copies = Files.createTempDirectory(folder, "copies");
    Path result =
        files().stream().filter(f -> f.toString().endsWith(".json")).findFirst().orElseThrow();
    Files.copy(result, copies.resolve("0.json"));
    Result back = comingBack(copies, text()).get(0).document().result().orElseThrow();
    assertThat(back.title()).isEqualTo("Best");
    assertThat(back.solution().optimum().orElseThrow().bound())
        .isEqualTo(best.optimum().orElseThrow().bound());
    perform(Edit.move(editor.document(), 0, -1, -1));
    assertThat(back().result()).isEmpty();
    edit(editor::undo);
    assertThat(text()).endsWith("result 3 Best\nend\n");
  }

  @Test
  void itIsGoneAsSoonAsNothingWouldBeLost() throws Exception {
    perform(Edit.draw(editor.document(), 10, 20));
    assertThat(files()).hasSize(2);
    edit(() -> editor.saved(editor.document(), new Origin(Path.of("a.txt"), Optional.empty())));
    assertThat(files()).isEmpty();
    perform(Edit.draw(editor.document(), 30, 40));
    assertThat(files()).hasSize(2);
    edit(editor::startAnew);
    assertThat(files()).isEmpty();
  }

  @Test
  void theFileThatWasOpenedIsRemembered() throws Exception {
    Path file = folder.resolve("a b ü.txt").toAbsolutePath();
    Origin origin = new Origin(file, Optional.of(new FileStamp("00ff")));
    Document start = new Document(Domain.POLYGON, Points.ofPairs(1, 2));
    edit(() -> editor.load(start, "a\nb", Optional.of(origin)));
    perform(Edit.draw(start, 3, 4));
    Orphan orphan = comingBack(folder.resolve("copies"), text()).get(0);
    assertThat(orphan.name()).isEqualTo("a b");
    assertThat(orphan.origin()).contains(origin);
  }

  @Test
  void thoseOfALivingProgramAreNotOffered() throws Exception {
    perform(Edit.draw(editor.document(), 10, 20));
    assertThat(new Journals(folder, lane).orphans(unread::add)).isEmpty();
  }

  @Test
  void whatIsLeftIsOfferedAgainAndWhatIsDiscardedIsNot() throws Exception {
    perform(Edit.draw(editor.document(), 10, 20));
    Path copies = folder.resolve("copies");
    Orphan orphan = comingBack(copies, text()).get(0);
    assertThat(new Journals(copies, lane).orphans(unread::add)).isEmpty();
    orphan.leave();
    lane.await();
    Orphan again = new Journals(copies, lane).orphans(unread::add).get(0);
    again.discard();
    lane.await();
    assertThat(copies).isEmptyDirectory();
  }

  @Test
  void aFolderThatCannotBeWrittenIsReportedAndTheOrphanStays() throws Exception {
    perform(Edit.draw(editor.document(), 10, 20));
    Path copies = folder.resolve("copies");
    Orphan orphan = comingBack(copies, text()).get(0);
    Path blocked = folder.resolve("blocked");
    Files.write(blocked, "a file".getBytes(StandardCharsets.UTF_8));
    List<IOException> told = new ArrayList<>();
    SwingUtilities.invokeAndWait(
        () -> {
          Editor other = new Editor(Domain.POLYGON, new Jobs());
          new Journals(blocked, lane).of(other, told::add);
          other.perform(Edit.draw(other.document(), 1, 1));
        });
    orphan.handOver();
    lane.await();
    assertThat(told).hasSize(1);
    assertThat(new Journals(blocked, lane).sentence(told.get(0)))
        .isEqualTo(
            "Edits are not kept for a crash: "
                + blocked
                + " cannot be written, it is no folder; save often, or mend that and edit on");
    assertThat(copies.resolve("0.journal")).exists();
  }
}
