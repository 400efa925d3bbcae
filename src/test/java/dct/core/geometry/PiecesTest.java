package dct.core.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rings of a region that touch: the parts that hang together, or all a hair apart. */
class PiecesTest {
  /** Vertices, rings and fixed edges in the making. */
  private static final class Builder {
    final List<double[]> points = new ArrayList<>();
    final List<int[]> rings = new ArrayList<>();
    final List<Integer> fixed = new ArrayList<>();

    int point(double x, double y) {
      points.add(new double[] {x, y});
      return points.size() - 1;
    }

    Builder ring(double... pairs) {
      int first = points.size();
      for (int k = 0; k < pairs.length; k += 2) {
        point(pairs[k], pairs[k + 1]);
      }
      rings.add(IntStream.range(first, points.size()).toArray());
      return this;
    }

    Rings build() {
      Points all =
          Points.of(
              points.stream().mapToDouble(p -> p[0]).toArray(),
              points.stream().mapToDouble(p -> p[1]).toArray());
      return Rings.of(all, rings, fixed.stream().mapToInt(v -> v).toArray());
    }
  }

  private static Builder square() {
    return new Builder().ring(0, 0, 8, 0, 8, 8, 0, 8);
  }

  private static List<Piece> pieces(Rings rings) {
    return Touching.pieces(rings, Progress.NONE).orElseThrow();
  }

  private static boolean isRegion(Rings rings) {
    return SimplicityCheck.firstDefect(rings, Progress.NONE).isEmpty();
  }

  /** The area of the outer ring without those of the holes. */
  private static double area(Rings rings) {
    double area = 0;
    for (int r = 0; r < rings.count(); r++) {
      double ring = 0;
      for (int v : rings.ring(r)) {
        Points p = rings.points();
        int w = rings.after(v);
        ring += (p.x(v) * p.y(w) - p.x(w) * p.y(v)) / 2;
      }
      area += r == 0 ? Math.abs(ring) : -Math.abs(ring);
    }
    return area;
  }

  @Test
  void aHoleThatMeetsTheOuterRingAtOneVertexPinches() {
    Rings rings = square().ring(0, 0, 4, 2, 2, 4).build();
    assertThat(pieces(rings)).hasSize(1);
    assertThat(pieces(rings).get(0).isPinched()).isTrue();
    assertThat(pieces(rings).get(0).vertices()).containsExactly(0, 1, 2, 3, 4, 5, 6);
    Rings parted = Touching.parted(rings, Progress.NONE).orElseThrow();
    assertThat(isRegion(parted)).isTrue();
    assertThat(parted.count()).isEqualTo(2);
  }

  @Test
  void aHoleFromSideToSideSplits() {
    Rings rings = square().ring(0, 4, 4, 3, 8, 4, 4, 5).build();
    List<Piece> pieces = pieces(rings);
    assertThat(pieces).extracting(Piece::isPinched).containsExactly(false, false);
    assertThat(pieces.get(0).vertices()).containsExactly(0, 1, 4, 5, 6);
    assertThat(pieces.get(1).vertices()).containsExactly(2, 3, 4, 6, 7);
    assertThat(pieces).allMatch(piece -> isRegion(piece.toRings(rings.points())));
  }

  @Test
  void aHoleAlongAnEdgeBecomesANotch() {
    Rings rings = square().ring(2, 0, 4, 0, 4, 2, 2, 2).build();
    assertThat(pieces(rings)).hasSize(1);
    Rings joined = pieces(rings).get(0).toRings(rings.points());
    assertThat(isRegion(joined)).isTrue();
    assertThat(joined.count()).isEqualTo(1);
    assertThat(area(joined)).isEqualTo(60);
  }

  @Test
  void aChainOfHolesInARoundLeavesAPieceInside() {
    Rings rings =
        square().ring(2, 2, 4, 1, 6, 2, 4, 3).ring(6, 2, 7, 4, 6, 6).ring(6, 6, 1, 7, 2, 2).build();
    List<Piece> pieces = pieces(rings);
    assertThat(pieces).extracting(piece -> piece.rings().size()).containsExactly(2, 1);
    assertThat(pieces).noneMatch(Piece::isPinched);
  }

