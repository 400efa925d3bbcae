package dct.core.dcel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The operators of {@link Dcel} on random sequences, each against its law and the validator. */
class DcelTest {

  @ParameterizedTest
  @ValueSource(ints = {3, 4, 5, 17, 100})
  void aCycleIsWhatItSays(int n) {
    Dcel dcel = Dcel.cycle(walk(n));
    DcelValidator.validate(dcel);
    assertThat(dcel.vertexCount()).isEqualTo(n);
    assertThat(dcel.edgeCount()).isEqualTo(n);
    assertThat(dcel.faceCount()).isEqualTo(2);
    for (int k = 0; k < n; k++) {
      assertThat(dcel.origin(2 * k)).isEqualTo(k);
      assertThat(dcel.target(2 * k)).isEqualTo((k + 1) % n);
      assertThat(dcel.face(2 * k)).isEqualTo(1);
      assertThat(dcel.face(2 * k + 1)).isEqualTo(Dcel.OUTER);
      assertThat(dcel.degree(k)).isEqualTo(2);
      assertThat(dcel.isBoundary(k)).isTrue();
    }
  }

  @Test
  void aCycleKeepsTheNumbersOfTheWalk() {
    Dcel dcel = Dcel.cycle(0, 3, 2, 1);
    DcelValidator.validate(dcel);
    assertThat(dcel.origin(2)).isEqualTo(3);
    assertThat(dcel.target(2)).isEqualTo(2);
  }

  @Test
  void splitFaceLeavesBOnTheLeftAndAOnTheRight() {
    for (int seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      Dcel dcel = Dcel.cycle(walk(3 + random.nextInt(20)));
      for (int[] pair = splittable(dcel, random); pair != null; pair = splittable(dcel, random)) {
        int a = pair[0];
        int b = pair[1];
        int edges = dcel.edgeCount();
        int faces = dcel.faceCount();
        int d = dcel.splitFace(a, b);
        DcelValidator.validate(dcel);
        assertThat(dcel.origin(d)).as("seed %d", seed).isEqualTo(dcel.origin(a));
        assertThat(dcel.target(d)).isEqualTo(dcel.origin(b));
        assertThat(dcel.next(d)).isEqualTo(b);
        assertThat(dcel.next(Dcel.twin(d))).isEqualTo(a);
        assertThat(dcel.face(d)).isEqualTo(dcel.face(b)).isNotEqualTo(dcel.face(a));
        assertThat(dcel.edgeCount()).isEqualTo(edges + 1);
        assertThat(dcel.faceCount()).isEqualTo(faces + 1);
      }
      assertThat(dcel.edgeCount()).isEqualTo(2 * dcel.vertexCount() - 3);
    }
  }

  /** Or else n − 3 ear cuts would be quadratic. */
  @Test
  void splitFaceGivesTheNewFaceToTheShorterSide() {
    Dcel earOnTheRight = Dcel.cycle(walk(8));
    int d = earOnTheRight.splitFace(0, 4);
    assertThat(earOnTheRight.face(d)).isEqualTo(1);
    Dcel earOnTheLeft = Dcel.cycle(walk(8));
    int e = earOnTheLeft.splitFace(4, 0);
    assertThat(earOnTheLeft.face(Dcel.twin(e))).isEqualTo(1);
  }

  @Test
  void joinFacesUndoesSplitFace() {
    for (int seed = 0; seed < 500; seed++) {
      Random random = new Random(seed);
      Dcel dcel = randomSubdivision(random);
      int[] pair = splittable(dcel, random);
      if (pair != null) {
        String before = snapshot(dcel);
        int d = dcel.splitFace(pair[0], pair[1]);
        assertThat(dcel.canJoin(d)).isTrue();
        assertThat(dcel.joinFaces(d)).as("seed %d", seed).isEqualTo(pair[0]);
        DcelValidator.validate(dcel);
        assertThat(snapshot(dcel)).as("seed %d", seed).isEqualTo(before);
      }
    }
  }

