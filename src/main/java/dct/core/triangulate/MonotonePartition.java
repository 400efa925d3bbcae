package dct.core.triangulate;

import dct.core.Progress;
import dct.core.geometry.SimplePolygon;
import java.util.List;

/** To be written. */
public final class MonotonePartition {

  private MonotonePartition() {}

  public static Partition partition(SimplePolygon polygon, Progress progress) {
    return null;
  }

  public record Chord(int vertex, double x, double y) {}

  public static List<Chord> chords(SimplePolygon polygon) {
    return null;
  }
}
