package dct.ui.flip;

import dct.core.degree.Flip;
import dct.core.degree.FlipResult;
import dct.core.degree.FlipWalk;
import dct.ui.tool.FlipTool;
import java.util.ArrayList;
import java.util.List;
import javax.swing.table.AbstractTableModel;

/** The table of flips: a row each, with what it gains. */
final class FlipRows extends AbstractTableModel {
  private static final long serialVersionUID = 1L;
  private static final List<String> COLUMNS = List.of("Flip", "Removed", "Made", "Even");

  /** No flips. */
  static final FlipRows NONE = new FlipRows(List.of(), new byte[0]);

  private final transient List<Flip> flips;
  private final byte[] gains; // −4 … 4

  private FlipRows(List<Flip> flips, byte[] gains) {
    this.flips = flips;
    this.gains = gains;
  }

  /** The rows of these flips, in linear time. */
  static FlipRows of(FlipResult result) {
    FlipWalk walk = new FlipWalk(result.before());
    List<Flip> flips = new ArrayList<>(result.flips());
    byte[] gains = new byte[result.flips()];
    for (int edge : result.edges()) {
      int before = walk.counts().even();
      flips.add(walk.flip(edge));
      gains[flips.size() - 1] = (byte) (walk.counts().even() - before);
    }
    return new FlipRows(flips, gains);
  }

  /** The flip in a row. */
  Flip flip(int row) {
    return flips.get(row);
  }

  @Override
  public int getRowCount() {
    return flips.size();
  }

  @Override
  public int getColumnCount() {
    return COLUMNS.size();
  }

  @Override
  public String getColumnName(int column) {
    return COLUMNS.get(column);
  }

  @Override
  public Object getValueAt(int row, int column) {
    return switch (column) {
      case 0 -> Integer.toString(row + 1);
      case 1 -> flips.get(row).removed();
      case 2 -> flips.get(row).made();
      default -> FlipTool.signed(gains[row]);
    };
  }
}
