package dct.io.format.lists;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.format.Rows;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Instances of the travelling salesman problem as TSPLIB holds them, in the plane. */
public final class TsplibFormat implements Format {
  private static final String NODES = "NODE_COORD_SECTION";
  private static final Pattern HEADER =
      Pattern.compile("(NAME|TYPE|COMMENT|DIMENSION|EDGE_WEIGHT_TYPE)\\s*:.*|" + NODES);
  private static final Pattern FIELD = Pattern.compile("([A-Z_]+) ?: ?(.*)");
  private static final Pattern SECTION = Pattern.compile("[A-Z_]+_SECTION ?:?");

  @Override
  public String title() {
    return "TSPLIB";
  }

  @Override
  public boolean fits(Head head) {
    return Rows.startsWith(head, HEADER);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    Rows rows = new Rows(input);
    PointColumns points = new PointColumns();
    List<String> notes = new ArrayList<>();
    String name = "";
    String section = "";
    int dimension = -1;
    while (rows.next() && !isEnd(rows)) {
      String line = String.join(" ", rows.words());
      Matcher field = FIELD.matcher(line);
      if (SECTION.matcher(line).matches()) {
        section = line.replaceAll("[ :]", "");
        if (!section.equals(NODES)) {
          notes.add("What stands in " + section + " is left out");
        }
      } else if (field.matches()) {
        switch (field.group(1)) {
          case "NAME" -> name = field.group(2);
          case "DIMENSION" -> dimension = dimension(rows, field.group(2));
          case "EDGE_WEIGHT_TYPE" -> noteIfOnSphere(field.group(2), notes);
          default -> section = "";
        }
      } else if (section.equals(NODES)) {
        rows.whole(0);
        points.add(rows.number(1), rows.number(2), rows.line());
      } else if (section.isEmpty()) {
        throw rows.fault("the line is no field and no section of TSPLIB; correct or remove it");
      }
    }
    check(rows, points.size(), dimension);
    return new Shapes(title(), List.of(Shape.of(Shape.Kind.SITES, name, points)), notes);
  }

  private static boolean isEnd(Rows rows) {
    return rows.words().equals(List.of("EOF"));
  }

  private static int dimension(Rows rows, String word) {
    int dimension = rows.whole(word);
    if (dimension < 1) {
      throw rows.fault("DIMENSION is " + dimension + "; correct it");
    }
    return dimension;
  }

  private static void noteIfOnSphere(String type, List<String> notes) {
    if (type.equals("GEO")) {
      notes.add(
          "Latitudes and longitudes in degrees and minutes are taken as x and y in the plane");
    }
  }

  private static void check(Rows rows, int size, int dimension) {
    if (size == 0) {
      throw rows.fault("there are no points in a " + NODES + "; the file holds distances only");
    }
    if (dimension >= 0 && size != dimension) {
      throw rows.fault(
          "DIMENSION is "
              + dimension
              + ", but there are "
              + size
              + " points; correct it, or fetch the file again if it was cut off");
    }
  }
}
