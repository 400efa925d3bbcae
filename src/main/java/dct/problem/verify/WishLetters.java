package dct.problem.verify;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import java.util.Optional;

/** A parity goal as one letter a vertex: {@code e} even, {@code o} odd, {@code a} any. */
public final class WishLetters {
  private static final String LETTERS = "eoa";

  private WishLetters() {}

  /** The letters of a goal, in the order of the vertices. */
  public static String of(ParityGoal goal) {
    StringBuilder letters = new StringBuilder(goal.size());
    for (int v = 0; v < goal.size(); v++) {
      letters.append(
          switch (goal.wish(v)) {
            case EVEN -> 'e';
            case ODD -> 'o';
            case ANY -> 'a';
          });
    }
    return letters.toString();
  }

  /** The goal with these letters, or nothing if one of them is another letter. */
  public static Optional<ParityGoal> parse(String letters) {
    Wish[] wishes = new Wish[letters.length()];
    for (int v = 0; v < wishes.length; v++) {
      char letter = letters.charAt(v);
      if (LETTERS.indexOf(letter) < 0) {
        return Optional.empty();
      }
      wishes[v] = letter == 'e' ? Wish.EVEN : letter == 'o' ? Wish.ODD : Wish.ANY;
    }
    return Optional.of(ParityGoal.of(wishes));
  }
}
