package dct.core.dcel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.catchThrowable;

import dct.core.Progress;
import java.util.Random;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every law of the structure, broken on purpose, is found and called by its name. */
class DcelValidatorTest {

  /** A way to do harm, and the law that it breaks. */
  record Harm(String law, String at, Consumer<Dcel> doIt) {
    @Override
    public String toString() {
      return law + " at " + at;
    }
  }

  // The hexagon 0 … 5 with the diagonals 0–2 (edge 6), 2–4 (edge 7), 4–0 (edge 8).
  static Stream<Harm> harms() {
    return Stream.of(
        new Harm("next in range", "half-edge 3", d -> d.next[3] = 18),
        new Harm("next in range", "half-edge 3", d -> d.next[3] = -2),
        new Harm("prev in range", "half-edge 12", d -> d.prev[12] = 99),
        new Harm("prev in range", "half-edge 5", d -> d.prev[5] = Dcel.NONE),
        new Harm("origin in range", "half-edge 0", d -> d.origin[0] = 6),
        new Harm("origin in range", "half-edge 1", d -> d.origin[1] = -1),
        new Harm("face in range", "half-edge 4", d -> d.face[4] = 77),
        new Harm("face in range", "half-edge 4", d -> d.face[4] = Dcel.NONE),
        new Harm("face in range", "half-edge ", d -> d.faceEdge[d.face[0]] = Dcel.NONE),
        new Harm("prev(next(e)) = e", "half-edge 0", d -> d.prev[d.next[0]] = d.next[0]),
        new Harm("next(prev(e)) = e", "half-edge 0", d -> d.next[d.prev[0]] = 4),
        new Harm("origin(next(e)) = target(e)", "half-edge ", d -> d.origin[6] = 1),
        new Harm("face(next(e)) = face(e)", "half-edge ", d -> d.face[6] = d.face[7 * 2]),
        new Harm("degree(v) counts the edges at v", "vertex 3", d -> d.degree[3] = 3),
        new Harm("outEdge(v) exists", "vertex 3", d -> d.outEdge[3] = Dcel.NONE),
        new Harm("origin(outEdge(v)) = v", "vertex 3", d -> d.outEdge[3] = d.outEdge[4]),
        new Harm("origin(outEdge(v)) = v", "vertex 3", d -> d.outEdge[3] = 1000),
        new Harm("one turn around v", "vertex ", DcelValidatorTest::pinchTwoVertices),
        new Harm("face(faceEdge(f)) = f", "face 1", d -> d.faceEdge[1] = d.faceEdge[2]),
        new Harm("face(faceEdge(f)) = f", "face 2", d -> d.faceEdge[2] = 5000),
        new Harm("one cycle around f", "face ", DcelValidatorTest::giveTwoCyclesOneFace));
  }

  @ParameterizedTest
  @MethodSource("harms")
  void namesTheBrokenLaw(Harm harm) {
    Dcel dcel = hexagon();
    DcelValidator.validate(dcel);
    harm.doIt.accept(dcel);
    assertThat(catchThrowable(() -> DcelValidator.validate(dcel)))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("broken law: " + harm.law + " (")
        .hasMessageContaining(harm.at);
  }

  @Test
  void namesEulersFormulaForTwoComponents() {
    int[] next = {2, 5, 4, 1, 0, 3, 8, 11, 10, 7, 6, 9};
    int[] origin = {0, 1, 1, 2, 2, 0, 3, 4, 4, 5, 5, 3};
    Dcel dcel = Dcel.of(6, HalfEdges.of(next, origin), 1, Progress.NONE);
    assertThat(catchThrowable(() -> DcelValidator.validate(dcel)))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("broken law: vertices − edges + faces = 2 (at sum 4)");
  }

  @Test
  void namesSomeLawForEveryChangedNumber() {
    Random random = new Random(1);
    int[] lengths = {18, 18, 18, 18, 5, 6, 6};
    for (int k = 0; k < 20_000; k++) {
      Dcel dcel = hexagon();
      int which = random.nextInt(lengths.length);
      int[] array = arrays(dcel)[which];
      int at = random.nextInt(lengths[which]);
      int old = array[at];
      array[at] = random.nextInt(22) - 2;
      boolean harmless = array[at] == old || otherRepresentative(dcel, which, at);
      if (harmless) {
        assertThatCode(() -> DcelValidator.validate(dcel)).doesNotThrowAnyException();
      } else {
        assertThat(catchThrowable(() -> DcelValidator.validate(dcel)))
            .as("array %d, place %d, %d → %d", which, at, old, array[at])
            .isInstanceOf(IllegalStateException.class);
      }
    }
  }

  /** faceEdge and outEdge may be any half-edge of the face or vertex. */
  private static boolean otherRepresentative(Dcel dcel, int which, int at) {
    int value = arrays(dcel)[which][at];
    boolean inRange = value >= 0 && value < 18;
    return inRange
        && ((which == 4 && dcel.face[value] == at) || (which == 5 && dcel.origin[value] == at));
  }

  private static int[][] arrays(Dcel d) {
    return new int[][] {d.next, d.prev, d.origin, d.face, d.faceEdge, d.outEdge, d.degree};
  }

  private static Dcel hexagon() {
    Dcel dcel = Dcel.cycle(0, 1, 2, 3, 4, 5);
    int d = dcel.splitFace(0, 4);
    int e = dcel.splitFace(4, 8);
    dcel.splitFace(8, d);
    assertThat(dcel.edgeCount()).isEqualTo(9);
    assertThat(e).isEqualTo(14);
    return dcel;
  }

  /** Two turns around one vertex: vertex 3 (two edges) is renamed to vertex 1 (two edges). */
  private static void pinchTwoVertices(Dcel d) {
    for (int e = 0; e < 18; e++) {
      if (d.origin[e] == 3) {
        d.origin[e] = 1;
      }
    }
    d.degree[1] += d.degree[3];
    d.degree[3] = 0;
    d.outEdge[3] = Dcel.NONE;
  }

  private static void giveTwoCyclesOneFace(Dcel d) {
    int f = d.face[0];
    int g = d.face[4];
    for (int e = 0; e < 18; e++) {
      if (d.face[e] == g) {
        d.face[e] = f;
      }
    }
    d.faceEdge[g] = Dcel.NONE;
  }
}
