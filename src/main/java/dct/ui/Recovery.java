package dct.ui;

import dct.ui.dialog.Ask;
import dct.ui.document.Document;
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
    return String.format(
        Locale.ROOT,
        "Recover the drawing of %s? It was not saved when the program ended on %tF at %tR: %s%s.",
        orphan.name(),
        time,
        time,
        contents(orphan.document()),
        orphan.document().result().map(result -> ", and " + result.title()).orElse(""));
  }

  private static String contents(Document document) {
    int n = document.size();
    return switch (document.content()) {
      case POLYGON -> "a polygon with " + n + (n == 1 ? " vertex" : " vertices");
      case REGION -> "a region with " + n + " vertices";
      case SITES -> n + (n == 1 ? " site" : " sites");
    };
  }
}
