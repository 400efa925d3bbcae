package dct.io;

import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import com.google.gson.stream.MalformedJsonException;
import dct.core.Decimals;
import dct.core.degree.Flip;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.io.format.PointColumns;
import dct.io.text.BadInputException;
import dct.io.text.JsonSource;
import dct.io.text.Shown;
import dct.problem.verify.ClaimedEdges;
import dct.problem.verify.ClaimedFlips;
import dct.problem.verify.ClaimedWindow;
import dct.problem.verify.Claims;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.CharacterCodingException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Reads the program's own JSON: a whole result, or just {@code {"kind": …, "points": [[x, y], …]}},
 * of a region with {@code "rings"} and {@code "fixed"}.
 *
 * <p>Fields that the program does not know are skipped. Linear.
 */
final class JsonText {
  private static final String FORM = "write \"points\": [[x, y], …]";
  private static final String POINT_WRONG = "a point is not a pair of numbers%s; " + FORM;
  private static final String EDGE_FORM =
      "write [u, v, \"boundary\"], or \"diagonal\", \"partition\", \"flipped\","
          + " \"fixed\" as the third";
  private static final String EDGE_WRONG = "an edge is not of the known form%s; " + EDGE_FORM;
  private static final String FLIP_FORM = "write [u, v, x, y] where the edge u v became x y";
  private static final String FLIP_WRONG = "a flip is not four vertex numbers%s; " + FLIP_FORM;

  private static final String PAIR_WRONG = "it is not a list of pairs%s; write [[u, v], …]";
  private static final String RINGS_WRONG =
      "\"rings\" is not a list of lists of vertices%s; write [[u, v, w, …], …], the outer ring first";
  private static final String SIZES_WRONG =
      "\"ringSizes\" is not a list of whole numbers%s; write [h0, h1, …]";
  private static final String WINDOW_FORM =
      "write {\"windows\": [{\"unmet\": 1, \"sites\": [0, 1, …]}, …]}";
  private static final String CERTIFICATE_WRONG =
      "the certificate is not of the known form%s; " + WINDOW_FORM;

  private static final String FOLLOWED = "something follows the JSON object; remove it";

  private final String name;
  private final JsonSource source;
  private final JsonReader json;
  private final Map<String, Object> values = new HashMap<>();
  private final Map<String, int[]> lines = new HashMap<>(); // of the rings, and of pairs
  private PointColumns points;
  private ClaimedEdges edges;
  private ClaimedFlips flips;
  private final List<ClaimedWindow> windows = new ArrayList<>();
  private boolean ended; // the object is closed

  private JsonText(String name, InputStream in) {
    this.name = name;
    this.source = new JsonSource(name, in);
    this.json = source.json();
  }

  /**
   * Reads everything.
   *
   * @throws BadInputException at the first place that is wrong
   */
  static Claims read(String name, InputStream in) throws IOException {
    JsonText text = new JsonText(name, in);
    try {
      return text.result();
    } catch (EOFException e) {
      throw text.fault("the JSON text ends too early; restore the rest of the file");
    } catch (MalformedJsonException e) {
      throw text.fault(
          text.ended ? FOLLOWED : "this is not JSON" + text.source.place() + "; correct it");
    } catch (CharacterCodingException e) {
      throw text.fault("the text is not UTF-8; save it as UTF-8");
    }
  }

  private Claims result() throws IOException {
    require(JsonToken.BEGIN_OBJECT, "this is not a JSON object; " + FORM + " inside { }");
    json.beginObject();
    while (json.hasNext()) {
      field(json.nextName());
    }
    json.endObject();
    ended = true;
    require(JsonToken.END_DOCUMENT, FOLLOWED);
    if (!values.getOrDefault("format", ResultJson.FORMAT).equals(ResultJson.FORMAT)) {
      throw fault(
          "the format is "
              + Shown.word(values.get("format").toString())
              + " and not "
              + ResultJson.FORMAT
              + "; read it with the version of the program that wrote it");
    }
    if (points == null) {
      throw fault("there is no field \"points\"; " + FORM);
    }
    return new Claims(
            name, Map.copyOf(values), points.points(), points.lines(), edges, flips, windows)
        .at(lines);
  }

