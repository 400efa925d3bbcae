package dct.core.degree.bound;

import dct.core.degree.Explanation;
import dct.core.degree.Mark;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.degree.exact.OddSetProof.Proof;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Explains the bound of {@link dct.core.degree.exact.OddSetProof}. */
final class OddSetMarks {

  private OddSetMarks() {}

  /** The explanation, with the sites marked of which one at least misses its wish. */
  static Explanation of(Proof proof, ParityGoal goal) {
    boolean isEven = goal.isAll(Wish.EVEN);
    List<Mark> marks = new ArrayList<>();
    proof.sites().stream().forEach(v -> marks.add(new Mark.Vertex(v, Mark.Tone.ONE, "")));
    List<String> sentences = new ArrayList<>();
    sentences.add(
        "Suppose that a triangulation had exactly some odd vertices, and draw a ray from each of"
            + " them. Then its triangles can be coloured black and white so that neighbours differ,"
            + " but for an exchange of the colours across each ray; along the boundary the"
            + " colour changes at rays only.");
    sentences.add(
        "So each inner edge has a black triangle on one side and a white one on the other, and each"
            + " boundary edge a triangle of a colour that is known. For every set in question, every"
            + " choice of empty triangles and colours was refuted; a refutation serves for all sets"
            + " with the same parities inside the cycles that it used.");
    boolean isWished = proof.sites().stream().allMatch(v -> goal.wish(v) != Wish.ANY);
    if (isWished) {
      sentences.add(
          String.format(
              Locale.ROOT,
              isEven
                  ? "The refutation of all even rests on the %d marked vertices alone: one of them"
                      + " is odd in every triangulation."
                  : "The refutation of all wishes rests on the %d marked vertices alone: one of"
                      + " them misses its wish in every triangulation.",
              marks.size()));
    }
    return new Explanation("Refuted: " + proof.title(), sentences, marks);
  }
}
