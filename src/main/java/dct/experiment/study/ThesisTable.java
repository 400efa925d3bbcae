package dct.experiment.study;

import dct.experiment.generate.SiteShape;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The figures of the thesis's Table 4.4: 5 sets of 10 sizes, Delaunay and then Scan-Flip. Two rows,
 * (set 2, 450) and (set 4, 100), end with an odd number of odd vertices, which no graph has; they
 * are given as printed.
 */
public final class ThesisTable {
  /** The shape of the sets, as far as the thesis says: random. */
  public static final String SHAPE = SiteShape.UNIFORM.word();

  /** The number of sets of each size. */
  public static final int SETS = 5;

  private static final String RESOURCE = "table-4-4.csv";

  /**
   * A row of the table.
   *
   * @param set the number of the set
   * @param n the number of sites
   * @param evenBefore the even vertices of the Delaunay triangulation
   * @param evenAfter the even vertices after Scan-Flip
   */
  public record Row(int set, int n, int evenBefore, int evenAfter) {

    /** By how much the even vertices increased, in per cent. */
    double increase() {
      return 100.0 * (evenAfter - evenBefore) / evenBefore;
    }
  }

  private final List<Row> rows;

  private ThesisTable(List<Row> rows) {
    this.rows = List.copyOf(rows);
  }

  /** Reads the table from the program's resources. */
  public static ThesisTable read() {
    try (InputStream in = ThesisTable.class.getResourceAsStream(RESOURCE);
        BufferedReader reader =
            new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
      return new ThesisTable(reader.lines().skip(1).map(ThesisTable::row).toList());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A line has set, n, odd before and after, even before and after, and the increase. */
  private static Row row(String line) {
    String[] cells = line.split(",", -1);
    return new Row(number(cells[0]), number(cells[1]), number(cells[4]), number(cells[5]));
  }

  private static int number(String cell) {
    return Integer.parseInt(cell);
  }

  /** All rows, set by set. */
  public List<Row> rows() {
    return rows;
  }

  /** The row of this set and size. */
  Optional<Row> row(int set, int n) {
    return rows.stream().filter(row -> row.set == set && row.n == n).findFirst();
  }

  /** The rows of this size. */
  List<Row> rows(int n) {
    return rows.stream().filter(row -> row.n == n).toList();
  }

  /** The sizes, in ascending order. */
  public static List<Integer> sizes() {
    List<Integer> sizes = new ArrayList<>();
    for (int n = 50; n <= 500; n += 50) {
      sizes.add(n);
    }
    return sizes;
  }
}
