package dct.ui.edit;

import dct.ui.command.CommandRegistry;
import dct.ui.session.Settings;
import dct.ui.tool.Snap;
import java.awt.Component;

/** The commands that say what places snap to, with Ipe's keys. */
public final class SnapCommands {
  private final Snap snap;
  private final Settings settings;

  private SnapCommands(Snap snap, Settings settings) {
    this.snap = snap;
    this.settings = settings;
  }

  /** Sets what was set in the run before, and offers the commands. */
  public static void offer(
      CommandRegistry commands, Component parent, Snap snap, Settings settings) {
    SnapMemory.restore(snap, settings);
    SnapCommands offered = new SnapCommands(snap, settings);
    offered.toggle(
        commands,
        "Snap to Vertices",
        "F4",
        "Places vertices within reach of another exactly on it",
        Snap.To.VERTICES);
    offered.toggle(
        commands,
        "Snap to Edges",
        "F5",
        "Places vertices within reach of an edge exactly on it",
        Snap.To.EDGES);
    offered.toggle(
        commands, "Snap to Grid", "F7", "Shows a grid and places vertices on it", Snap.To.GRID);
    offered.toggle(
        commands,
        "Snap to Angles",
        "F9",
        "Draws and drags in directions of some angles; with Shift, of right angles",
        Snap.To.ANGLES);
    commands.add(
        SnapForm.TITLE + "…",
        "",
        "Sets the size of the grid and the angle",
        () -> offered.ask(parent));
  }

  private void toggle(
      CommandRegistry commands, String name, String key, String description, Snap.To to) {
    commands.add(name, key, description, () -> toggle(to)).selectedWhen(() -> snap.isOn(to));
  }

  private void toggle(Snap.To to) {
    snap.toggle(to);
    SnapMemory.remember(snap, settings);
  }

  private void ask(Component parent) {
    if (SnapForm.ask(parent, snap)) {
      SnapMemory.remember(snap, settings);
    }
  }
}
