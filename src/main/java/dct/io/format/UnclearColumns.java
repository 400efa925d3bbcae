package dct.io.format;

import java.util.List;

/** A table of numbers of which any two columns may be x and y, or whose first row is in doubt. */
public final class UnclearColumns extends UnclearInput {
  /** How many rows are enough to see what the columns hold. */
  public static final int ROWS = 5;

  private static final long serialVersionUID = 1L;

  private final transient List<double[]> rows;
  private final transient Columns likely;

  /**
   * Says what is unclear and how to choose.
   *
   * @param rows the first ones, in all their columns
   * @param likely what is meant, most likely
   */
  public UnclearColumns(String file, int line, String fault, List<double[]> rows, Columns likely) {
    super(file, line, fault);
    this.rows = List.copyOf(rows);
    this.likely = likely;
  }

  /** The first rows, in all their columns. */
  public List<double[]> rows() {
    return rows;
  }

  /** What is meant, most likely. */
  public Columns likely() {
    return likely;
  }
}