  @Test
  void whatIsNoRegionOrTouchesNothingHasNoPieces() {
    for (Builder builder :
        List.of(
            square(),
            square().ring(2, 2, 4, 2, 3, 4),
            square().ring(8, 8, 10, 8, 10, 10),
            square().ring(2, 2, 6, 2, 4, 6).ring(2, 2, 4, 3, 3, 4),
            square().ring(0, 0, 9, 4, 4, 4),
            square().ring(0, 0, 4, 2))) {
      assertThat(Touching.pieces(builder.build(), Progress.NONE)).isEmpty();
    }
    Builder site = square().ring(0, 0, 4, 2, 2, 4);
    site.point(4, 2);
    assertThat(Touching.pieces(site.build(), Progress.NONE)).isEmpty();
    assertThat(Touching.parted(site.build(), Progress.NONE)).isEmpty();
  }

  /** The outer ring turns in at (4, 8), round a triangle, and comes back there. */
  @Test
  void aFixedEdgeEndsAtTheVertexThatSeesItsOtherEnd() {
    Builder builder = new Builder().ring(0, 0, 8, 0, 8, 8, 4, 8, 6, 4, 2, 4, 4, 8, 0, 8);
    builder.fixed.addAll(List.of(3, builder.point(1, 6), 6, builder.point(7, 6), 3, 9));
    Rings parted = Touching.parted(builder.build(), Progress.NONE).orElseThrow();
    assertThat(isRegion(parted)).isTrue();
    assertThat(parted.fixed()).containsExactly(6, 8, 3, 9);
  }

  @Test
  void fixedEdgesGoWithTheirPieces() {
    Builder builder = new Builder().ring(0, 0, 8, 0, 4, 4, 8, 8, 0, 8, 4, 4);
    builder.fixed.addAll(List.of(2, builder.point(4, 1), 2, builder.point(4, 7)));
    List<Piece> pieces = pieces(builder.build());
    assertThat(pieces).hasSize(2);
    for (Piece piece : pieces) {
      assertThat(piece.fixed()).hasSize(2);
      assertThat(isRegion(piece.toRings(builder.build().points()))).isTrue();
    }
  }

  /** A hole thinner than a hair; that of a test of JTS. */
  @Test
  void aThinHoleIsParted() {
    double y = 0x1p-33;
    Rings rings = square().ring(0, 4, 3, 4, 3, 4 + y, y, 4 + y).build();
    Rings parted = Touching.parted(rings, Progress.NONE).orElseThrow();
    assertThat(isRegion(parted)).isTrue();
  }

  // ---- random ones, with cells to tell what hangs together

  /** A board of cells, some of which are holes; which of the others hang together by sides. */
  private static final class Board {
    final int width;
    final int height;
    final boolean[] isHole;
    final int[] group;

    Board(int width, int height, boolean[] isHole, int... group) {
      this.width = width;
      this.height = height;
      this.isHole = isHole;
      this.group = group;
    }

    static Board random(Random random) {
      int width = 2 + random.nextInt(5);
      int height = 2 + random.nextInt(5);
      boolean[] isHole = new boolean[width * height];
      double share = random.nextDouble();
      for (int c = 0; c < isHole.length; c++) {
        isHole[c] = random.nextDouble() < share;
      }
      int[] group = new int[isHole.length];
      Arrays.setAll(group, c -> c);
      for (int round = 0; round < group.length; round++) {
        for (int c = 0; c < group.length; c++) {
          join(group, isHole, c, c + 1, (c + 1) % width != 0);
          join(group, isHole, c, c + width, c + width < group.length);
        }
      }
      return new Board(width, height, isHole, group);
    }

    private static void join(int[] group, boolean[] isHole, int c, int d, boolean isBeside) {
      if (isBeside && !isHole[c] && !isHole[d]) {
        group[c] = group[d] = Math.min(group[c], group[d]);
      }
    }

    double x(int c) {
      return c % width;
    }

    double y(int c) {
      return (double) (c - c % width) / width;
    }

