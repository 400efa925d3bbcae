package dct.io.format.json;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.regex.Pattern;

/** GeoJSON, files of the challenge CG:SHOP, lists of vertices, and plain arrays of points. */
public final class JsonFormat implements Format {
  private static final Pattern ARRAY =
      Pattern.compile("\\[\\s*([-+.0-9{]|\\[\\s*([-+.0-9{\\[]|$))");
  private static final Pattern OBJECTS = Pattern.compile("\"points\"\\s*:\\s*(\\[\\s*)?\\{");

  private static final Pattern GEOJSON =
      Pattern.compile(
          "\"type\"\\s*:\\s*\"(Feature(Collection)?|GeometryCollection|(Multi)?(Point|LineString|"
              + "Polygon))\"");
  private static final Pattern CHALLENGE = Pattern.compile("(?i)\"type\"\\s*:\\s*\"[^\"]*CG_?SHOP");

  private static final Pattern VERTICES = Pattern.compile("\"vertices\"\\s*:\\s*\\[");

  @Override
  public String title() {
    return "JSON";
  }

  @Override
  public boolean fits(Head head) {
    boolean isOwn = head.hasField("points") && !OBJECTS.matcher(head.text()).find();
    return head.startsWith(ARRAY) || (!isOwn && isForeign(head));
  }

  private static boolean isForeign(Head head) {
    return (head.first() == '{' && GEOJSON.matcher(head.text()).find())
        || (head.first() == '{' && CHALLENGE.matcher(head.text()).find())
        || (head.first() == '{' && VERTICES.matcher(head.text()).find())
        || head.hasField("steiner_points_x")
        || head.hasField("starts")
        || (head.hasField("steps") && head.hasField("instance"))
        || head.hasField("instance_name")
        || head.hasField("coordinates")
        || head.hasField("features")
        || head.hasField("geometry")
        || head.hasField("geometries")
        || head.hasField("points_x")
        || head.hasField("outer_boundary")
        || head.hasField("content_type")
        || head.hasField("points");
  }

  @Override
  public Shapes read(Input input) throws IOException {
    return JsonGeometry.read(input);
  }
}
