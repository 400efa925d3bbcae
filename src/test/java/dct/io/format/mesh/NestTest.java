package dct.io.format.mesh;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** The innermost ring round a place, against the ring of the least area of those round it. */
class NestTest {
  private final List<Double> x = new ArrayList<>();
  private final List<Double> y = new ArrayList<>();
  private final List<int[]> rings = new ArrayList<>();
  private final Random random = new Random(11);

  private Points vertices() {
    return Points.of(
        x.stream().mapToDouble(d -> d).toArray(), y.stream().mapToDouble(d -> d).toArray());
  }

  /** A ring in a box, all of which is kept free for it, and rings inside it. */
  private void fill(double left, double low, double size, int depth) {
    int corners = 3 + random.nextInt(6);
    boolean back = random.nextBoolean();
    int first = x.size();
    double turn = random.nextDouble();
    for (int c = 0; c < corners; c++) {
      double angle = 2 * Math.PI * (turn + (double) (back ? -c : c) / corners);
      x.add(left + size / 2 * (1 + Math.cos(angle)));
      y.add(low + size / 2 * (1 + Math.sin(angle)));
    }
    List<Integer> ring = new ArrayList<>(IntStream.range(first, first + corners).boxed().toList());
    Collections.rotate(ring, random.nextInt(corners));
    rings.add(ring.stream().mapToInt(v -> v).toArray());
    double part = size / 8; // four boxes inside the circle of a triangle
    for (int box = 0; box < 4 && depth > 0; box++) {
      if (random.nextInt(4) > 0) {
        double from = size / 2 - part;
        fill(
            left + from + box % 2 * part,
            low + from + Math.floorDiv(box, 2) * part,
            part,
            depth - 1);
      }
    }
  }

  private boolean isInside(Points all, int[] ring, double px, double py) {
    boolean inside = false;
    for (int i = 0; i < ring.length; i++) {
      int u = ring[i];
      int v = ring[(i + 1) % ring.length];
      boolean spans = (all.y(v) > py) != (all.y(u) > py);
      double slope = (all.x(u) - all.x(v)) / (all.y(u) - all.y(v));
      inside ^= spans && px < all.x(v) + slope * (py - all.y(v));
    }
    return inside;
  }

  private int innermost(Points all, double px, double py) {
    int found = -1; // the rings stand in the order of their nesting
    for (int r = 0; r < rings.size(); r++) {
      found = isInside(all, rings.get(r), px, py) ? r : found;
    }
    return found;
  }

  @Test
  void the_innermost_ring_is_found() {
    fill(0, 0, 1, 4);
    fill(2, 0.1, 1, 4);
    fill(0.4, 3, 1, 4);
    Points all = vertices();
    int places = 3000;
    double[] px = new double[places];
    double[] py = new double[places];
    for (int i = 0; i < places; i++) { // near a vertex, so that small rings are met
      int v = random.nextInt(all.size());
      double reach = Math.pow(8, -random.nextInt(6));
      px[i] = all.x(v) + reach * (random.nextDouble() - 0.5);
      py[i] = all.y(v) + reach * (random.nextDouble() - 0.5);
    }
    int[] found = Nest.innermost(all, rings, Points.of(px, py));
    assertThat(IntStream.of(found).distinct().count()).isGreaterThan(100);
    for (int i = 0; i < places; i++) {
      assertThat(found[i]).as("place %d", i).isEqualTo(innermost(all, px[i], py[i]));
    }
  }

  @Test
  void rings_that_cross_are_no_trouble() {
    for (int round = 0; round < 300; round++) {
      rings.clear();
      x.clear();
      y.clear();
      for (int r = 0; r < 6; r++) {
        int first = x.size();
        int corners = 3 + random.nextInt(4);
        for (int c = 0; c < corners; c++) {
          x.add((double) random.nextInt(6));
          y.add((double) random.nextInt(6));
        }
        rings.add(IntStream.range(first, first + corners).toArray());
      }
      for (int found : Nest.innermost(vertices(), rings, vertices())) {
        assertThat(found).isBetween(-1, rings.size() - 1);
      }
    }
  }
}