    Map<Integer, Integer> sizes(IntPredicate counts) {
      Map<Integer, Integer> sizes = new TreeMap<>();
      IntStream.range(0, group.length)
          .filter(c -> !isHole[c])
          .forEach(c -> sizes.merge(group[c], counts.test(c) ? 1 : 0, Integer::sum));
      return sizes;
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4})
  void piecesAreWhatHangsTogetherOfCells(int seed) {
    Random random = new Random(seed);
    int several = 0;
    int pinched = 0;
    for (int k = 0; k < 500; k++) {
      Board board = Board.random(random);
      boolean[] hasSite = new boolean[board.isHole.length];
      Rings rings = rings(board, hasSite, random);
      Optional<List<Piece>> found = Touching.pieces(rings, Progress.NONE);
      Map<Integer, Integer> sizes = board.sizes(c -> true);
      if (found.isEmpty()) {
        assertThat(isRegion(rings)).as("seed %d, board %d", seed, k).isNotEqualTo(sizes.isEmpty());
        continue;
      }
      Map<Integer, Integer> sites = board.sizes(c -> hasSite[c]);
      List<List<Integer>> expected =
          sizes.keySet().stream().map(g -> List.of(sizes.get(g), sites.get(g))).toList();
      List<List<Integer>> actual = new ArrayList<>();
      for (Piece piece : found.get()) {
        Rings part = piece.toRings(rings.points());
        assertThat(isRegion(part)).isNotEqualTo(piece.isPinched());
        int inner = part.points().size() - part.ringVertices();
        actual.add(List.of((int) area(part), inner));
        pinched += piece.isPinched() ? 1 : 0;
      }
      assertThat(actual).containsExactlyInAnyOrderElementsOf(expected);
      int fixed = found.get().stream().mapToInt(piece -> piece.fixed().length / 2).sum();
      assertThat(fixed).isEqualTo(rings.fixedCount());
      several += found.get().size() > 1 ? 1 : 0;
    }
    assertThat(several).isPositive();
    assertThat(pinched).isPositive();
  }

  /** The board with a ring round each hole, sites in cells, and edges between those beside. */
  private static Rings rings(Board board, boolean[] hasSite, Random random) {
    Builder builder = new Builder();
    double w = board.width;
    double h = board.height;
    builder.ring(0, 0, w, 0, w, h, 0, h);
    Map<Integer, Integer> sites = new HashMap<>();
    for (int c = 0; c < hasSite.length; c++) {
      double x = board.x(c);
      double y = board.y(c);
      if (board.isHole[c] && random.nextBoolean()) {
        builder.ring(x, y, x + 1, y, x + 1, y + 1, x, y + 1);
      } else if (board.isHole[c]) {
        builder.ring(x, y + 1, x + 1, y + 1, x + 1, y, x, y);
      } else if (random.nextBoolean()) {
        hasSite[c] = true;
        sites.put(c, builder.point(x + 0.5, y + 0.5));
        boolean isBeside = c % board.width > 0 && hasSite[c - 1];
        if (isBeside) {
          builder.fixed.addAll(List.of(sites.get(c - 1), sites.get(c)));
        }
      }
    }
    return builder.build();
  }

  /** Diamonds in cells, which meet those beside them and the outer ring at their tips. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4})
  void ringsThatMeetAtVerticesArePartedAndStayHoles(int seed) {
    Random random = new Random(seed);
    for (int k = 0; k < 200; k++) {
      Board board = Board.random(random);
      Builder builder = new Builder();
      double w = 2 * board.width;
      double h = 2 * board.height;
      builder.ring(0, 0, w, 0, w, h, 0, h);
      for (int c = 0; c < board.isHole.length; c++) {
        double x = 2 * board.x(c) + 1;
        double y = 2 * board.y(c) + 1;
        if (board.isHole[c]) {
          builder.ring(x, y - 1, x + 1, y, x, y + 1, x - 1, y);
        }
      }
      Rings rings = builder.build();
      Rings parted = Touching.parted(rings, Progress.NONE).orElseThrow();
      assertThat(isRegion(parted)).isTrue();
      assertThat(parted.count()).isEqualTo(rings.count());
      assertThat(area(parted)).isCloseTo(area(rings), within(1e-7));
      for (int v = 0; v < rings.points().size(); v++) {
        assertThat(parted.points().x(v)).isCloseTo(rings.points().x(v), within(1e-8));
        assertThat(parted.points().y(v)).isCloseTo(rings.points().y(v), within(1e-8));
      }
    }
  }
}
