package dct.io.format;

import java.util.Optional;

/**
 * Which columns of a text hold x and y, where its content does not tell.
 *
 * @param xy the numbers of both columns, from 1 on
 * @param skipped how many lines at the front hold no points
 */
public record Columns(Optional<Pair> xy, int skipped) {

  /** The content tells. */
  public static final Columns TOLD_BY_CONTENT = new Columns(Optional.empty(), 0);

  /**
   * Two columns.
   *
   * @param x the number of the column of x, from 1 on
   * @param y that of y
   */
  public record Pair(int x, int y) {}
}