  @Test
  void splitFaceUndoesJoinFaces() {
    for (int seed = 0; seed < 500; seed++) {
      Random random = new Random(seed);
      Dcel dcel = randomSubdivision(random);
      List<Integer> inner = handles(dcel).stream().filter(dcel::canJoin).toList();
      if (!inner.isEmpty()) {
        int e = inner.get(random.nextInt(inner.size()));
        int b = dcel.next(e);
        String before = snapshot(dcel);
        int a = dcel.joinFaces(e);
        DcelValidator.validate(dcel);
        int d = dcel.splitFace(a, b);
        DcelValidator.validate(dcel);
        assertThat(d >> 1).as("the number is used again, seed %d", seed).isEqualTo(e >> 1);
        assertThat(snapshot(dcel)).as("seed %d", seed).isEqualTo(before);
      }
    }
  }

  @Test
  void fourFlipsRestoreTheHandleAndTwoTheEdge() {
    for (int seed = 0; seed < 500; seed++) {
      Random random = new Random(seed);
      Dcel dcel = triangulated(4 + random.nextInt(20), random);
      List<Integer> flippable = handles(dcel).stream().filter(dcel::canFlip).toList();
      int e = flippable.get(random.nextInt(flippable.size()));
      String before = snapshot(dcel);
      int from = dcel.origin(e);
      int to = dcel.target(e);
      int left = dcel.origin(dcel.prev(e));
      int right = dcel.origin(dcel.prev(Dcel.twin(e)));
      dcel.flip(e);
      DcelValidator.validate(dcel);
      assertThat(dcel.origin(e)).as("seed %d", seed).isEqualTo(right);
      assertThat(dcel.target(e)).isEqualTo(left);
      dcel.flip(e);
      DcelValidator.validate(dcel);
      assertThat(dcel.origin(e)).isEqualTo(to);
      assertThat(dcel.target(e)).isEqualTo(from);
      dcel.flip(e);
      dcel.flip(e);
      DcelValidator.validate(dcel);
      assertThat(dcel.origin(e)).isEqualTo(from);
      assertThat(snapshot(dcel)).as("seed %d", seed).isEqualTo(before);
    }
  }

  @Test
  void removeVertexUndoesInsertVertex() {
    for (int seed = 0; seed < 300; seed++) {
      Random random = new Random(seed);
      Dcel dcel = triangulatedBeside(4 + random.nextInt(20), random);
      int v = dcel.vertexCount() - 1;
      int e = one(dcel, random, h -> dcel.canInsertVertex(h, v)).orElseThrow();
      int face = dcel.face(e);
      String before = snapshot(dcel);
      int x = dcel.insertVertex(e, v);
      DcelValidator.validate(dcel);
      assertThat(dcel.origin(x)).as("seed %d", seed).isEqualTo(v);
      assertThat(dcel.next(x)).isEqualTo(e);
      assertThat(dcel.face(e)).isEqualTo(face);
      assertThat(dcel.degree(v)).isEqualTo(3);
      assertThat(dcel.canRemoveVertex(x)).isTrue();
      assertThat(dcel.removeVertex(x)).isEqualTo(e);
      DcelValidator.validate(dcel);
      assertThat(dcel.face(e)).isEqualTo(face);
      assertThat(snapshot(dcel)).as("seed %d", seed).isEqualTo(before);
    }
  }

  @Test
  void insertVertexUndoesRemoveVertex() {
    for (int seed = 0; seed < 300; seed++) {
      Random random = new Random(seed);
      Dcel dcel = triangulatedBeside(4 + random.nextInt(20), random);
      int v = dcel.vertexCount() - 1;
      dcel.insertVertex(one(dcel, random, h -> dcel.canInsertVertex(h, v)).orElseThrow(), v);
      int x = one(dcel, random, dcel::canRemoveVertex).orElseThrow();
      int inner = dcel.origin(x);
      int edges = dcel.edgeBound();
      String before = snapshot(dcel);
      int e = dcel.removeVertex(x);
      DcelValidator.validate(dcel);
      assertThat(dcel.degree(inner)).isZero();
      int again = dcel.insertVertex(e, inner);
      DcelValidator.validate(dcel);
      assertThat(again >> 1).as("the number is used again, seed %d", seed).isEqualTo(x >> 1);
      assertThat(dcel.edgeBound()).isEqualTo(edges);
      assertThat(snapshot(dcel)).as("seed %d", seed).isEqualTo(before);
    }
  }

