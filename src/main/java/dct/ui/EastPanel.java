package dct.ui;

import com.formdev.flatlaf.FlatClientProperties;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.problem.Solution;
import dct.ui.command.Command;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Document;
import dct.ui.document.Editor;
import dct.ui.document.Result;
import dct.ui.edit.ModeCommands;
import dct.ui.tool.Tool;
import dct.ui.vertices.VertexList;
import dct.ui.workbench.Workbench;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.JTabbedPane;

/**
 * The thesis's east panel: the choice of the application, the checkboxes of the mouse modes, the
 * buttons of the application, and the coordinates.
 */
final class EastPanel extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int WIDTH = 274;
  private static final int GAP = 6;

  /** The thesis's buttons of each application, from top to bottom. */
  private static final Map<Domain, List<String>> BUTTONS =
      Map.of(
          Domain.POLYGON,
          List.of(
              "Clear Canvas",
              "Convex Polygon Even Triangulation",
              "Convex Polygon Odd Triangulation",
              "Monotone Polygon Triangulation",
              "Perform Flip"),
          Domain.SITES,
          List.of("Clear Canvas", "Perform Flip", "Random Sites"));

  private final transient Workbench workbench;
  private final Map<Domain, JComponent> buttons = new EnumMap<>(Domain.class);
  private final CoordinateList coordinates = new CoordinateList();
  private final VertexList vertices;
  private final JTabbedPane tabs = new JTabbedPane();
  private JComponent toolBoxes;

  /** A panel whose boxes and buttons are these commands. */
  EastPanel(Workbench workbench, CommandRegistry commands) {
    super(new BorderLayout(0, 12));
    this.workbench = workbench;
    vertices = new VertexList(workbench);
    setBorder(BorderFactory.createEmptyBorder(12, 12, 12, 12));
    setPreferredSize(new Dimension(WIDTH, 0));
    JPanel top = new JPanel();
    top.setLayout(new BoxLayout(top, BoxLayout.Y_AXIS));
    top.add(applications(commands));
    toolBoxes = tools(commands);
    top.add(toolBoxes);
    for (Domain domain : Domain.applications()) {
      JComponent column = buttons(BUTTONS.get(domain).stream().map(commands::get).toList());
      buttons.put(domain, column);
      top.add(column);
    }
    add(top, BorderLayout.NORTH);
    add(bottom(), BorderLayout.CENTER);
    refresh();
  }

  private static JComponent applications(CommandRegistry commands) {
    JComponent column = column(Domain.applications().size());
    for (Domain domain : Domain.applications()) {
      Command command = commands.get(ModeCommands.name(domain));
      column.add(named(new JRadioButton(command), command));
    }
    return column;
  }

  /** Checkboxes, as in the thesis; at most one of them is chosen, none for a tool of the menu. */
  private JComponent tools(CommandRegistry commands) {
    JComponent column = column(workbench.boxes().size());
    column.setBorder(BorderFactory.createEmptyBorder(14, 0, 0, 0));
    for (Tool tool : workbench.boxes()) {
      Command command = commands.get(tool.name());
      column.add(named(new JCheckBox(command), command));
    }
    return column;
  }

  private static JComponent buttons(List<Command> commands) {
    JComponent column = column(commands.size());
    column.setBorder(BorderFactory.createEmptyBorder(16, 0, 0, 0));
    for (Command command : commands) {
      JButton button = named(new JButton(command), command);
      button.putClientProperty(FlatClientProperties.STYLE_CLASS, "medium"); // long words fit in
      column.add(button);
    }
    return column;
  }

  private static JComponent column(int rows) {
    JPanel column = new JPanel(new GridLayout(rows, 1, 0, GAP));
    column.setAlignmentX(Component.LEFT_ALIGNMENT);
    return column;
  }

  private static <B extends AbstractButton> B named(B button, Command command) {
    button.setName(command.name());
    return button;
  }

  private JComponent bottom() {
    tabs.setName("tabs");
    tabs.addTab("Coordinates", null, coordinates, "The coordinates as text");
    tabs.addTab("Vertices", null, vertices, "A table of the vertices, which can be edited");
    return tabs;
  }

  /** Shows the state of the workbench. */
  void refresh() {
    toolBoxes.setVisible(workbench.domain().isPresent());
    buttons.forEach(
        (domain, column) ->
            column.setVisible(workbench.domain().filter(domain::equals).isPresent()));
    workbench.active().ifPresent(this::show);
  }

  private void show(Editor editor) {
    Document document = editor.visible();
    coordinates.show(document.points());
    vertices.show(document, triangulation(editor), editor.selection());
  }

  /** The triangulation that was made last, or that of the sites. */
  private static Optional<Triangulation> triangulation(Editor editor) {
    return editor
        .visible()
        .result()
        .map(Result::solution)
        .or(() -> editor.shown().solution())
        .map(Solution::triangulation);
  }
}
