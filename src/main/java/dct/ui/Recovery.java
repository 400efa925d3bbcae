package dct.ui;

import dct.ui.dialog.Ask;
import dct.ui.session.Orphan;
import java.awt.Component;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.util.Locale;
import java.util.function.Function;

/** Offers to bring back a drawing that was not saved when the program was killed. */
final class Recovery {

  private Recovery() {}

  /**
   * Asks, and does what is answered; by Enter the drawing is brought back, by Esc it is left for
   * the next start.
   *
   * @param windowFor where the drawing is shown
   */
  static void ask(Component parent, Orphan orphan, Function<Orphan, MainWindow> windowFor) {
    switch (Ask.choose(
        parent, "Recover Drawing", question(orphan), 0, "Recover", "Discard", "Later")) {
      case 0 -> {
        windowFor.apply(orphan).recover(orphan);
        orphan.handOver();
      }
      case 1 -> orphan.discard();
      default -> orphan.leave();
    }
  }

  private static String question(Orphan orphan) {
    ZonedDateTime time = orphan.time().atZone(ZoneId.systemDefault());
    int n = orphan.document().size();
    String what = orphan.document().domain().title();
    return String.format(
        Locale.ROOT,
        "Recover drawing of %s? It was not saved when the program ended on %tF at %tR: a %s with %d"
            + " %s%s.",
        orphan.name(),
        time,
        time,
        what,
        n,
        n == 1 ? "vertex" : "vertices",
        orphan.document().result().map(result -> ", and " + result.title()).orElse(""));
  }
}