  @Test
  void joinEdgesUndoesSplitEdgeInsideAndOnTheBoundary() {
    for (int seed = 0; seed < 300; seed++) {
      Random random = new Random(seed);
      Dcel dcel = triangulatedBeside(4 + random.nextInt(20), random);
      int v = dcel.vertexCount() - 1;
      int e = one(dcel, random, h -> true).orElseThrow();
      int from = dcel.origin(e);
      int to = dcel.target(e);
      String before = snapshot(dcel);
      int d = dcel.splitEdge(e, v);
      DcelValidator.validate(dcel);
      assertThat(new int[] {dcel.origin(e), dcel.target(e), dcel.origin(d), dcel.target(d)})
          .as("seed %d", seed)
          .containsExactly(from, v, v, to);
      assertThat(dcel.canJoinEdges(d)).isTrue();
      assertThat(dcel.joinEdges(d)).isEqualTo(e);
      DcelValidator.validate(dcel);
      assertThat(snapshot(dcel)).as("seed %d", seed).isEqualTo(before);
      assertThat(dcel.splitEdge(e, v) >> 1).as("used again").isEqualTo(d >> 1);
    }
  }

  /** A path, as of sites on one line, has ends with a single edge. */
  @Test
  void theEndOfAPathCanBeSplitAndJoined() {
    for (int e = 0; e < 4; e++) {
      int[] next = {2, 0, 3, 1};
      Dcel path = Dcel.of(4, HalfEdges.of(next, new int[] {0, 1, 1, 2}), 0, Progress.NONE);
      String before = snapshot(path);
      int d = path.splitEdge(e, 3);
      DcelValidator.validate(path);
      assertThat(path.degree(3)).isEqualTo(2);
      assertThat(path.joinEdges(d)).isEqualTo(e);
      DcelValidator.validate(path);
      assertThat(snapshot(path)).isEqualTo(before);
    }
  }

  @Test
  void longRandomSequencesUndoneBackwardsRestoreTheBeginning() {
    for (int seed = 0; seed < 100; seed++) {
      Random random = new Random(seed);
      Dcel dcel = triangulatedBeside(4 + random.nextInt(12), random, 20);
      String before = snapshot(dcel);
      Deque<Runnable> undo = new ArrayDeque<>();
      for (int step = 0; step < 80; step++) {
        undoable(dcel, random).ifPresent(undo::push);
        DcelValidator.validate(dcel);
      }
      assertThat(undo).as("seed %d", seed).hasSizeGreaterThan(20);
      while (!undo.isEmpty()) {
        undo.pop().run();
        DcelValidator.validate(dcel);
      }
      assertThat(snapshot(dcel)).as("seed %d", seed).isEqualTo(before);
    }
  }

  /** Does something and returns what undoes it. */
  private static Optional<Runnable> undoable(Dcel dcel, Random random) {
    int e = one(dcel, random, h -> true).orElseThrow();
    int v = isolated(dcel);
    switch (random.nextInt(4)) {
      case 0 -> {
        if (dcel.canInsertVertex(e, v)) {
          int x = dcel.insertVertex(e, v);
          return Optional.of(() -> dcel.removeVertex(x));
        }
      }
      case 1 -> {
        if (dcel.canFlip(e)) {
          dcel.flip(e);
          return Optional.of(() -> IntStream.range(0, 3).forEach(k -> dcel.flip(e)));
        }
      }
      case 2 -> {
        if (dcel.canSplitEdge(e, v)) {
          int d = dcel.splitEdge(e, v);
          return Optional.of(() -> dcel.joinEdges(d));
        }
      }
      default -> {
        int b = dcel.next(dcel.next(e));
        if (dcel.canSplit(e, b)) {
          int d = dcel.splitFace(e, b);
          return Optional.of(() -> dcel.joinFaces(d));
        }
      }
    }
    return Optional.empty();
  }

