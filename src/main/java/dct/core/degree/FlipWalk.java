package dct.core.degree;

import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.triangulate.EdgeKind;
import dct.core.triangulate.Triangulation;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A triangulation that is changed by one flip after the other, and back.
 *
 * <p>Only the start is copied, in linear time. A flip of an edge, and taking it back, cost constant
 * time; a flip named by its corners costs as much as finding its edge ({@link
 * Triangulation#edgeBetween}). Not for use by several threads at once.
 */
public final class FlipWalk {
  private final Triangulation start;
  private final Dcel dcel;
  private final List<Integer> edges = new ArrayList<>(); // flipped and not taken back, in order
  private int odd;

  /** Begins at a triangulation, which stays as it is. */
  public FlipWalk(Triangulation start) {
    this.start = start;
    dcel = start.dcel().copy();
    odd = DegreeCount.of(start).odd();
  }

  /** The number of flips that were made and not taken back. */
  public int flips() {
    return edges.size();
  }

  /** The even and the odd vertices now. */
  public DegreeCount counts() {
    return new DegreeCount(start.vertexCount() - odd, odd);
  }

  /**
   * Flips an edge.
   *
   * @return what was flipped
   * @throws IllegalArgumentException if it cannot be flipped
   */
  public Flip flip(int edge) {
    requireFlippable(start.points(), dcel, edge);
    Flip flip = Flip.of(dcel, 2 * edge);
    turn(edge);
    edges.add(edge);
    return flip;
  }

  /**
   * Carries a flip out, or says why that is impossible here.
   *
   * @return empty if it was carried out, or else the cause, as a clause for a person: {@code there
   *     is no edge v0–v2}
   */
  public Optional<String> flip(Flip flip) {
    OptionalInt edge = edgeBetween(flip.u(), flip.v());
    if (edge.isPresent() && Flip.obstacle(start.points(), dcel, 2 * edge.getAsInt()).isEmpty()) {
      Flip possible = Flip.of(dcel, 2 * edge.getAsInt());
      if (!possible.isSameAs(flip)) {
        return Optional.of("the edge " + flip.removed() + " becomes " + possible.made());
      }
    }
    return flip(flip.u(), flip.v());
  }

  /**
   * Flips the edge between two vertices, or says why that is impossible here.
   *
   * @return empty if it was flipped, or else the cause, as a clause for a person
   */
  public Optional<String> flip(int u, int v) {
    String name = "v" + u + "–v" + v;
    OptionalInt edge = edgeBetween(u, v);
    if (edge.isEmpty()) {
      return Optional.of("there is no edge " + name);
    }
    Optional<Flip.Obstacle> obstacle = Flip.obstacle(start.points(), dcel, 2 * edge.getAsInt());
    if (obstacle.isEmpty()) {
      flip(edge.getAsInt());
    }
    return obstacle.map(o -> "the edge " + name + " " + o.clause());
  }

  private OptionalInt edgeBetween(int u, int v) {
    int n = start.vertexCount();
    boolean exist = Math.min(u, v) >= 0 && Math.max(u, v) < n;
    int e = exist ? dcel.halfEdge(u, v) : Dcel.NONE;
    return e == Dcel.NONE ? OptionalInt.empty() : OptionalInt.of(e >> 1);
  }

  /**
   * Takes the last flip back; every half-edge is then where it was before.
   *
   * @throws IndexOutOfBoundsException if there is none
   */
  public void undo() {
    int edge = edges.remove(edges.size() - 1);
    turn(edge);
    dcel.flip(2 * edge); // twice more, which turns the edge round
    dcel.flip(2 * edge);
  }

  private void turn(int edge) {
    dcel.flip(2 * edge);
    Flip back = Flip.of(dcel, 2 * edge);
    odd += change(back.u()) + change(back.v()) + change(back.x()) + change(back.y());
  }

  /** What a vertex whose parity has just changed adds to the odd ones. */
  private int change(int v) {
    return (dcel.degree(v) & 1) == 1 ? 1 : -1;
  }

  /** The triangulation that it began at. */
  public Triangulation start() {
    return start;
  }

  /** The edges that were flipped and not taken back, in order. */
  public List<Integer> edges() {
    return List.copyOf(edges);
  }

  /**
   * The triangulation now, in linear time. Edges keep their numbers; those that do not join the
   * vertices that they joined at the start are of kind {@link EdgeKind#FLIPPED}.
   */
  public Triangulation triangulation() {
    return edges.isEmpty() ? start : after(start, dcel.copy());
  }

  /**
   * A triangulation after one flip.
   *
   * @throws IllegalArgumentException if the edge cannot be flipped
   */
  static Triangulation flipped(Triangulation before, int edge) {
    requireFlippable(before.points(), before.dcel(), edge);
    Dcel dcel = before.dcel().copy();
    dcel.flip(2 * edge);
    return after(before, dcel);
  }

  private static void requireFlippable(Points points, Dcel dcel, int edge) {
    Optional<Flip.Obstacle> obstacle = Flip.obstacle(points, dcel, 2 * edge);
    if (obstacle.isPresent()) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "edge v%d–v%d %s",
              dcel.origin(2 * edge),
              dcel.target(2 * edge),
              obstacle.get().clause()));
    }
  }

  /** The triangulation with this topology; edges that are not where they were are flipped ones. */
  static Triangulation after(Triangulation before, Dcel dcel) {
    return new Triangulation(
        before.domain(),
        before.points(),
        dcel,
        edge -> hasMoved(before.dcel(), dcel, 2 * edge) ? EdgeKind.FLIPPED : before.kind(edge));
  }

  private static boolean hasMoved(Dcel before, Dcel after, int e) {
    int u = before.origin(e);
    int v = before.target(e);
    return !(after.origin(e) == u && after.target(e) == v)
        && !(after.origin(e) == v && after.target(e) == u);
  }
}
