package dct.ui;

import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import java.awt.Component;
import java.util.OptionalInt;
import javax.swing.JOptionPane;

/** Random Sites: asks for a number, and puts so many sites on the canvas. */
final class RandomSitesWork {
  private static final int MOST = 1_000_000;
  private static final String TITLE = "Random Sites";

  private final Component parent;
  private final Workbench workbench;
  private final Runnable shown;
  private int seed; // of the last random sites

  /**
   * Work for a window.
   *
   * @param shown is run when other sites were put on the canvas
   */
  RandomSitesWork(Component parent, Workbench workbench, Runnable shown) {
    this.parent = parent;
    this.workbench = workbench;
    this.shown = shown;
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
