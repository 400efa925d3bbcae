package dct.ui;

import dct.core.degree.ParityGoal;
import dct.core.degree.SearchLimits;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.problem.Solution;
import dct.ui.document.Analysis;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import java.awt.Component;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.IntFunction;
import javax.swing.JOptionPane;

/** What the buttons of Point Sites Based do. */
final class SitesWork {
  private static final int MOST = 1_000_000;
  private static final String TITLE = "Random Sites";
  private static final String CURE = "draw three sites or more, not all on one line";

  private final Component parent;
  private final Workbench workbench;
  private final Runnable shown;
  private int seed; // of the last random sites

  /**
   * Work for a window.
   *
   * @param shown is run when other sites were put on the canvas
   */
  SitesWork(Component parent, Workbench workbench, Runnable shown) {
    this.parent = parent;
    this.workbench = workbench;
    this.shown = shown;
  }

  /** Runs Scan-Flip on the triangulation shown, in the canvas. */
  void flip() {
    Editor editor = workbench.editor(Domain.SITES);
    Analysis shown = editor.shown();
    Optional<Solution> before = shown.solution();
    if (before.isEmpty()) {
      workbench.say("There is no triangulation to flip yet; " + CURE);
    } else {
      workbench
          .jobs()
          .submit(
              "Perform Flip",
              progress -> shown.with(before.get().flipped(progress)),
              editor::showInstead);
    }
  }

  /**
   * Shows the triangulation in which the most sites have the parity wished, or the best found on
   * Cancel.
   *
   * @param what what is being done, for a person to read
   * @param goal the wishes for n sites
   */
  void optimize(String what, IntFunction<ParityGoal> goal) {
    Editor editor = workbench.editor(Domain.SITES);
    Analysis shown = editor.shown();
    Optional<Solution> before = shown.solution();
    if (before.isEmpty()) {
      workbench.say("There is no triangulation to improve yet; " + CURE);
    } else if (!shown.document().equals(editor.document())) {
      workbench.say("The sites are still being triangulated; try again when that is done");
    } else {
      Solution start = before.get().wishing(goal.apply(before.get().instance().size()));
      workbench
          .jobs()
          .submitSearch(
              what,
              progress -> shown.with(start.optimized(SearchLimits.DEFAULT, progress)),
              editor::showInstead);
    }
  }

  /** Asks for a number and puts so many random sites in place of those there are. */
  void random() {
    askNumber().ifPresent(this::random);
  }

  private void random(int n) {
    seed++;
    int chosen = seed;
    workbench
        .jobs()
        .submit(TITLE, progress -> RandomSites.uniform(n, chosen), sites -> show(sites, chosen));
  }

  private void show(Points sites, int chosen) {
    Editor editor = workbench.editor(Domain.SITES);
    editor.perform(Edit.replace(TITLE, editor.document(), sites));
    shown.run();
    workbench.say(sites.size() + " random sites, seed " + chosen);
  }

  private OptionalInt askNumber() {
    String typed = "100";
    while (true) {
      typed =
          (String)
              JOptionPane.showInputDialog(
                  parent,
                  "Number of sites:",
                  TITLE,
                  JOptionPane.QUESTION_MESSAGE,
                  null,
                  null,
                  typed);
      if (typed == null) {
        return OptionalInt.empty();
      }
      OptionalInt n = parse(typed.strip());
      if (n.isPresent()) {
        return n;
      }
      Ask.sorry(parent, TITLE, "“" + typed + "” is not a whole number from 1 to " + MOST + ".");
    }
  }

  private static OptionalInt parse(String typed) {
    try {
      int n = Integer.parseInt(typed);
      return n >= 1 && n <= MOST ? OptionalInt.of(n) : OptionalInt.empty();
    } catch (NumberFormatException e) {
      return OptionalInt.empty();
    }
  }
}
