package dct.core.degree.bound;

import dct.core.degree.LocalBound;
import dct.core.degree.colour.OddSites;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/**
 * Windows in upright boxes: each grows round a site until one site in it misses its wish, or sites
 * of other windows are in the way on all sides, and then shrinks as far as it still does.
 *
 * <p>Sites of one x are in the order of their y, and the other way round, as if the sides of the
 * box were tilted by a hair.
 */
final class BoxWindows {
  private static final double GROWTH = 1.4;
  private static final int FIRST = 2; // places on each side of the centre

  private final WindowProof proof;
  private final OddSites sites;
  private final int[][] place; // by x and by y: that of each site in the order
  private final BitSet taken = new BitSet();
  private final List<LocalBound> found = new ArrayList<>();

  private BoxWindows(WindowProof proof, OddSites sites, int[] byX, int[] byY) {
    this.proof = proof;
    this.sites = sites;
    place = new int[][] {inverse(byX), inverse(byY)};
  }

  private static int[] inverse(int[] order) {
    int[] inverse = new int[order.length];
    for (int i = 0; i < order.length; i++) {
      inverse[order[i]] = i;
    }
    return inverse;
  }

  /**
   * The windows found.
   *
   * @param byX the sites from left to right
   * @param byY the sites from the lowest on
   * @param centres the sites to grow round, the first ones first
   * @param enough stop at a sum of so many unmet sites
   */
  static List<LocalBound> find(
      WindowProof proof, OddSites sites, int[] byX, int[] byY, int[] centres, int enough) {
    BoxWindows boxes = new BoxWindows(proof, sites, byX, byY);
    for (int centre : centres) {
      if (LocalBound.sum(boxes.found) < enough && !proof.isSpent() && !boxes.taken.get(centre)) {
        boxes.tryAt(centre);
      }
    }
    return boxes.found;
  }

  /** Places from low to high by x, then by y. */
  private BitSet inside(int[] box) {
    BitSet inside = new BitSet();
    for (int v = 0; v < place[0].length; v++) {
      int i = place[0][v];
      int j = place[1][v];
      if (i >= box[0] && i <= box[1] && j >= box[2] && j <= box[3]) {
        inside.set(v);
      }
    }
    return inside;
  }

  private boolean isUnmet(int[] box) {
    return proof.holds(sites, new LocalBound(inside(box), 1));
  }

  private void tryAt(int centre) {
    int i = place[0][centre];
    int j = place[1][centre];
    int[] box = {i, i, j, j};
    double reach = FIRST;
    boolean grows = true;
    while (grows && !proof.isSpent()) {
      grows = grow(box, (int) reach);
      reach *= GROWTH;
      if (grows && isUnmet(box)) {
        shrink(box, new int[] {i, i, j, j});
        BitSet window = inside(box);
        taken.or(window);
        found.add(new LocalBound(window, 1));
        return;
      }
    }
  }

  /** Moves the sides out by so many places where nothing is taken; false if none moves. */
  private boolean grow(int[] box, int by) {
    boolean grows = false;
    for (int side = 0; side < box.length; side++) {
      int before = box[side];
      box[side] =
          side % 2 == 0 ? Math.max(0, before - by) : Math.min(place[0].length - 1, before + by);
      if (box[side] != before && inside(box).intersects(taken)) {
        box[side] = before;
      }
      grows |= box[side] != before;
    }
    return grows;
  }

  /** Moves each side in as far as the box still has an unmet site, and not beyond the centre. */
  private void shrink(int[] box, int[] centre) {
    for (int side = 0; side < box.length; side++) {
      int holds = box[side];
      int fails = centre[side];
      while (Math.abs(holds - fails) > 1) {
        box[side] = (holds + fails) / 2;
        if (isUnmet(box)) {
          holds = box[side];
        } else {
          fails = box[side];
        }
      }
      box[side] = holds;
    }
  }
}