  private void field(String field) throws IOException {
    if (values.containsKey(field)
        || (field.equals("points") && points != null)
        || (field.equals("edgeList") && edges != null)
        || (field.equals("flipList") && flips != null)) {
      throw fault("the field \"" + field + "\" is there twice; remove one");
    }
    switch (field) {
      case "points" -> readPoints();
      case "edgeList" -> readEdges();
      case "flipList" -> readFlips();
      case "certificate" -> readCertificate();
      case "kind" -> readKind();
      case ResultJson.GIVEN_EDGES, "fixed" -> values.put(field, pairs(field));
      case "rings" -> values.put(field, rings());
      case "ringSizes" -> values.put(field, numbers(SIZES_WRONG));
      default -> readValue(field);
    }
  }

  private void readKind() throws IOException {
    String cure = "write \"kind\": \"polygon\", \"points\" or \"region\"";
    require(JsonToken.STRING, "\"kind\" is not a text; " + cure);
    String kind = json.nextString();
    if (Domain.parse(kind).isEmpty()) {
      throw fault("\"" + Shown.word(kind) + "\" is not a kind of input; " + cure);
    }
    values.put("kind", kind);
  }

  private void readValue(String field) throws IOException {
    switch (json.peek()) {
      case STRING -> values.put(field, json.nextString());
      case NUMBER -> values.put(field, number());
      case BOOLEAN -> values.put(field, json.nextBoolean());
      default -> {
        values.put(field, json.peek()); // so that it is known to have been there
        json.skipValue();
      }
    }
  }

  private double number() throws IOException {
    String text = json.nextString();
    double value = Decimals.parse(text);
    if (!Double.isFinite(value)) {
      throw fault(
          Shown.word(text) + " is too large, a number is at most 1.797e308; scale the data");
    }
    return value;
  }

  private void readPoints() throws IOException {
    points = new PointColumns();
    require(JsonToken.BEGIN_ARRAY, "\"points\" is not a list; " + FORM);
    json.beginArray();
    while (json.hasNext()) {
      require(JsonToken.BEGIN_ARRAY, POINT_WRONG);
      json.beginArray();
      int line = source.line();
      require(JsonToken.NUMBER, POINT_WRONG);
      double x = number();
      require(JsonToken.NUMBER, POINT_WRONG);
      points.add(x, number(), line);
      require(JsonToken.END_ARRAY, POINT_WRONG);
      json.endArray();
    }
    json.endArray();
  }

  private void readEdges() throws IOException {
    edges = new ClaimedEdges();
    require(JsonToken.BEGIN_ARRAY, "\"edgeList\" is not a list; " + EDGE_FORM);
    json.beginArray();
    while (json.hasNext()) {
      require(JsonToken.BEGIN_ARRAY, EDGE_WRONG);
      json.beginArray();
      int line = source.line();
      int u = vertex(EDGE_WRONG);
      int v = vertex(EDGE_WRONG);
      require(JsonToken.STRING, EDGE_WRONG);
      edges.add(u, v, edgeKind(json.nextString()), line);
      require(JsonToken.END_ARRAY, EDGE_WRONG);
      json.endArray();
    }
    json.endArray();
  }

  private void readFlips() throws IOException {
    flips = new ClaimedFlips();
    require(JsonToken.BEGIN_ARRAY, "\"flipList\" is not a list; " + FLIP_FORM);
    json.beginArray();
    while (json.hasNext()) {
      require(JsonToken.BEGIN_ARRAY, FLIP_WRONG);
      json.beginArray();
      int line = source.line();
      int u = vertex(FLIP_WRONG);
      int v = vertex(FLIP_WRONG);
      int x = vertex(FLIP_WRONG);
      flips.add(new Flip(u, v, x, vertex(FLIP_WRONG)), line);
      require(JsonToken.END_ARRAY, FLIP_WRONG);
      json.endArray();
    }
    json.endArray();
  }

