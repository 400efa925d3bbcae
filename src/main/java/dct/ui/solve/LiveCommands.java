package dct.ui.solve;

import dct.core.triangulate.Domain;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Editor;
import dct.ui.document.LiveMethod;
import dct.ui.workbench.Workbench;
import java.util.Optional;
import javax.swing.JMenu;
import javax.swing.JRadioButtonMenuItem;

/** The commands of the live triangulation: the polygon in the canvas is triangulated as it is. */
public final class LiveCommands {
  private final Workbench workbench;
  private LiveMethod method = LiveMethod.MOST_EVEN;

  private LiveCommands(Workbench workbench) {
    this.workbench = workbench;
  }

  /** Offers the commands for the polygon of the workbench. */
  public static void offer(CommandRegistry commands, Workbench workbench) {
    new LiveCommands(workbench).offer(commands);
  }

  private void offer(CommandRegistry commands) {
    commands
        .add(
            "Live Triangulation",
            "L",
            "Triangulates the polygon in the canvas, and anew whenever it changes",
            this::toggle)
        .enabledWhen(() -> workbench.isChosen(Domain.POLYGON))
        .selectedWhen(() -> editor().live().isPresent());
    commands.addSubmenu("Live Method", this::fill);
  }

  private Editor editor() {
    return workbench.editor(Domain.POLYGON);
  }

  private void toggle() {
    editor().setLive(editor().live().isPresent() ? Optional.empty() : Optional.of(method));
  }

  private void fill(JMenu menu) {
    for (LiveMethod each : LiveMethod.all()) {
      JRadioButtonMenuItem item = new JRadioButtonMenuItem(each.title(), each.equals(method));
      item.setName("Live " + each.title());
      item.addActionListener(e -> choose(each));
      menu.add(item);
    }
  }

  /** Whoever chooses a method wants to see what it does. */
  private void choose(LiveMethod chosen) {
    method = chosen;
    workbench.choose(Domain.POLYGON);
    editor().setLive(Optional.of(chosen));
  }
}
