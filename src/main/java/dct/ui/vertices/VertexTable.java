package dct.ui.vertices;

import com.formdev.flatlaf.FlatLaf;
import dct.core.degree.ParityGoal.Wish;
import dct.core.triangulate.Triangulation;
import dct.render.Ink;
import dct.render.Theme;
import dct.ui.command.TableKeys;
import dct.ui.document.Document;
import dct.ui.document.Selection;
import dct.ui.tool.ToolContext;
import java.awt.Color;
import java.awt.Component;
import java.awt.FontMetrics;
import java.awt.datatransfer.Transferable;
import java.awt.event.ActionEvent;
import java.awt.event.MouseEvent;
import java.util.Locale;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.DefaultCellEditor;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.TransferHandler;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.JTableHeader;

/**
 * The table of the vertices. Digits typed over x or y begin another coordinate, E, O and A over a
 * wish choose it; other letters are left to the commands of the window.
 */
final class VertexTable extends JTable {
  private static final long serialVersionUID = 1L;
  private static final int MARGIN = 10; // of a cell
  private static final int FEW = 1000; // rows for which there is always room
  private static final String[] TIPS = {
    "The vertex's number",
    "Its x; type another to move it",
    "Its y; type another to move it",
    "The number of edges at it",
    "The parity that is wished of its degree: E even, O odd, A any"
  };

  private final VertexRows rows;
  private boolean following; // the canvas, not the user

  /** A table of these rows; the context says what is wrong with a text. */
  VertexTable(VertexRows rows, ToolContext context) {
    super(rows);
    this.rows = rows;
    setName("vertices");
    getAccessibleContext().setAccessibleName("Vertices");
    getAccessibleContext()
        .setAccessibleDescription("Number, coordinates, degree and wished parity of each vertex");
    setSelectionMode(ListSelectionModel.MULTIPLE_INTERVAL_SELECTION);
    getTableHeader().setReorderingAllowed(false);
    setAutoResizeMode(AUTO_RESIZE_ALL_COLUMNS);
    fitColumns();
    putClientProperty("terminateEditOnFocusLost", true);
    TableKeys.leaveByTab(this);
    putClientProperty("JTable.autoStartsEdit", false);
    setSurrendersFocusOnKeystroke(true);
    setDefaultRenderer(String.class, new Cells());
    setDefaultRenderer(Wish.class, new Cells());
    setDefaultEditor(String.class, new CoordinateEditor(rows, context::say));
    setDefaultEditor(Wish.class, new DefaultCellEditor(wishes()));
    setTransferHandler(new Copies());
    TableKeys.tellOfCopies(this, () -> chosen().length, context::say);
    setDropTarget(null); // what is dropped is for the window
    addKeyListener(new NumberKeys(this));
    getSelectionModel()
        .addListSelectionListener(
            e -> {
              if (!e.getValueIsAdjusting() && !following) {
                context.select(Selection.of(getSelectedRows()));
              }
            });
    offerWishKeys();
  }

  /** Numbers, degrees and wishes are seen in full; x and y share the rest. */
  private void fitColumns() {
    fit(0, "v" + (Math.max(FEW, getRowCount()) - 1));
    fit(VertexRows.DEGREE, "");
    fit(VertexRows.WISH, VertexRows.word(Wish.EVEN));
  }

  private void fit(int column, String text) {
    FontMetrics letters = getFontMetrics(getFont());
    int width = letters.stringWidth(text);
    int head = letters.stringWidth(getColumnName(column));
    getColumnModel().getColumn(column).setMinWidth(MARGIN + Math.max(width, head));
    getColumnModel().getColumn(column).setPreferredWidth(MARGIN + Math.max(width, head));
  }

  private static JComboBox<Wish> wishes() {
    JComboBox<Wish> box = new JComboBox<>(Wish.values());
    box.setName("wish");
    box.getAccessibleContext().setAccessibleName("Wished parity");
    box.setRenderer(new Words());
    return box;
  }

