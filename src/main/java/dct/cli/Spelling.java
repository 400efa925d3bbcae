package dct.cli;

import java.util.Collection;
import java.util.Comparator;

/** Finds the word that was meant where another was typed. */
final class Spelling {
  private static final int LETTERS_PER_SLIP = 3; // one letter in three may be wrong

  private Spelling() {}

  /**
   * A remark in brackets that names the known word nearest to the one typed, with a space before
   * it; empty if none is near. Takes time proportional to the number of letters squared.
   */
  static String hint(String typed, Collection<String> known) {
    return known.stream()
        .filter(word -> distance(typed, word) <= word.length() / LETTERS_PER_SLIP)
        .min(Comparator.comparingInt(word -> distance(typed, word)))
        .map(word -> " (did you mean " + word + "?)")
        .orElse("");
  }

  /**
   * How many letters have to be inserted, removed, replaced or exchanged with their neighbour to
   * make one word of the other (optimal string alignment).
   */
  static int distance(String a, String b) {
    int[][] cost = new int[a.length() + 1][b.length() + 1];
    for (int i = 0; i <= a.length(); i++) {
      for (int j = 0; j <= b.length(); j++) {
        cost[i][j] = i == 0 || j == 0 ? i + j : cheapest(cost, a, b, i, j);
      }
    }
    return cost[a.length()][b.length()];
  }

  private static int cheapest(int[][] cost, String a, String b, int i, int j) {
    int replaced = cost[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
    int best = Math.min(replaced, 1 + Math.min(cost[i - 1][j], cost[i][j - 1]));
    boolean exchanged =
        i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1);
    return exchanged ? Math.min(best, cost[i - 2][j - 2] + 1) : best;
  }
}
