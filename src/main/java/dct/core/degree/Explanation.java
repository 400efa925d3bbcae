package dct.core.degree;

import java.util.ArrayList;
import java.util.List;

/**
 * Why a bound holds, for a person: a few plain sentences with the numbers of this instance, and
 * what of it can be seen on the picture.
 *
 * @param title a clause for a heading
 * @param sentences in the order in which they are read
 * @param marks to be drawn over the points, the lower ones first
 */
public record Explanation(String title, List<String> sentences, List<Mark> marks) {

  /** The lists are copied. */
  public Explanation {
    sentences = List.copyOf(sentences);
    marks = List.copyOf(marks);
  }

  /** The same with sentences before its own. */
  public Explanation after(List<String> first) {
    List<String> all = new ArrayList<>(first);
    all.addAll(sentences);
    return new Explanation(title, all, marks);
  }

  /** Title and sentences as lines of text. */
  public String text() {
    return title + ".\n" + String.join("\n", sentences);
  }
}
