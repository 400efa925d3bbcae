package dct.bench;

import dct.core.geometry.Points;
import java.util.HashMap;
import java.util.Map;

/** The numbers of different sites by their coordinates. */
final class SiteNumbers {
  private final Map<Place, Integer> number = new HashMap<>();

  private record Place(double x, double y) {}

  SiteNumbers(Points sites) {
    for (int i = 0; i < sites.size(); i++) {
      number.put(new Place(sites.x(i), sites.y(i)), i);
    }
  }

  int of(double x, double y) {
    return number.get(new Place(x, y));
  }
}