  private int[] pairs(String field) throws IOException {
    String wrong = PAIR_WRONG.replace("it ", "\"" + field + "\" ");
    IntStream.Builder ends = IntStream.builder();
    IntStream.Builder at = IntStream.builder();
    require(JsonToken.BEGIN_ARRAY, wrong);
    json.beginArray();
    while (json.hasNext()) {
      require(JsonToken.BEGIN_ARRAY, wrong);
      json.beginArray();
      at.add(source.line());
      ends.add(vertex(wrong)).add(vertex(wrong));
      require(JsonToken.END_ARRAY, wrong);
      json.endArray();
    }
    json.endArray();
    lines.put(field, at.build().toArray());
    return ends.build().toArray();
  }

  private List<int[]> rings() throws IOException {
    List<int[]> rings = new ArrayList<>();
    IntStream.Builder at = IntStream.builder();
    require(JsonToken.BEGIN_ARRAY, RINGS_WRONG);
    json.beginArray();
    while (json.hasNext()) {
      rings.add(numbers(RINGS_WRONG));
      at.add(source.line());
    }
    json.endArray();
    lines.put("rings", at.build().toArray());
    return rings;
  }

  private int[] numbers(String wrong) throws IOException {
    IntStream.Builder numbers = IntStream.builder();
    require(JsonToken.BEGIN_ARRAY, wrong);
    json.beginArray();
    while (json.hasNext()) {
      numbers.add(vertex(wrong));
    }
    json.endArray();
    return numbers.build().toArray();
  }

  private void readCertificate() throws IOException {
    values.put("certificate", JsonToken.BEGIN_OBJECT); // so that it is known to have been there
    require(JsonToken.BEGIN_OBJECT, CERTIFICATE_WRONG);
    json.beginObject();
    while (json.hasNext()) {
      if (json.nextName().equals("windows")) {
        require(JsonToken.BEGIN_ARRAY, CERTIFICATE_WRONG);
        json.beginArray();
        while (json.hasNext()) {
          readWindow();
        }
        json.endArray();
      } else {
        json.skipValue();
      }
    }
    json.endObject();
  }

  private void readWindow() throws IOException {
    int unmet = 0;
    List<Integer> sites = new ArrayList<>();
    require(JsonToken.BEGIN_OBJECT, CERTIFICATE_WRONG);
    json.beginObject();
    while (json.hasNext()) {
      switch (json.nextName()) {
        case "unmet" -> unmet = vertex(CERTIFICATE_WRONG);
        case "sites" -> {
          require(JsonToken.BEGIN_ARRAY, CERTIFICATE_WRONG);
          json.beginArray();
          while (json.hasNext()) {
            sites.add(vertex(CERTIFICATE_WRONG));
          }
          json.endArray();
        }
        default -> json.skipValue();
      }
    }
    json.endObject();
    windows.add(new ClaimedWindow(unmet, sites));
  }

  private int vertex(String wrong) throws IOException {
    require(JsonToken.NUMBER, wrong);
    String here = wrong.replace("%s", source.place());
    double value = number();
    if (value != (int) value) {
      throw fault(here);
    }
    return (int) value;
  }

  private EdgeKind edgeKind(String word) {
    return EdgeKind.parse(word).orElseThrow(() -> fault(EDGE_WRONG));
  }

  private void require(JsonToken token, String wrong) throws IOException {
    if (json.peek() != token) {
      throw fault(wrong);
    }
  }

  private BadInputException fault(String fault) {
    return source.fault(fault.replace("%s", source.place()));
  }
}
