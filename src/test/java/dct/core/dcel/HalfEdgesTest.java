package dct.core.dcel;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.dcel.HalfEdges.FreeEdges;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * The operators of {@link HalfEdges}, each undone by its inverse.
 *
 * <pre>
 * HalfEdges links = new HalfEdges(2, 3); // room for three edges
 * int a = links.segment(0, 0, 1); // vertices 0 → 1
 * int b = links.segment(2, 1, 2); // vertices 1 → 2
 * links.link(a, b);
 * links.link(b ^ 1, a ^ 1); // the path 0, 1, 2
 * links.connect(links.take(), b ^ 1, a); // the triangle
 * </pre>
 */
class HalfEdgesTest {

  private static HalfEdges triangle() {
    HalfEdges links = new HalfEdges(2, 3);
    int a = links.segment(0, 0, 1);
    int b = links.segment(2, 1, 2);
    links.link(a, b);
    links.link(b ^ 1, a ^ 1);
    links.connect(links.take(), b ^ 1, a);
    return links;
  }

  @Test
  void theExampleMakesATriangle() {
    HalfEdges links = triangle();
    assertThat(links.next()).containsExactly(2, 5, 4, 1, 0, 3);
    assertThat(links.prev()).containsExactly(4, 3, 0, 5, 2, 1);
    assertThat(links.origin()).containsExactly(0, 1, 1, 2, 2, 0);
    assertThat(links.size()).isEqualTo(3);
  }

  @Test
  void removeUndoesConnectAlsoBetweenTwoComponents() {
    HalfEdges links = new HalfEdges(2, 3);
    links.segment(0, 0, 1);
    links.segment(2, 2, 3);
    String before = state(links);
    int d = links.connect(links.take(), 1, 2);
    assertThat(cycle(links, 0)).containsExactly(0, d, 2, 3, d ^ 1, 1);
    links.remove(d);
    links.give(d);
    assertThat(state(links)).isEqualTo(before);
  }

  @Test
  void fourFlipsRestoreEveryLink() {
    HalfEdges links = triangle();
    int far = links.hang(links.take(), 3, 3); // outside, at vertex 2
    int e = links.connect(links.take(), far, 1); // from vertex 3 to vertex 1
    assertThat(cycle(links, e ^ 1)).hasSize(3);
    String before = state(links);
    links.flip(2); // the edge 1–2 becomes 3–0
    assertThat(new int[] {links.origin[2], links.origin[3]}).containsExactlyInAnyOrder(0, 3);
    links.flip(2);
    assertThat(new int[] {links.origin[2], links.origin[3]}).containsExactly(2, 1);
    links.flip(2);
    links.flip(2);
    assertThat(state(links)).isEqualTo(before);
  }

  @Test
  void unhangUndoesHangAndJoinUndoesSplitAtEveryHalfEdge() {
    for (int e = 0; e < 6; e++) {
      HalfEdges links = triangle();
      String before = state(links);
      int d = links.hang(links.take(), 3, e);
      assertThat(links.prev[e]).isEqualTo(d);
      int f = links.split(links.take(), d, 4); // of an edge with a free end
      links.join(f);
      links.give(f);
      links.unhang(d);
      links.give(d);
      assertThat(state(links)).as("half-edge %d", e).isEqualTo(before);
      d = links.split(links.take(), e, 3);
      assertThat(links.next[e]).isEqualTo(d);
      links.join(d);
      links.give(d);
      assertThat(state(links)).as("half-edge %d", e).isEqualTo(before);
    }
  }

  @Test
  void theEdgeGivenLastIsTakenFirst() {
    HalfEdges links = triangle();
    links.give(1);
    links.give(4);
    assertThat(links.size()).isEqualTo(1);
    assertThat(links.has(0)).isFalse();
    assertThat(links.take()).isEqualTo(4);
    assertThat(links.take()).isZero();
    assertThat(links.take()).as("a new one").isEqualTo(6);
    assertThat(links.bound()).isEqualTo(4);
  }

  @Test
  void listsOfFreeEdgesCanBeJoined() {
    HalfEdges links = new HalfEdges(8, 8);
    FreeEdges left = new FreeEdges();
    FreeEdges right = new FreeEdges();
    links.append(left, right);
    links.append(left, filled(links, right, 0, 2));
    links.append(left, new FreeEdges());
    links.append(left, filled(links, new FreeEdges(), 6, 4));
    assertThat(new int[] {links.take(left), links.take(left)}).containsExactly(2, 0);
    links.give(left, 10);
    assertThat(new int[] {links.take(left), links.take(left), links.take(left)})
        .containsExactly(10, 4, 6);
    links.give(left, 12);
    assertThat(links.take(left)).as("filled anew").isEqualTo(12);
  }

  private static FreeEdges filled(HalfEdges links, FreeEdges list, int... halfEdges) {
    for (int e : halfEdges) {
      links.give(list, e);
    }
    return list;
  }

  @Test
  void closeGapsKeepsTheGraphAndSaysWhereAHalfEdgeWent() {
    for (int seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      int n = 3 + random.nextInt(10);
      HalfEdges links = Dcel.cycle(walk(n)).links();
      int watched = -1;
      List<Integer> hung = new ArrayList<>();
      for (int k = 0; k < 10; k++) {
        hung.add(links.hang(links.take(), n + k, 2 * random.nextInt(n) + 1));
      }
      for (int d : hung.subList(0, random.nextInt(10))) {
        links.unhang(d);
        links.give(d);
      }
      watched = hung.get(9);
      List<Integer> before = origins(links, watched);
      int edges = links.size();
      watched = links.closeGaps(watched)[0];
      assertThat(origins(links, watched)).as("seed %d", seed).isEqualTo(before);
      assertThat(links.bound()).isEqualTo(edges);
    }
  }

  private static int[] walk(int n) {
    int[] walk = new int[n];
    Arrays.setAll(walk, k -> k);
    return walk;
  }

  private static List<Integer> origins(HalfEdges links, int start) {
    return cycle(links, start).stream().map(e -> links.origin[e]).toList();
  }

  private static List<Integer> cycle(HalfEdges links, int start) {
    List<Integer> cycle = new ArrayList<>();
    int e = start;
    do {
      cycle.add(e);
      assertThat(links.prev[links.next[e]]).isEqualTo(e);
      e = links.next[e];
    } while (e != start);
    return cycle;
  }

  /** The links of all edges in use. */
  private static String state(HalfEdges links) {
    StringBuilder state = new StringBuilder();
    for (int e = 0; e < 2 * links.bound(); e++) {
      if (links.has(e >> 1)) {
        state.append(links.origin[e]).append(' ').append(links.next[e]).append(' ');
        state.append(links.prev[e]).append(", ");
      }
    }
    return state.toString();
  }
}
