package dct.io.format.mesh;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.RegionShape;
import dct.io.format.Rim;
import dct.io.format.Rows;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Vertices of Shewchuk's Triangle ({@code .node}), and segments between them ({@code .poly}), which
 * are chained to rings. A ring in which a hole's point lies is a hole. Read as a region, {@link
 * Segments} tells which of them are rings. Attributes and markers are left out otherwise.
 */
public final class TriangleFormat implements Format {
  private static final Pattern COUNTS = Pattern.compile("[0-9]+\\s+2\\s+[0-9]+\\s+[01]");
  private static final int MARKER = 3; // the place of a segment's marker in its row
  private static final String CURE = "correct the segment";
  private static final String IN_NONE = " in no ring";

  @Override
  public String title() {
    return "Triangle";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.startsWith(head, COUNTS);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    rows.next(0, 1, "counts");
    NodeList nodes = NodeList.read(rows);
    List<String> notes = new ArrayList<>();
    if (nodes.hasMore()) {
      notes.add("Attributes and markers of the vertices are left out");
    }
    return shapes(rows, nodes, notes);
  }

  private Shapes shapes(Rows rows, NodeList nodes, List<String> notes) throws IOException {
    PointColumns points = nodes.points();
    Shape sites = Shape.of(Shape.Kind.SITES, "", points);
    if (!rows.next() || rows.count(0) == 0) {
      return new Shapes(title(), List.of(sites), notes);
    }
    Rim rim = new Rim(points.size());
    Segments all = segments(rows, nodes, rim);
    PointColumns holes = holes(rows);
    Chains chains = new Chains(rim);
    List<Shape> rings = chains.rings(points.points(), points.lines(), holes.points());
    int idle = chains.idleHoles();
    if (idle > 0) {
      notes.add((idle == 1 ? "1 point of a hole lies" : idle + " points of holes lie") + IN_NONE);
    }
    RegionShape region = all.region(points.points(), points.lines(), holes.points());
    Optional<Shapes.Fault> fault =
        region.rings().isEmpty() ? all.fault(points.lines()) : Optional.empty();
    Shapes.Whole whole = new Shapes.Whole(region, notes, fault);
    tell(chains, notes);
    return new Shapes(
        title(), rings.isEmpty() ? List.of(sites) : rings, notes, Optional.of(whole), false);
  }

  private static Segments segments(Rows rows, NodeList nodes, Rim rim) throws IOException {
    int segments = rows.count(0);
    Segments all = new Segments(nodes.points().size());
    for (int s = 0; s < segments; s++) {
      rows.next(s, segments, "segments");
      int u = nodes.vertex(rows, 1, CURE);
      int v = nodes.vertex(rows, 2, CURE);
      rim.add(u, v);
      all.add(u, v, rows.words().size() > MARKER && !rows.words().get(MARKER).equals("0"));
    }
    return all;
  }

  private static PointColumns holes(Rows rows) throws IOException {
    PointColumns holes = new PointColumns();
    int count = rows.next() ? rows.count(0) : 0;
    for (int h = 0; h < count; h++) {
      rows.next(h, count, "points of holes");
      holes.add(rows.number(1), rows.number(2), rows.line());
    }
    return holes;
  }

  /** Says what is left out if the rings are not read as a region. */
  private static void tell(Chains chains, List<String> notes) {
    int apart = chains.verticesApart();
    if (apart > 0) {
      notes.add(apart + (apart == 1 ? " vertex is" : " vertices are") + " on no ring, left out");
    }
    if (chains.looseSegments() > 0) {
      notes.add(chains.looseSegments() + " segments that are no part of a ring are left out");
    }
  }
}
