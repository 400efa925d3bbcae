package dct.ui.flip;

import dct.core.degree.FlipResult;
import dct.ui.command.Command;
import dct.ui.command.CommandRegistry;
import dct.ui.command.TableKeys;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSlider;
import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableCellRenderer;

/**
 * The flips of a view: their list, a player with a slider, and what else can be done with them.
 * Costs nothing while it is not visible.
 */
public final class FlipPanel extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int LIST_HEIGHT = 128;
  private static final int GAP = 6;

  /** So many flips and vertices are made a table within a frame of the screen. */
  private static final int AT_ONCE = 20_000;

  private static final Map<String, PlayIcon> ICONS =
      Map.of(
          "First Flip", PlayIcon.FIRST,
          "Previous Flip", PlayIcon.BACK,
          "Play Flips", PlayIcon.PLAY,
          "Next Flip", PlayIcon.FORWARD,
          "Last Flip", PlayIcon.LAST);
  private static final List<String> PLAYER =
      List.of("First Flip", "Previous Flip", "Play Flips", "Next Flip", "Last Flip");
  private static final List<String> ACTIONS =
      List.of("Go On from Here", "Save Flips…", "Load Flips…", "Copy Flips", "Apply Copied Flips");

  private final transient FlipDesk desk;
  private final transient FlipShow show;
  private final JTable table = new JTable(FlipRows.NONE);
  private final JSlider slider = new JSlider(0, 0, 0);
  private final JLabel place = new JLabel();
  private JButton play;
  private transient Optional<FlipResult> listed = Optional.empty();
  private boolean filling; // what changes in the table and slider is not the user's doing

  FlipPanel(FlipDesk desk, FlipShow show, CommandRegistry registry) {
    super(new BorderLayout(0, GAP));
    this.desk = desk;
    this.show = show;
    setName("flips");
    setBorder(BorderFactory.createEmptyBorder(GAP, 12, GAP, 12));
    setVisible(false);
    add(table(), BorderLayout.CENTER);
    JPanel controls = new JPanel(new BorderLayout(0, GAP));
    controls.add(player(registry), BorderLayout.NORTH);
    controls.add(actions(registry), BorderLayout.SOUTH);
    add(controls, BorderLayout.SOUTH);
    desk.addListener(this::refresh);
  }

  private JComponent table() {
    table.setName("flipList");
    table.getAccessibleContext().setAccessibleName("Flips");
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.getSelectionModel().addListSelectionListener(e -> selected());
    table.setDefaultRenderer(Object.class, new DefaultTableCellRenderer());
    table.setFillsViewportHeight(true);
    TableKeys.leaveByTab(table);
    TableKeys.tellOfCopies(table, desk::say);
    JScrollPane scroll = new JScrollPane(table);
    scroll.setPreferredSize(new Dimension(0, LIST_HEIGHT));
    return scroll;
  }

  private JComponent player(CommandRegistry registry) {
    JPanel buttons = new JPanel(new FlowLayout(FlowLayout.LEADING, 2, 0));
    for (String name : PLAYER) {
      JButton button = button(registry.get(name));
      button.setIcon(ICONS.get(name));
      button.setHideActionText(true);
      buttons.add(button);
      if (name.equals("Play Flips")) {
        play = button;
      }
    }
    slider.setName("flipSlider");
    slider.getAccessibleContext().setAccessibleName("Flips carried out");
    slider.setToolTipText("Shows the triangulation after so many flips");
    slider.addChangeListener(e -> slid());
    place.setName("flipPlace");
    JPanel row = new JPanel(new BorderLayout(GAP, 0));
    row.add(buttons, BorderLayout.WEST);
    row.add(slider, BorderLayout.CENTER);
    row.add(place, BorderLayout.EAST);
    return row;
  }

  private static JComponent actions(CommandRegistry registry) {
    JPanel row = new JPanel(new FlowLayout(FlowLayout.LEADING, GAP, 0));
    ACTIONS.forEach(name -> row.add(button(registry.get(name))));
    return row;
  }

  private static JButton button(Command command) {
    JButton button = new JButton(command);
    button.setName(command.id());
    button.getAccessibleContext().setAccessibleName(command.id());
    return button;
  }

  /** Shows or hides the panel. */
  void setShown(boolean shown) {
    setVisible(shown);
    if (shown) {
      refresh();
    }
    revalidate();
  }

  /** Brings the panel up to date. */
  void refresh() {
    if (isVisible()) {
      fill();
      filling = true;
      Replay replay = desk.replay();
      slider.setMaximum(replay.size());
      slider.setValue(replay.index());
      slider.setEnabled(replay.size() > 0);
      place.setText(words(replay));
      play.setIcon(show.isPlaying() ? PlayIcon.PAUSE : PlayIcon.PLAY);
      select(replay.last().isPresent() ? replay.index() - 1 : -1);
      filling = false;
    }
  }

  private String words(Replay replay) {
    if (replay.size() == 0) {
      return desk.shown().isPresent() ? "No flips yet" : "Nothing to flip";
    }
    return String.format(Locale.ROOT, "%d of %d", replay.index(), replay.size());
  }

  /** Lists other flips; many in the background. */
  private void fill() {
    Optional<FlipResult> flips = desk.replay().flips();
    if (flips.equals(listed)) {
      return;
    }
    listed = flips;
    if (flips.isEmpty()) {
      show(FlipRows.NONE);
    } else if (flips.get().flips() + flips.get().before().vertexCount() <= AT_ONCE) {
      show(FlipRows.of(flips.get()));
    } else {
      show(FlipRows.NONE);
      desk.jobs()
          .update(
              "Listing the flips",
              progress -> FlipRows.of(flips.get()),
              rows -> {
                if (listed.equals(flips)) {
                  show(rows);
                }
              });
    }
  }

  private void show(FlipRows rows) {
    filling = true;
    table.setModel(rows);
    filling = false;
  }

  private void select(int row) {
    if (row < 0 || row >= table.getRowCount()) {
      table.clearSelection();
    } else if (table.getSelectedRow() != row) {
      table.setRowSelectionInterval(row, row);
      table.scrollRectToVisible(table.getCellRect(row, 0, true));
    }
  }

  private void selected() {
    int row = table.getSelectedRow();
    if (!filling && row >= 0) {
      show.goTo(row + 1);
    }
  }

  private void slid() {
    if (!filling) {
      show.goTo(slider.getValue());
    }
  }
}
