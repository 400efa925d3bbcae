package dct.ui.random;

import dct.core.triangulate.Domain;
import dct.ui.command.CommandRegistry;
import dct.ui.shell.CallCopy;
import dct.ui.workbench.Workbench;
import java.awt.Component;

/** The commands that put something random on the canvas. */
public final class RandomCommands {

  private RandomCommands() {}

  /**
   * Offers the commands for the documents of the workbench.
   *
   * @param shown is run when something else was put on the canvas
   */
  public static void offer(
      CommandRegistry commands,
      Component parent,
      Workbench workbench,
      CallCopy calls,
      Runnable shown) {
    RandomWork sites =
        new RandomWork("Random Sites", Domain.SITES, parent, workbench, calls, shown);
    RandomWork polygons =
        new RandomWork("Random Polygon", Domain.POLYGON, parent, workbench, calls, shown);
    RandomWork regions =
        new RandomWork("Random Region", Domain.REGION, parent, workbench, calls, shown);
    commands
        .add(
            "Random Sites",
            "shift R",
            "Puts random sites of a shape to choose on the canvas",
            sites::ask)
        .enabledWhen(() -> workbench.isChosen(Domain.SITES));
    commands
        .add(
            "Random Polygon…",
            "ctrl R",
            "Puts a random polygon of a shape to choose on the canvas",
            polygons::ask)
        .enabledWhen(() -> workbench.isChosen(Domain.POLYGON));
    commands
        .add(
            "Random Region…",
            "ctrl shift R",
            "Puts a random polygon with holes, of a shape to choose, on the canvas",
            regions::ask)
        .enabledWhen(() -> workbench.isChosen(Domain.POLYGON));
  }
}