  /** A vertex without an edge, or any if there is none. */
  private static int isolated(Dcel dcel) {
    int last = dcel.vertexCount() - 1;
    return IntStream.rangeClosed(0, last).filter(v -> dcel.degree(v) == 0).findFirst().orElse(last);
  }

  @Test
  void longRandomSequencesKeepEveryLaw() {
    for (int seed = 0; seed < 60; seed++) {
      Random random = new Random(seed);
      Dcel dcel = Dcel.cycle(walk(3 + random.nextInt(30)));
      for (int step = 0; step < 300; step++) {
        change(dcel, random);
        DcelValidator.validate(dcel);
      }
    }
  }

  @Test
  void rotateGoesOnceRoundAVertex() {
    Dcel dcel = triangulated(30, new Random(1));
    for (int e : handles(dcel)) {
      assertThat(dcel.origin(dcel.rotate(e))).isEqualTo(dcel.origin(e));
      assertThat(dcel.next(dcel.rotate(e) ^ 1)).isEqualTo(e);
      assertThat(dcel.rotate(dcel.next(e ^ 1))).isEqualTo(e);
    }
  }

  @Test
  void guardsRefuseWhatCannotBeDone() {
    Dcel square = Dcel.cycle(0, 1, 2, 3);
    assertThat(square.canSplit(0, 4)).isTrue();
    assertThat(square.canSplit(0, 0)).as("itself").isFalse();
    assertThat(square.canSplit(0, 2)).as("a neighbour").isFalse();
    assertThat(square.canSplit(2, 0)).as("a neighbour").isFalse();
    assertThat(square.canSplit(0, 5)).as("two faces").isFalse();
    assertThat(square.canSplit(1, 5)).as("the outer face").isFalse();
    assertThat(square.canJoin(0)).as("a boundary edge").isFalse();
    assertThat(square.canFlip(0)).as("a boundary edge").isFalse();
    int d = square.splitFace(0, 4);
    assertThat(square.canFlip(d)).isTrue();
    assertThat(square.canFlip(0)).isFalse();
    assertThat(square.isTriangle(d)).isTrue();
  }

  @Test
  void guardsOfVerticesRefuseWhatCannotBeDone() {
    Dcel dcel = triangulatedBeside(4, new Random(1));
    int inner = one(dcel, new Random(1), h -> dcel.canFlip(h)).orElseThrow();
    int outer = one(dcel, new Random(1), h -> dcel.face(h) == Dcel.OUTER).orElseThrow();
    assertThat(dcel.canInsertVertex(inner, 4)).isTrue();
    assertThat(dcel.canInsertVertex(inner, 0)).as("has edges already").isFalse();
    assertThat(dcel.canInsertVertex(outer, 4)).as("the outer face").isFalse();
    assertThat(dcel.canRemoveVertex(inner)).as("on the boundary").isFalse();
    assertThat(dcel.canJoinEdges(inner)).as("three edges").isFalse();
    assertThat(dcel.canSplitEdge(inner, 0)).as("has edges already").isFalse();
    Dcel cycle = Dcel.cycle(walk(4));
    assertThat(cycle.canInsertVertex(0, 0)).as("no triangle").isFalse();
    assertThat(cycle.canJoinEdges(0)).isTrue();
    cycle.joinEdges(0);
    DcelValidator.validate(cycle);
    int[] digon = {2, 3, 0, 1};
    Dcel twoEdges = Dcel.of(2, HalfEdges.of(digon, new int[] {0, 1, 1, 0}), 1, Progress.NONE);
    assertThat(twoEdges.canJoinEdges(0)).as("both edges to one vertex").isFalse();
  }

