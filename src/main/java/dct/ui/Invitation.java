package dct.ui;

import com.formdev.flatlaf.FlatClientProperties;
import dct.core.triangulate.Domain;
import dct.ui.command.CommandRegistry;
import dct.ui.file.Samples;
import java.awt.Component;
import java.awt.FlowLayout;
import java.awt.KeyboardFocusManager;
import java.awt.event.FocusEvent;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.SwingUtilities;

/** Says in the middle of an empty canvas what to do with it, and offers something to begin with. */
final class Invitation extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int GAP = 10;

  /** What an empty canvas can be: one card for each. */
  private enum Card {
    START(
        "Degree Constrained Triangulation",
        "Choose Polygon Based or Point Sites Based on the right.",
        "Open"),
    POLYGON(
        "Click to draw the first vertex",
        "The polygon closes by itself. Or begin with something that is there:",
        "Random Polygon…"),
    SITES("Click to draw the first site", "Or begin with something that is there:", "Random Sites");

    private final String title;
    private final String line;
    private final String command;

    Card(String title, String line, String command) {
      this.title = title;
      this.line = line;
      this.command = command;
    }

    static Card of(Optional<Domain> domain) {
      return domain.map(d -> d == Domain.POLYGON ? POLYGON : SITES).orElse(START);
    }
  }

  private final transient Consumer<String> openSample;
  private final Map<Card, JComponent> cards = new EnumMap<>(Card.class);
  private final Map<Card, JLabel> titles = new EnumMap<>(Card.class);

  /**
   * An invitation that offers commands and samples.
   *
   * @param openSample opens the sample of a name
   */
  Invitation(CommandRegistry commands, Consumer<String> openSample) {
    this.openSample = openSample;
    setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
    setOpaque(false);
    for (Card card : Card.values()) {
      JComponent shown = component(card, commands);
      cards.put(card, shown);
      add(shown);
    }
  }

  /**
   * Invites to what can be done with an empty document, or without one.
   *
   * @param drawing whether a click draws
   */
  void show(Optional<Domain> domain, boolean empty, boolean drawing) {
    Component focused = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    boolean held = focused != null && SwingUtilities.isDescendingFrom(focused, this);
    for (Card card : Card.values()) {
      cards.get(card).setVisible(empty && card == Card.of(domain));
      boolean other = card != Card.START && !drawing;
      titles.get(card).setText(other ? "Choose Draw Vertex to draw" : card.title);
    }
    if (held && !focused.isShowing()) {
      getParent().requestFocusInWindow(FocusEvent.Cause.TRAVERSAL); // the canvas, to draw on
    }
  }

  private JComponent component(Card card, CommandRegistry commands) {
    JPanel column = new JPanel();
    column.setLayout(new BoxLayout(column, BoxLayout.Y_AXIS));
    column.setOpaque(false);
    JLabel title = label(card.title, "h1");
    titles.put(card, title);
    column.add(title);
    column.add(Box.createVerticalStrut(GAP));
    column.add(label(card.line, ""));
    column.add(Box.createVerticalStrut(GAP));
    JPanel row = new JPanel(new FlowLayout(FlowLayout.CENTER, GAP, 0));
    row.setOpaque(false);
    row.add(samples(card));
    JButton button = new JButton(commands.get(card.command));
    button.setText(card == Card.START ? "Open a File…" : card.command);
    row.add(named(button, card, card.command));
    column.add(row);
    return column;
  }

  private static JLabel label(String text, String style) {
    JLabel label = new JLabel(text);
    label.putClientProperty(FlatClientProperties.STYLE_CLASS, style);
    label.setAlignmentX(Component.CENTER_ALIGNMENT);
    return label;
  }

  private static JButton named(JButton button, Card card, String name) {
    button.setName(name + ", " + card.title);
    button.setFocusable(true);
    return button;
  }

  private JButton samples(Card card) {
    JPopupMenu menu = new JPopupMenu();
    for (Domain domain : Domain.applications()) {
      if (card == Card.START || card == Card.of(Optional.of(domain))) {
        if (menu.getComponentCount() > 0) {
          menu.addSeparator();
        }
        Samples.names(domain).forEach(name -> menu.add(item(name)));
      }
    }
    JButton button = new JButton("Open a Sample ▾");
    button.getAccessibleContext().setAccessibleName("Open a Sample");
    button.setToolTipText("Opens one of the files that come with the program");
    button.addActionListener(e -> menu.show(button, 0, button.getHeight()));
    return named(button, card, "Sample");
  }

  private JMenuItem item(String name) {
    JMenuItem item = new JMenuItem(Samples.title(name));
    item.setName(name + ", invited");
    item.addActionListener(e -> openSample.accept(name));
    return item;
  }
}
