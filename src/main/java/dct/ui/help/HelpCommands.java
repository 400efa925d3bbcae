package dct.ui.help;

import dct.problem.Solution;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Ask;
import dct.ui.menu.MenuTable;
import dct.ui.shell.CallCopy;
import dct.ui.workbench.Workbench;
import java.awt.Frame;
import java.util.function.BooleanSupplier;

/** The commands that say what can be done. */
public final class HelpCommands {

  private HelpCommands() {}

  /** Offers the commands of a window; they tell of all that the registry holds then. */
  public static void offer(
      CommandRegistry commands,
      Frame window,
      Workbench workbench,
      CheckWork checks,
      CallCopy calls) {
    BooleanSupplier chosen = () -> workbench.domain().isPresent();
    commands.add(
        "Commands and Keys",
        "F1",
        "Lists everything that can be done, with its keys",
        () -> CommandList.show(window, CommandLines.of(MenuTable.MAIN, commands)));
    commands.add(
        "Find Command…",
        "ctrl shift A",
        "Finds a command by a part of its name, and runs it",
        () -> CommandFinder.show(window, commands.all()));
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
