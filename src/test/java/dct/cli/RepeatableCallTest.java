package dct.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.Flip;
import dct.core.degree.FlipList;
import dct.core.degree.FlipResult;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.Preference;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.SiteShape;
import dct.io.PointDocument;
import dct.io.PointFile;
import dct.io.WishFile;
import dct.problem.Comparison;
import dct.problem.Method;
import dct.problem.Solution;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.document.Origin;
import dct.ui.document.Result;
import dct.ui.job.Jobs;
import dct.ui.shell.NotRepeatableException;
import dct.ui.shell.RepeatableCall;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The call that the window copies makes the same edges as the window shows. */
class RepeatableCallTest {
  @TempDir Path folder;

  private Editor saved(Domain domain) throws Exception {
    Points points =
        domain == Domain.SITES
            ? SiteShape.CLUSTERS.generate(60, 3)
            : PolygonShape.TWO_OPT.generate(50, 4).points();
    Document document = new Document(domain, points);
    Editor editor = new Editor(domain, new Jobs());
    editor.load(document, "mine");
    Path file = folder.resolve("my own.txt");
    PointFile.write(file, PointDocument.of("", domain, points), Progress.NONE);
    editor.saved(document, new Origin(file, Optional.empty()));
    return editor;
  }

  private static Solution start(Editor editor, Method method) {
    return Solution.of(editor.document().instance("", Progress.NONE), method, Progress.NONE);
  }

  private static void make(Editor editor, Solution solution) {
    editor.accept("Made", editor.document(), Result.of(1, "Made", solution));
  }

  /** Runs the call that the editor's state gives, and compares the edges. */
  private List<String> requireSame(Editor editor) throws Exception {
    List<String> words = RepeatableCall.of(editor).call(Progress.NONE).words();
    Path out = folder.resolve("out.json");
    List<Object> arguments = new ArrayList<>(words);
    arguments.addAll(List.of("--quiet", "-o", out));
    CliRun.of(arguments.toArray()).done();
    Triangulation made =
        PointFile.read(out, Progress.NONE).solution(Progress.NONE).orElseThrow().triangulation();
    Triangulation shown =
        editor
            .document()
            .result()
            .map(Result::solution)
            .or(() -> editor.shown().solution())
            .orElseThrow()
            .triangulation();
    Comparison comparison = Comparison.of(made, shown);
    assertThat(comparison.onlyFirst()).isEmpty();
    assertThat(comparison.onlySecond()).isEmpty();
    return words;
  }

  @ParameterizedTest
  @EnumSource(Method.class)
  void methodsAndScanFlipAreRepeated(Method method) throws Exception {
    Editor editor = saved(method.application());
    make(editor, start(editor, method));
    assertThat(requireSame(editor)).contains(method.word()).doesNotContain("--flip");
    make(editor, start(editor, method).flipped(Progress.NONE));
    assertThat(requireSame(editor)).contains("--flip");
  }

  @ParameterizedTest
  @EnumSource(Method.class)
  void searchesAreRepeated(Method method) throws Exception {
    Editor editor = saved(method.application());
    SearchLimits limits = new SearchLimits(5, 0.5, Double.POSITIVE_INFINITY);
    make(editor, start(editor, method).optimized(limits, Progress.NONE));
    assertThat(requireSame(editor))
        .containsSequence("--optimize", "even", "--seed", "5", "--effort", "0.5");
  }

  @Test
  void whatWasPreferredIsRepeated() throws Exception {
    Editor editor = saved(Domain.POLYGON);
    Solution start = start(editor, Method.MONOTONE);
    make(editor, start.optimized(SearchLimits.DEFAULT, Preference.LENGTH, Progress.NONE));
    assertThat(requireSame(editor)).containsSequence("--prefer", "length");
    editor.undo();
    make(editor, start.optimized(SearchLimits.DEFAULT, Preference.ANGLE, Progress.NONE));
    assertThat(requireSame(editor)).doesNotContain("--prefer");
    editor.undo();
    Preference kept = Preference.keeping(start.triangulation());
    make(editor, start.optimized(SearchLimits.DEFAULT, kept, Progress.NONE));
    requireNone(editor, "The search keeps edges of a triangulation that is in no file");
    List<String> search =
        RepeatableCall.search(editor, SearchLimits.DEFAULT, Optional.of(Preference.Kind.LENGTH))
            .words();
    assertThat(search).containsSequence("--optimize", "even").endsWith("--prefer", "length");
  }

