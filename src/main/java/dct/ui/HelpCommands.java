package dct.ui;

import dct.ui.command.CommandRegistry;
import java.awt.Frame;

/** The commands that say what can be done. */
final class HelpCommands {

  private HelpCommands() {}

  /** Offers the commands of a window; they tell of all that the registry holds then. */
  static void offer(CommandRegistry commands, Frame window) {
    commands.add(
        "Commands and Keys",
        "F1",
        "Lists everything that can be done",
        () -> CommandList.show(window, commands.all()));
    commands.add("About", "", "Says what this program is", () -> about(window));
  }

  private static void about(Frame window) {
    Ask.tell(
        window,
        "About",
        "Degree Constrained Triangulation: triangulations of polygons and point sites with as many"
            + " vertices of even degree as possible, after R. Gyawali's thesis of that name (UNLV,"
            + " 2012).");
  }
}