  private void offerWishKeys() {
    for (Wish wish : Wish.values()) {
      String name = VertexRows.word(wish);
      String key = name.substring(0, 1).toUpperCase(Locale.ROOT);
      getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(key), name);
      getActionMap().put(name, new WishKey(wish));
    }
  }

  @Override
  protected JTableHeader createDefaultTableHeader() {
    return new JTableHeader(columnModel) {
      private static final long serialVersionUID = 1L;

      @Override
      public String getToolTipText(MouseEvent e) {
        int column = columnAtPoint(e.getPoint());
        return column < 0 ? null : TIPS[column];
      }
    };
  }

  /** The rows that are selected, or the one with the focus. */
  int[] chosen() {
    int[] selected = getSelectedRows();
    int focus = getSelectionModel().getLeadSelectionIndex();
    return selected.length > 0 || focus < 0 || focus >= getRowCount()
        ? selected
        : new int[] {focus};
  }

  /** The column with the focus. */
  int focusColumn() {
    return getColumnModel().getSelectionModel().getLeadSelectionIndex();
  }

  /** Wishes a parity of the chosen vertices; enabled while the column of wishes has the focus. */
  private final class WishKey extends AbstractAction {
    private static final long serialVersionUID = 1L;
    private final Wish wish;

    WishKey(Wish wish) {
      this.wish = wish;
    }

    @Override
    public boolean isEnabled() {
      return !isEditing() && focusColumn() == VertexRows.WISH;
    }

    @Override
    public void actionPerformed(ActionEvent e) {
      rows.wish(wish, chosen());
    }
  }

  /** Copies the rows that are selected as text, also millions of them at once. */
  private final class Copies extends TransferHandler {
    private static final long serialVersionUID = 1L;

    @Override
    public int getSourceActions(JComponent table) {
      return COPY;
    }

    @Override
    protected Transferable createTransferable(JComponent table) {
      int[] chosen = chosen();
      return chosen.length == 0 ? null : new RowsText(rows.copy(chosen));
    }
  }

  /** Numbers stand on the right; a degree has the colour of its parity. */
  private final class Cells extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;

    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      setForeground(selected || column != VertexRows.DEGREE ? null : ink(row));
      String text = value instanceof Wish wish ? VertexRows.word(wish) : String.valueOf(value);
      super.getTableCellRendererComponent(table, text, selected, focused, row, column);
      setHorizontalAlignment(
          column == VertexRows.WISH ? SwingConstants.LEADING : SwingConstants.TRAILING);
      setToolTipText(VertexRows.isCoordinate(column) ? text : null); // may not fit in
      return this;
    }

    private Color ink(int row) {
      Theme theme = FlatLaf.isLafDark() ? Theme.DARK : Theme.LIGHT;
      return rows.isEven(row)
          .map(even -> new Color((even ? Ink.EVEN : Ink.ODD).rgb(theme)))
          .orElse(null);
    }
  }

  /** The words of the wishes in their box. */
  private static final class Words implements ListCellRenderer<Wish> {
    private final DefaultListCellRenderer label = new DefaultListCellRenderer();

    @Override
    public Component getListCellRendererComponent(
        JList<? extends Wish> list, Wish wish, int index, boolean selected, boolean focused) {
      return label.getListCellRendererComponent(
          list, wish == null ? "" : VertexRows.word(wish), index, selected, focused);
    }
  }

  /**
   * Shows another document and what is selected of it; what is being typed is given up if its row
   * is gone.
   */
  void show(Document document, Optional<Triangulation> made, Selection selection) {
    boolean gone =
        isEditing()
            && (document.size() != rows.getRowCount()
                || document.domain() != rows.document().domain());
    if (gone) {
      removeEditor();
    }
    following = true;
    rows.show(document, made);
    fitColumns();
    follow(selection);
    following = false;
  }

  /** Selects the rows of the vertices that are selected, and shows the first of them. */
  private void follow(Selection selection) {
    if (Selection.of(getSelectedRows()).equals(selection)) {
      return;
    }
    ListSelectionModel model = getSelectionModel();
    model.setValueIsAdjusting(true);
    model.clearSelection();
    int first = selection.next(0);
    while (first >= 0 && first < getRowCount()) {
      int last = first;
      while (last + 1 < getRowCount() && selection.has(last + 1)) {
        last++;
      }
      model.addSelectionInterval(first, last);
      first = selection.next(last + 1);
    }
    model.setValueIsAdjusting(false);
    if (!selection.isEmpty()) {
      scrollRectToVisible(getCellRect(selection.next(0), 0, true));
    }
  }
}