  @Test
  void aTriangulationOfUnknownMethodIsNotRepeated() throws Exception {
    Editor editor = saved(Domain.SITES);
    Solution delaunay = start(editor, Method.DELAUNAY);
    Solution read = Solution.read(delaunay.instance().named("a/b.off"), delaunay.triangulation());
    make(editor, read);
    assertThat(read.methodTitle()).isEqualTo("Read from b.off");
    requireNone(editor, "What is shown began with the triangulation of a file");
    make(editor, read.optimized(SearchLimits.DEFAULT, Progress.NONE));
    requireNone(editor, "What is shown began with the triangulation of a file");
  }

  @Test
  void wishesAreReadFromTheirFile() throws Exception {
    Editor editor = saved(Domain.SITES);
    ParityGoal wishes = editor.document().wishes().with(2, Wish.ODD).with(9, Wish.ANY);
    editor.perform(Edit.wishes("Wishes", editor.document(), wishes));
    make(editor, start(editor, Method.DELAUNAY).optimized(SearchLimits.DEFAULT, Progress.NONE));
    requireNone(editor, "these are not saved; choose Triangulate ▸ Wished Parities");
    Path file = folder.resolve("wishes.txt");
    WishFile.write(file, wishes, Progress.NONE);
    editor.wishesSaved(editor.document(), file);
    assertThat(requireSame(editor)).containsSequence("--optimize", file.toString());
  }

  @Test
  void sitesWithoutAResultAreDelaunayAndAPolygonIsChecked() throws Exception {
    assertThat(requireSame(saved(Domain.SITES))).contains("delaunay");
    List<String> words = RepeatableCall.of(saved(Domain.POLYGON)).call(Progress.NONE).words();
    assertThat(words).startsWith("check");
    assertThat(CliRun.of(words.toArray()).done().out()).contains("a simple polygon with 50");
  }

  private static void requireNone(Editor editor, String sentence) {
    assertThatThrownBy(() -> RepeatableCall.of(editor).call(Progress.NONE))
        .isInstanceOf(NotRepeatableException.class)
        .hasMessageContaining(sentence);
  }

  @Test
  void whatIsNotSavedHasNoCall() throws Exception {
    Editor editor = saved(Domain.POLYGON);
    editor.perform(Edit.draw(editor.document(), 1, 1));
    requireNone(editor, "reads the vertices from a file, and these are not saved; save them");
    editor.undo();
    assertThat(RepeatableCall.of(editor)).isNotNull();
    editor.startAnew();
    requireNone(editor, "not saved");
  }

  @Test
  void whatTookSeveralStepsHasNoCall() throws Exception {
    Editor editor = saved(Domain.SITES);
    Solution delaunay = start(editor, Method.DELAUNAY);
    make(editor, delaunay.flipped(Progress.NONE));
    make(editor, editor.document().result().orElseThrow().solution().flipped(byHand()));
    requireNone(editor, "by hand or in several steps");
    editor.undo();
    UnaryOperator<Solution> search = s -> s.optimized(SearchLimits.DEFAULT, Progress.NONE);
    make(editor, search.apply(editor.document().result().orElseThrow().solution()));
    requireNone(editor, "began with flips or another result");
    editor.undo();
    editor.undo();
    make(editor, search.apply(delaunay));
    assertThat(requireSame(editor)).contains("even");
  }

  /** One flip of the Delaunay triangulation that Scan-Flip does not end with. */
  private FlipResult byHand() throws Exception {
    Triangulation delaunay = start(saved(Domain.SITES), Method.DELAUNAY).triangulation();
    List<Flip> flips = FlipList.of(dct.core.degree.ScanFlip.run(delaunay, Progress.NONE)).flips();
    return new FlipList(flips.subList(0, 1)).applyTo(delaunay, Progress.NONE).result();
  }

  @Test
  void aSearchThatWasStoppedHasNoCall() throws Exception {
    Editor editor = saved(Domain.SITES);
    Solution found =
        start(editor, Method.DELAUNAY).optimized(new SearchLimits(1, 1, 0), Progress.NONE);
    Solution stopped =
        start(editor, Method.DELAUNAY)
            .optimized(found.optimum().orElseThrow(), SearchLimits.DEFAULT);
    make(editor, stopped);
    if (found.optimum().get().interrupted()) {
      requireNone(editor, "stopped early");
    } else {
      requireSame(editor);
    }
  }

  @Test
  void aChangedWishTellsNothingOfHowTheEdgesCame() throws Exception {
    Editor editor = saved(Domain.POLYGON);
    make(editor, start(editor, Method.MONOTONE).optimized(SearchLimits.DEFAULT, Progress.NONE));
    editor.perform(Edit.wish(editor.document(), 3, Wish.ODD));
    requireNone(editor, "by hand or in several steps");
    editor.perform(Edit.result("None", editor.document(), Optional.empty()));
    assertThat(RepeatableCall.of(editor).call(Progress.NONE).words()).startsWith("check");
  }
}
