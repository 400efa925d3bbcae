package dct.core.geometry;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Takes a closed walk apart into loops that come to no place twice. */
final class Loops {
  private static final int ABSENT = -1;

  private final List<int[]> loops = new ArrayList<>();
  private final int[] depth; // by place: where it is on the way
  private int[] way = new int[16]; // the vertices since the last loop
  private int[] places = new int[16]; // theirs
  private int length;

  /** Walks between places 0 … count − 1. */
  Loops(int count) {
    depth = new int[count];
    Arrays.fill(depth, ABSENT);
  }

  /** Goes on to this vertex at this place. */
  void add(int vertex, int place) {
    if (depth[place] != ABSENT) {
      close(depth[place]);
    }
    if (length == way.length) {
      way = Arrays.copyOf(way, 2 * length);
      places = Arrays.copyOf(places, 2 * length);
    }
    depth[place] = length;
    way[length] = vertex;
    places[length++] = place;
  }

  private void close(int first) {
    loops.add(Arrays.copyOfRange(way, first, length));
    while (length > first) {
      depth[places[--length]] = ABSENT;
    }
  }

  /** All loops of the walk, which ends here; a new one may begin. */
  List<int[]> finished() {
    if (length > 0) {
      close(0);
    }
    List<int[]> all = List.copyOf(loops);
    loops.clear();
    return all;
  }
}