  @Test
  void aFlipNeedsTwoTriangles() {
    Dcel pentagon = Dcel.cycle(0, 1, 2, 3, 4);
    int d = pentagon.splitFace(0, 4);
    assertThat(pentagon.canFlip(d)).isFalse();
    assertThat(pentagon.canFlip(d ^ 1)).isFalse();
  }

  @Test
  void aFrozenSubdivisionRefusesEveryOperatorAndItsCopyDoesNot() {
    Dcel dcel = Dcel.cycle(walk(6));
    int d = dcel.splitFace(0, 4);
    dcel.splitFace(4, 8);
    String before = snapshot(dcel.freeze());
    assertThatThrownBy(() -> dcel.splitFace(4, 10)).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> dcel.joinFaces(d)).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> dcel.flip(d)).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> dcel.insertVertex(d, 6)).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> dcel.removeVertex(d)).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> dcel.splitEdge(d, 6)).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(() -> dcel.joinEdges(0)).isInstanceOf(IllegalStateException.class);
    assertThat(snapshot(dcel)).isEqualTo(before);
    Dcel copy = dcel.copy();
    copy.joinFaces(d);
    DcelValidator.validate(copy);
    assertThat(snapshot(dcel)).isEqualTo(before);
    DcelValidator.validate(dcel);
  }

  @Test
  void ofGivesTheNumbersOfRemovedEdgesToTheLastOnes() {
    Dcel dcel = triangulated(12, new Random(5)); // edges 0 … 20
    Dcel joined = dcel.copy();
    for (int edge : new int[] {14, 17, 20}) {
      joined.joinFaces(2 * edge);
    }
    Dcel closed = rebuilt(joined);
    DcelValidator.validate(closed);
    assertThat(closed.edgeBound()).isEqualTo(18);
    for (int edge = 0; edge < 18; edge++) {
      int before = edge == 14 ? 19 : edge == 17 ? 18 : edge;
      assertThat(closed.origin(2 * edge)).isEqualTo(dcel.origin(2 * before));
      assertThat(closed.target(2 * edge)).isEqualTo(dcel.target(2 * before));
    }
  }

  private static Dcel rebuilt(Dcel dcel) {
    return Dcel.of(dcel.vertexCount(), dcel.links(), dcel.faceEdge(Dcel.OUTER), Progress.NONE);
  }

  @Test
  void ofRebuildsASubdivisionAndLeavesRemovedEdgesOut() {
    for (int seed = 0; seed < 300; seed++) {
      Dcel dcel = randomSubdivision(new Random(seed));
      Dcel same = rebuilt(dcel);
      DcelValidator.validate(same);
      assertThat(snapshot(same)).as("seed %d", seed).isEqualTo(snapshot(dcel));
    }
  }

  @Test
  void ofKeepsIsolatedVertices() {
    int[] next = {2, 0, 3, 1};
    Dcel path = Dcel.of(4, HalfEdges.of(next, new int[] {0, 1, 1, 2}), 0, Progress.NONE);
    DcelValidator.validate(path);
    assertThat(path.degree(3)).isZero();
    assertThat(path.outEdge(3)).isEqualTo(Dcel.NONE);
    assertThat(path.faceCount()).isEqualTo(1);
    assertThat(path.isBoundary(0)).isTrue();
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 5})
  void ofKnowsTheEmptyPlane(int vertices) {
    Dcel empty = Dcel.of(vertices, new HalfEdges(0, 0), Dcel.NONE, Progress.NONE);
    DcelValidator.validate(empty);
    assertThat(empty.edgeCount()).isZero();
    assertThat(empty.faceCount()).isEqualTo(1);
    assertThat(empty.faceEdge(Dcel.OUTER)).isEqualTo(Dcel.NONE);
  }

  @Test
  void aLongFanStaysLinear() {
    int n = 200_000;
    Dcel dcel = Dcel.cycle(walk(n));
    int a = 0;
    for (int k = 2; k < n - 1; k++) {
      a = dcel.splitFace(a, 2 * k); // n − 3 ear cuts, quadratic if the long side were relabelled
    }
    DcelValidator.validate(dcel);
    assertThat(dcel.degree(0)).isEqualTo(n - 1);
  }

  private static int[] walk(int n) {
    int[] walk = new int[n];
    Arrays.setAll(walk, k -> k);
    return walk;
  }

  private static Dcel triangulated(int n, Random random) {
    Dcel dcel = Dcel.cycle(walk(n));
    for (int[] pair = splittable(dcel, random); pair != null; pair = splittable(dcel, random)) {
      dcel.splitFace(pair[0], pair[1]);
    }
    return dcel;
  }

  /** A triangulated n-gon and a vertex without an edge. */
  private static Dcel triangulatedBeside(int n, Random random) {
    return triangulatedBeside(n, random, 1);
  }

  private static Dcel triangulatedBeside(int n, Random random, int isolated) {
    Dcel polygon = triangulated(n, random);
    return Dcel.of(n + isolated, polygon.links(), polygon.faceEdge(Dcel.OUTER), Progress.NONE);
  }

  private static Optional<Integer> one(Dcel dcel, Random random, IntPredicate which) {
    List<Integer> all = handles(dcel).stream().filter(which::test).toList();
    return all.isEmpty() ? Optional.empty() : Optional.of(all.get(random.nextInt(all.size())));
  }

  private static Dcel randomSubdivision(Random random) {
    Dcel dcel = Dcel.cycle(walk(4 + random.nextInt(20)));
    for (int step = random.nextInt(60); step > 0; step--) {
      change(dcel, random);
    }
    return dcel;
  }

  /** One random operator, if its guard allows it. */
  private static void change(Dcel dcel, Random random) {
    List<Integer> handles = handles(dcel);
    int e = handles.get(random.nextInt(handles.size()));
    int f = handles.get(random.nextInt(handles.size()));
    switch (random.nextInt(4)) {
      case 0 -> {
        if (dcel.canJoin(e)) {
          dcel.joinFaces(e);
        }
      }
      case 1 -> {
        if (dcel.canFlip(e)) {
          dcel.flip(e);
        }
      }
      default -> {
        if (dcel.canSplit(e, f)) {
          dcel.splitFace(e, f);
        }
      }
    }
  }

  /** Two half-edges that a face can be split between, or null if all are triangles. */
  private static int[] splittable(Dcel dcel, Random random) {
    List<int[]> pairs = new ArrayList<>();
    List<Integer> handles = handles(dcel);
    for (int a : handles) {
      for (int b : handles) {
        if (dcel.canSplit(a, b)) {
          pairs.add(new int[] {a, b});
        }
      }
    }
    return pairs.isEmpty() ? null : pairs.get(random.nextInt(pairs.size()));
  }

  private static List<Integer> handles(Dcel dcel) {
    List<Integer> handles = new ArrayList<>();
    for (int e = 0; e < 2 * dcel.edgeBound(); e++) {
      if (dcel.hasEdge(e >> 1)) {
        handles.add(e);
      }
    }
    return handles;
  }

  /** The subdivision by its vertices: each face as its cycle from its least vertex, sorted. */
  private static String snapshot(Dcel dcel) {
    List<String> faces = new ArrayList<>();
    for (int e : handles(dcel)) {
      StringBuilder cycle = new StringBuilder(dcel.face(e) == Dcel.OUTER ? "outer" : "");
      int f = e;
      do {
        cycle.append(' ').append(dcel.origin(f));
        f = dcel.next(f);
      } while (f != e);
      faces.add(cycle.toString());
    }
    faces.sort(null);
    List<Integer> degrees = new ArrayList<>();
    for (int v = 0; v < dcel.vertexCount(); v++) {
      degrees.add(dcel.degree(v));
    }
    return faces + " " + degrees;
  }
}
