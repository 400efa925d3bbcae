package dct.io.format.drawing;

import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.io.format.PointColumns;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** Circles, ellipses and squares, which are marks of sites where all are small. */
final class SmallMarks {
  private static final double SMALL = 0.1; // of the longer side of the box of all centres

  private final PointColumns centres = new PointColumns();
  private final List<Supplier<String>> labels = new ArrayList<>();
  private double largest;

  /** What takes sites. */
  @FunctionalInterface
  interface Sites {
    void add(String label, double x, double y, int line);
  }

  void add(Supplier<String> label, double x, double y, double radius, int line) {
    centres.add(x, y, line);
    labels.add(label);
    largest = Math.max(largest, radius);
  }

  /** Whether there are two or more and each is small beside all together. */
  boolean areMarks() {
    Points points = centres.points();
    if (points.size() < 2) {
      return false;
    }
    Box box = Box.of(points);
    return largest <= SMALL * Math.max(box.maxX() - box.minX(), box.maxY() - box.minY());
  }

  /** Adds each centre as a site. */
  void addTo(Sites sites) {
    Points points = centres.points();
    int[] lines = centres.lines();
    for (int i = 0; i < points.size(); i++) {
      sites.add(labels.get(i).get(), points.x(i), points.y(i), lines[i]);
    }
  }
}
