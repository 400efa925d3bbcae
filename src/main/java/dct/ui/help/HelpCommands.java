package dct.ui.help;

import dct.problem.Solution;
import dct.ui.command.CommandMenu.Plan;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Ask;
import dct.ui.menu.CommandWindow;
import dct.ui.menu.MenuTable;
import dct.ui.shell.CallCopy;
import dct.ui.workbench.Workbench;
import java.awt.Frame;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** The commands that say what can be done. */
public final class HelpCommands {
  private static final String LIST = "Commands and Keys";
  private static final String FIND = "Find Command…";

  private HelpCommands() {}

  /** Offers the commands of a window; they tell of all that the registry holds then. */
  public static void offer(
      CommandRegistry commands,
      Frame window,
      Workbench workbench,
      CheckWork checks,
      CallCopy calls) {
    BooleanSupplier chosen = () -> workbench.domain().isPresent();
    offerSearch(commands, MenuTable.MAIN, () -> window, workbench::say);
    commands
        .add("Check Input", "", "Says whether this can be triangulated, and why not", checks::check)
        .enabledWhen(chosen);
    commands
        .add(
            "Copy as Command Line",
            "",
            "Copies the dct command that makes what is shown",
            calls::copyShown)
        .enabledWhen(chosen);
    commands.add("About", "", "Says what this program is", () -> about(window));
  }

  /**
   * Offers the list of all commands and the search for one. A part of a window that has commands of
   * its own leaves both to the window.
   *
   * @param menus those of the commands
   * @param window says which one shows them now
   * @param said is told what was copied of the list
   */
  public static void offerSearch(
      CommandRegistry commands, List<Plan> menus, Supplier<Frame> window, Consumer<String> said) {
    commands.add(
        LIST,
        "F1",
        "Lists everything that can be done, with its keys",
        () ->
            perform(
                LIST,
                commands,
                window.get(),
                over -> CommandList.show(over, CommandLines.of(menus, commands), said)));
    commands.add(
        FIND,
        "ctrl shift A",
        "Finds a command by a part of its name, and runs it",
        () ->
            perform(
                FIND, commands, window.get(), over -> CommandFinder.show(over, commands.all())));
  }

  private static void perform(
      String id, CommandRegistry commands, Frame window, Consumer<Frame> ofThese) {
    if (window instanceof CommandWindow other && other.commands() != commands) {
      other.commands().get(id).perform();
    } else {
      ofThese.accept(window);
    }
  }

  private static void about(Frame window) {
    Ask.tell(
        window,
        "About",
        "Degree Constrained Triangulation, version "
            + Solution.programVersion()
            + ": triangulations of polygons and point sites with as many vertices of even degree as"
            + " possible, after R. Gyawali's thesis of that name (UNLV, 2012).\n\n"
            + "Licensed under the Apache License, Version 2.0, as are the libraries that the"
            + " program holds; the file NOTICE lists them.");
  }
}
