package dct.ui.help;

import dct.ui.command.CloseKeys;
import dct.ui.command.Command;
import dct.ui.command.CommandSearch;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.function.IntUnaryOperator;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;

/**
 * Help ▸ Find Command…: a field for a part of a name or of what a command does, and the commands
 * that match. Up and Down choose one, Enter runs it, Escape or a click elsewhere closes.
 */
public final class CommandFinder extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final int PAGE = 8;

  private final transient List<Command> commands;
  private final JTextField field = new JTextField(34);
  private final JList<Command> found = new Found();
  private final JLabel state = new JLabel(" ");

  private CommandFinder(Frame owner, List<Command> commands) {
    super(owner, "Find Command");
    this.commands = commands;
    setName("findCommand");
    setUndecorated(true);
    setContentPane(content());
    field.getDocument().addDocumentListener(new Typing(this::search));
    key("DOWN", index -> index + 1);
    key("UP", index -> index - 1);
    key("PAGE_DOWN", index -> index + PAGE);
    key("PAGE_UP", index -> index - PAGE);
    field.addActionListener(e -> run());
    listen();
    search();
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    CloseKeys.close(this);
    pack();
  }

  /** Opens the finder over a window. */
  static void show(Frame owner, List<Command> commands) {
    CommandFinder finder = new CommandFinder(owner, commands);
    finder.setLocation(
        owner.getX() + (owner.getWidth() - finder.getWidth()) / 2,
        owner.getY() + owner.getHeight() / 6);
    finder.setVisible(true);
  }

  private JComponent content() {
    field.setName("commandName");
    field.putClientProperty("JTextField.placeholderText", "A command, or what it does");
    field.getAccessibleContext().setAccessibleName("Name of a command, or what it does");
    found.setName("found");
    found.getAccessibleContext().setAccessibleName("Commands that match");
    found.setCellRenderer(new CommandCell());
    found.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    found.setFocusable(false); // the keys stay in the field
    JScrollPane scroll = new JScrollPane(found);
    scroll.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    scroll.setPreferredSize(new Dimension(560, 380));
    state.setName("commandState");
    JPanel content = new JPanel(new BorderLayout(0, 6));
    content.setBorder(
        BorderFactory.createCompoundBorder(
            BorderFactory.createLineBorder(UIManager.getColor("Component.borderColor")),
            BorderFactory.createEmptyBorder(10, 10, 8, 10)));
    content.add(field, BorderLayout.NORTH);
    content.add(scroll, BorderLayout.CENTER);
    content.add(state, BorderLayout.SOUTH);
    return content;
  }

  private void key(String key, IntUnaryOperator move) {
    field.getInputMap().put(KeyStroke.getKeyStroke(key), key);
    field.getActionMap().put(key, new Move(move));
  }

  private void listen() {
    found.addListSelectionListener(e -> describe());
    found.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent e) {
            run();
          }
        });
    addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowDeactivated(WindowEvent e) {
            dispose();
          }
        });
  }

  private void search() {
    List<Command> matching = CommandSearch.find(field.getText(), commands);
    found.setListData(matching.toArray(Command[]::new));
    found.setSelectedIndex(0);
    describe();
  }

  /** Says which command Enter would run; a screen reader hears it while it stays in the field. */
  private void describe() {
    Command command = found.getSelectedValue();
    String words;
    if (command == null) {
      words = "No command of this window has this name; type a part of what it does";
    } else {
      String key = command.keyText().isEmpty() ? "" : ", " + command.keyText();
      words =
          command.isEnabled()
              ? "Enter: " + command.name() + key
              : command.name() + key + " is not possible now";
    }
    state.setText(words);
    field.getAccessibleContext().setAccessibleDescription(words);
  }

  private void run() {
    Command command = found.getSelectedValue();
    if (command != null && command.isEnabled()) {
      dispose();
      // Once the window has its focus back, as if its menu had been used.
      SwingUtilities.invokeLater(
          () -> command.actionPerformed(new ActionEvent(this, 0, command.id())));
    }
  }

  /** A list as wide as what shows it, so that the keys on its right are seen. */
  private static final class Found extends JList<Command> {
    private static final long serialVersionUID = 1L;

    @Override
    public boolean getScrollableTracksViewportWidth() {
      return true;
    }
  }

  private final class Move extends AbstractAction {
    private static final long serialVersionUID = 1L;
    private final transient IntUnaryOperator move;

    Move(IntUnaryOperator move) {
      this.move = move;
    }

    @Override
    public void actionPerformed(ActionEvent e) {
      int last = found.getModel().getSize() - 1;
      int index = Math.max(0, Math.min(last, move.applyAsInt(found.getSelectedIndex())));
      found.setSelectedIndex(index);
      found.ensureIndexIsVisible(index);
    }
  }
}
