package dct.problem.verify;

import dct.core.degree.Flip;
import dct.core.degree.FlipResult;
import dct.core.degree.FlipWalk;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * The triangulation before a list of flips, from the one after them: the flips are taken back, the
 * last one first, and each has to be one. O(m), and what finding the edges takes.
 */
final class FlipListUndo {
  private final Triangulation after;
  private final ClaimedEdges edges;
  private final FlipWalk walk;

  /**
   * Takes the flips back.
   *
   * @param after a triangulation with the edges claimed, in their order
   * @throws FalseClaim if one of them cannot have been made, or the edges that the flips moved are
   *     not those of kind {@link EdgeKind#FLIPPED}
   */
  FlipListUndo(Triangulation after, ClaimedEdges edges, ClaimedFlips flips) {
    this.after = after;
    this.edges = edges;
    walk = new FlipWalk(after);
    for (int i = flips.size() - 1; i >= 0; i--) {
      Flip flip = flips.flip(i);
      int line = flips.line(i);
      Optional<String> cause = walk.flip(flip.inverse());
      cause.ifPresent(
          why -> {
            throw new FalseClaim(line, flip + " cannot have been a flip: " + why);
          });
    }
    Triangulation back = walk.triangulation();
    for (int edge = 0; edge < after.edgeCount(); edge++) {
      boolean moved = hasMoved(back, edge);
      boolean said = edges.kind(edge) == EdgeKind.FLIPPED;
      FalseClaim.unless(
          moved == said,
          edges.line(edge),
          "edge " + name(edge) + (moved ? " came from a flip" : " did not come from a flip"));
    }
  }

  private boolean hasMoved(Triangulation back, int edge) {
    int u = edges.from(edge);
    int v = edges.to(edge);
    boolean same = back.from(edge) == u && back.to(edge) == v;
    boolean reversed = back.from(edge) == v && back.to(edge) == u;
    return !same && !reversed;
  }

  private String name(int edge) {
    return "v" + edges.from(edge) + "–v" + edges.to(edge);
  }

  /** The number of flips. */
  int count() {
    return walk.flips();
  }

  /** The flips, and the triangulation before them; the kinds of edges that moved are not known. */
  FlipResult result() {
    Triangulation back = walk.triangulation();
    Triangulation before =
        new Triangulation(
            after.domain(),
            after.points(),
            back.dcel(),
            edge -> after.kind(edge) == EdgeKind.FLIPPED ? EdgeKind.DIAGONAL : after.kind(edge));
    List<Integer> inOrder = new ArrayList<>(walk.edges());
    Collections.reverse(inOrder);
    return new FlipResult(before, after, inOrder);
  }
}
