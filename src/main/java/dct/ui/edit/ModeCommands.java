package dct.ui.edit;

import dct.core.triangulate.Domain;
import dct.ui.command.CommandRegistry;
import dct.ui.tool.Tool;
import dct.ui.workbench.Workbench;
import java.awt.event.KeyEvent;
import java.util.Map;

/** The commands that choose an application or a mouse mode. */
public final class ModeCommands {
  private static final Map<Domain, String> NAMES =
      Map.of(Domain.POLYGON, "Polygon Based", Domain.SITES, "Point Sites Based");
  private static final Map<Domain, String> KEYS =
      Map.of(Domain.POLYGON, "ctrl 1", Domain.SITES, "ctrl 2");
  private static final Map<Domain, String> DESCRIPTIONS =
      Map.of(
          Domain.POLYGON, "Draw a polygon and triangulate it",
          Domain.SITES, "Draw sites and see their Delaunay triangulation");

  private ModeCommands() {}

  /** What the thesis calls an application. */
  public static String name(Domain application) {
    return NAMES.get(application);
  }

  /** Offers a command for each application and each mode of the workbench. */
  public static void offer(CommandRegistry commands, Workbench workbench) {
    for (Domain domain : Domain.applications()) {
      commands
          .add(
              name(domain),
              KEYS.get(domain),
              DESCRIPTIONS.get(domain),
              () -> workbench.choose(domain))
          .selectedWhen(() -> workbench.isChosen(domain));
    }
    for (Tool tool : workbench.tools()) {
      commands
          .add(
              tool.name(),
              KeyEvent.getKeyText(tool.key()),
              tool.description(),
              () -> workbench.choose(tool))
          .enabledWhen(() -> workbench.domain().filter(tool::isFor).isPresent())
          .selectedWhen(() -> workbench.tool().filter(tool::equals).isPresent());
    }
  }
}
