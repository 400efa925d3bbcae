package dct.ui;

import com.formdev.flatlaf.FlatClientProperties;
import dct.core.triangulate.Domain;
import dct.ui.command.Command;
import dct.ui.document.Editor;
import dct.ui.tool.Tool;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GridLayout;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;

/**
 * The thesis's east panel: the choice of the application, the checkboxes of the mouse modes, the
 * buttons of the application, and the coordinates.
 */
final class EastPanel extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int WIDTH = 274;
  private static final int GAP = 6;

  private final transient Workbench workbench;
  private final Map<Domain, AbstractButton> applications = new EnumMap<>(Domain.class);
  private final transient Map<Tool, AbstractButton> tools = new LinkedHashMap<>();
  private final Map<Domain, JComponent> buttons = new EnumMap<>(Domain.class);
  private final CoordinateList coordinates = new CoordinateList();
  private final ButtonGroup oneTool = new ButtonGroup();
  private JComponent toolBoxes;

  EastPanel(
      Workbench workbench,
      Map<Domain, Command> chooseApplication,
      Map<Tool, Command> chooseTool,
      Map<Domain, List<Command>> algorithms) {
    super(new BorderLayout(0, 12));
    this.workbench = workbench;
    setBorder(BorderFactory.createEmptyBorder(12, 12, 12, 12));
    setPreferredSize(new Dimension(WIDTH, 0));
    JPanel top = new JPanel();
    top.setLayout(new BoxLayout(top, BoxLayout.Y_AXIS));
    top.add(applications(chooseApplication));
    toolBoxes = tools(chooseTool);
    top.add(toolBoxes);
    for (Domain domain : Domain.values()) {
      JComponent column = buttons(algorithms.get(domain));
      buttons.put(domain, column);
      top.add(column);
    }
    add(top, BorderLayout.NORTH);
    add(bottom(), BorderLayout.CENTER);
    refresh();
  }

  private JComponent applications(Map<Domain, Command> commands) {
    ButtonGroup oneOfThem = new ButtonGroup();
    JComponent column = column(commands.size());
    commands.forEach(
        (domain, command) -> {
          JRadioButton button = new JRadioButton(command);
          oneOfThem.add(button);
          applications.put(domain, named(button, command));
          column.add(button);
        });
    return column;
  }

  /** Checkboxes, as in the thesis; at most one of them is chosen, none for a tool of the menu. */
  private JComponent tools(Map<Tool, Command> commands) {
    JComponent column = column(workbench.boxes().size());
    column.setBorder(BorderFactory.createEmptyBorder(14, 0, 0, 0));
    for (Tool tool : workbench.boxes()) {
      JCheckBox box = new JCheckBox(commands.get(tool));
      oneTool.add(box);
      tools.put(tool, named(box, commands.get(tool)));
      column.add(box);
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
    JPanel panel = new JPanel(new BorderLayout(0, GAP));
    JLabel title = new JLabel("Coordinates");
    title.setLabelFor(coordinates);
    panel.add(title, BorderLayout.NORTH);
    panel.add(coordinates, BorderLayout.CENTER);
    panel.add(Box.createVerticalStrut(0), BorderLayout.SOUTH);
    return panel;
  }

  /** Shows the state of the workbench. */
  void refresh() {
    workbench.domain().ifPresent(domain -> applications.get(domain).setSelected(true));
    oneTool.clearSelection();
    workbench.tool().map(tools::get).ifPresent(box -> box.setSelected(true));
    toolBoxes.setVisible(workbench.domain().isPresent());
    buttons.forEach(
        (domain, column) ->
            column.setVisible(workbench.domain().filter(domain::equals).isPresent()));
    workbench.active().map(Editor::visible).ifPresent(d -> coordinates.show(d.points()));
  }
}
