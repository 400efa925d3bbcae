package dct.ui.solve;

import dct.core.triangulate.Domain;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Editor;
import dct.ui.document.LiveMethod;
import dct.ui.session.Settings;
import dct.ui.workbench.Workbench;
import java.util.Optional;
import javax.swing.JMenu;
import javax.swing.JRadioButtonMenuItem;

/**
 * The commands of the live triangulation: the polygon in the canvas is triangulated as it is.
 * Whether it is, and by which method, is remembered from one window to the next.
 */
public final class LiveCommands {
  private static final String ON = "live.on";
  private static final String METHOD = "live.method";

  private final Workbench workbench;
  private final Settings settings;
  private LiveMethod method;

  private LiveCommands(Workbench workbench, Settings settings) {
    this.workbench = workbench;
    this.settings = settings;
    method =
        LiveMethod.all().stream()
            .filter(each -> settings.get(METHOD).filter(each.title()::equals).isPresent())
            .findFirst()
            .orElse(LiveMethod.MOST_EVEN);
    if (settings.isOn(ON)) {
      editor().setLive(Optional.of(method));
    }
  }

  /** Offers the commands for the polygon of the workbench, as these settings remember them. */
  public static void offer(CommandRegistry commands, Workbench workbench, Settings settings) {
    new LiveCommands(workbench, settings).offer(commands);
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
    set(editor().live().isPresent() ? Optional.empty() : Optional.of(method));
  }

  private void set(Optional<LiveMethod> live) {
    editor().setLive(live);
    settings.put(ON, live.isPresent());
    settings.put(METHOD, method.title());
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
    set(Optional.of(chosen));
  }
}
