package dct.ui.vertices;

import dct.core.Decimals;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.core.triangulate.Triangulation;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.tool.ToolContext;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.table.AbstractTableModel;

/**
 * The vertices of a document as rows: number, x, y, degree, wish. What a cell shows is looked up
 * when it is painted, so that showing another document costs nothing, however large it is. What is
 * typed becomes a named edit.
 */
final class VertexRows extends AbstractTableModel {
  private static final long serialVersionUID = 1L;

  static final int NUMBER = 0;
  static final int X = 1;
  static final int Y = 2;
  static final int DEGREE = 3;
  static final int WISH = 4;
  private static final String[] COLUMNS = {"No.", "x", "y", "Deg.", "Wish"};

  private final transient ToolContext context;
  private transient Document document = Document.empty(Domain.POLYGON);
  private transient Optional<Triangulation> triangulation = Optional.empty();

  /** No rows yet; the context performs the edits. */
  VertexRows(ToolContext context) {
    this.context = context;
  }

  /**
   * Shows another document.
   *
   * @param made the triangulation whose degrees are shown, if there is any
   */
  void show(Document shown, Optional<Triangulation> made) {
    int before = getRowCount();
    boolean other = shown.domain() != document.domain();
    document = shown;
    // While duplicates are merged, the numbers of the triangulation are not those of the rows.
    triangulation = made.filter(t -> t.vertexCount() == shown.size());
    int after = getRowCount();
    if (other) {
      fireTableDataChanged();
    } else if (before < after) {
      fireTableRowsInserted(before, after - 1);
    } else if (before > after) {
      fireTableRowsDeleted(after, before - 1);
    }
    if (after > 0) {
      fireTableRowsUpdated(0, after - 1);
    }
  }

  /** What is shown. */
  Document document() {
    return document;
  }

  @Override
  public int getRowCount() {
    return document.size();
  }

  @Override
  public int getColumnCount() {
    return COLUMNS.length;
  }

  @Override
  public String getColumnName(int column) {
    return COLUMNS[column];
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return column == WISH ? Wish.class : String.class;
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return isCoordinate(column) || column == WISH;
  }

  static boolean isCoordinate(int column) {
    return column == X || column == Y;
  }

  @Override
  public Object getValueAt(int row, int column) {
    return switch (column) {
      case NUMBER -> "v" + row;
      case X -> Decimals.format(document.points().x(row));
      case Y -> Decimals.format(document.points().y(row));
      case DEGREE -> degree(triangulation, row);
      default -> document.wishes().wish(row);
    };
  }

  /** Whether vertex v has an even degree; nothing while it has none. */
  Optional<Boolean> isEven(int v) {
    return triangulation.map(t -> t.isEven(v));
  }

  /**
   * Why a text cannot stand in a cell; nothing if it can.
   *
   * @return one sentence with the cure
   */
  Optional<String> fault(String typed, int row, int column) {
    double value = Decimals.parse(typed.strip());
    if (!Double.isFinite(value)) {
      return Optional.of("“" + typed.strip() + "” is no coordinate; type a number such as 12.5");
    }
    int there = twin(row, column, value);
    return there < 0
        ? Optional.empty()
        : Optional.of("v" + there + " is already there; type another place for v" + row);
  }

  /** Another site at the place where the coordinate would put this one, or −1. */
  private int twin(int row, int column, double value) {
    if (document.domain() != Domain.SITES) {
      return -1;
    }
    Points points = document.points();
    int there =
        document.vertexAt(column == X ? value : points.x(row), column == Y ? value : points.y(row));
    return there == row ? -1 : there;
  }

  @Override
  public void setValueAt(Object value, int row, int column) {
    if (value instanceof Wish wish) {
      wish(wish, row);
    } else if (value instanceof String typed) {
      Optional<String> fault = fault(typed, row, column);
      if (fault.isPresent()) {
        context.say(fault.get());
      } else {
        move(row, column, Decimals.parse(typed.strip()) + 0.0); // −0 becomes 0
      }
    }
  }

  private void move(int row, int column, double value) {
    Document present = context.document(); // without what is only provisional
    Points points = present.points();
    double x = column == X ? value : points.x(row);
    double y = column == Y ? value : points.y(row);
    if (x != points.x(row) || y != points.y(row)) {
      context.perform(Edit.move(present, row, x, y));
    }
  }

  /** Wishes the same of these vertices, as one edit; nothing if it is wished of all already. */
  void wish(Wish wish, int... rows) {
    Document present = context.document();
    ParityGoal wishes = present.wishes();
    int[] others = Arrays.stream(rows).filter(v -> wishes.wish(v) != wish).toArray();
    if (others.length == 1) {
      context.perform(Edit.wish(present, others[0], wish));
    } else if (others.length > 1) {
      Wish[] changed = new Wish[wishes.size()];
      Arrays.setAll(changed, wishes::wish);
      for (int v : others) {
        changed[v] = wish;
      }
      String label = "Wish Parity of " + others.length + " Vertices";
      context.perform(Edit.wishes(label, present, ParityGoal.of(changed)));
    }
  }

  /** The word for a wish. */
  static String word(Wish wish) {
    return wish.name().toLowerCase(Locale.ROOT);
  }

  /**
   * What these rows are now, as text: a line for each, its cells separated by tabs. It is written
   * only when it is asked for.
   */
  Supplier<String> copy(int... chosen) {
    Document of = document;
    Optional<Triangulation> made = triangulation;
    return () -> text(of, made, chosen);
  }

  private static String text(Document of, Optional<Triangulation> made, int... chosen) {
    StringBuilder text = new StringBuilder();
    for (int v : chosen) {
      text.append(v).append('\t');
      Decimals.append(text, of.points().x(v));
      text.append('\t');
      Decimals.append(text, of.points().y(v));
      text.append('\t').append(degree(made, v));
      text.append('\t').append(word(of.wishes().wish(v))).append('\n');
    }
    return text.toString();
  }

  private static String degree(Optional<Triangulation> made, int v) {
    return made.map(t -> Integer.toString(t.degree(v))).orElse("–");
  }
}
