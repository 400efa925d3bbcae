package dct.io.format;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.io.PointFile;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Random files of TSPLIB and CG:SHOP, read by us and by a second, simple reader. */
class SecondTextReaderTest {
  private static final int ROUNDS = Integer.getInteger("dct.fuzz", 300);

  private final Random random = new Random(31);

  private static Shapes read(String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return PointFile.shapes("in", new ByteArrayInputStream(bytes), Columns.TOLD_BY_CONTENT);
  }

  private String number() {
    double value = (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(9) - 2);
    return switch (random.nextInt(5)) {
      case 0 -> Integer.toString((int) value);
      case 1 -> String.format(Locale.ROOT, "%.6e", value);
      case 2 -> String.format(Locale.ROOT, "%.3f", value);
      case 3 ->
          String.format(Locale.ROOT, "%.5E", value).replace("E", random.nextBoolean() ? "E" : "e");
      default -> Double.toString(value);
    };
  }

  private String gap() {
    return new String[] {" ", "\t", "   "}[random.nextInt(3)];
  }

  private String tour() {
    int n = 1 + random.nextInt(30);
    List<String> head = new ArrayList<>();
    String colon = random.nextBoolean() ? " : " : ": ";
    head.add("NAME" + colon + "t" + n);
    head.add("TYPE" + colon + "TSP");
    head.add("COMMENT" + colon + "by (A. Nobody) 1:2");
    head.add("DIMENSION" + colon + n);
    head.add("EDGE_WEIGHT_TYPE" + colon + "EUC_2D");
    Collections.shuffle(head, random);
    StringBuilder text = new StringBuilder(String.join("\n", head));
    text.append("\nNODE_COORD_SECTION\n");
    for (int i = 1; i <= n; i++) {
      text.append(random.nextBoolean() ? gap() : "").append(i).append(gap()).append(number());
      text.append(gap()).append(number()).append(random.nextInt(5) == 0 ? " \r\n" : "\n");
    }
    return text.append(random.nextBoolean() ? "EOF\n" : "").toString();
  }

  @Test
  void tsplib_is_read_as_by_a_pattern() throws IOException {
    Pattern city = Pattern.compile("(?m)^\\s*\\d+[ \\t]+(\\S+)[ \\t]+(\\S+)\\s*$");
    for (int round = 0; round < ROUNDS; round++) {
      String text = tour();
      List<Double> pairs = new ArrayList<>();
      Matcher cities = city.matcher(text);
      while (cities.find()) {
        pairs.add(Double.valueOf(cities.group(1)));
        pairs.add(Double.valueOf(cities.group(2)));
      }
      Shapes shapes = read(text);
      assertThat(shapes.format()).isEqualTo("TSPLIB");
      assertThat(shapes.shapes().get(0).points()).as(text).isEqualTo(points(pairs));
    }
  }

  private static Points points(List<Double> pairs) {
    return Points.ofPairs(pairs.stream().mapToDouble(d -> d).toArray());
  }

  /** JSON as lists, maps, texts, numbers, truth values and null. */
  private static final class Json {
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?([eE][-+]?\\d+)?");
    private final String text;
    private int at;

    Json(String text) {
      this.text = text;
    }

    Object value() {
      space();
      char c = text.charAt(at);
      if (c == '{') {
        Map<String, Object> map = new LinkedHashMap<>();
        for (at++; more('}'); ) {
          String key = (String) value();
          space();
          at++; // the colon
          map.put(key, value());
        }
        return map;
      }
      if (c == '[') {
        List<Object> list = new ArrayList<>();
        for (at++; more(']'); ) {
          list.add(value());
        }
        return list;
      }
      if (c == '"') {
        int end = text.indexOf('"', at + 1);
        String word = text.substring(at + 1, end);
        at = end + 1;
        return word;
      }
      Matcher number = NUMBER.matcher(text).region(at, text.length());
      if (number.lookingAt()) {
        at = number.end();
        return Double.valueOf(number.group());
      }
      int end = at;
      while (Character.isLetter(text.charAt(end))) {
        end++;
      }
      String word = text.substring(at, end);
      at = end;
      return word;
    }

    /** Goes to the next member, or behind the end. */
    private boolean more(char end) {
      space();
      if (text.charAt(at) == ',') {
        at++;
        space();
      }
      if (text.charAt(at) == end) {
        at++;
        return false;
      }
      return true;
    }

    private void space() {
      while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
        at++;
      }
    }
  }

  private String list(int count, IntFunction<String> element) {
    List<String> words = IntStream.range(0, count).mapToObj(element).toList();
    return "[" + String.join(random.nextBoolean() ? ", " : ",\n ", words) + "]";
  }

  private String json(String... fields) {
    List<String> all = new ArrayList<>(List.of(fields));
    all.add("\"meta\": {\"points\": {\"a\": [1, null, true]}, \"e\": []}");
    all.add("\"other\": [[\"x\"], {\"y\": -1.5e3}, false]");
    Collections.shuffle(all, random);
    return "{" + String.join(random.nextBoolean() ? "," : ",\n  ", all) + "}\n";
  }

  @SuppressWarnings("unchecked")
  private static List<Double> numbers(Object json, String field) {
    return (List<Double>) ((Map<String, Object>) json).get(field);
  }

  private static Points columns(Object json, String x, String y) {
    List<Double> pairs = new ArrayList<>();
    for (int i = 0; i < numbers(json, x).size(); i++) {
      pairs.add(numbers(json, x).get(i));
      pairs.add(numbers(json, y).get(i));
    }
    return points(pairs);
  }

  @Test
  void cgshop_is_read_as_by_a_small_parser() throws IOException {
    for (int round = 0; round < ROUNDS; round++) {
      int n = 3 + random.nextInt(12);
      boolean old = random.nextBoolean();
      String x = old ? "x" : "points_x";
      String y = old ? "y" : "points_y";
      String text =
          json(
              old
                  ? "\"type\": \"Instance_CGSHOP2022\""
                  : "\"content_type\": \"CG_SHOP_2025_Instance\"",
              "\"" + x + "\": " + list(n, i -> number()),
              "\"" + y + "\": " + list(n, i -> number()),
              old ? "\"edge_i\": [0]" : "\"region_boundary\": [0, 2, 1]",
              old ? "\"edge_j\": [1]" : "\"num_constraints\": 0");
      Object parsed = new Json(text).value();
      Points all = columns(parsed, x, y);
      Shapes shapes = read(text);
      assertThat(shapes.format()).as(text).isEqualTo("CG:SHOP");
      Shape last = shapes.shapes().get(shapes.shapes().size() - 1);
      assertThat(last.points()).as(text).isEqualTo(all);
      if (!old) {
        int[] ring =
            numbers(parsed, "region_boundary").stream().mapToInt(Double::intValue).toArray();
        List<Double> pairs = new ArrayList<>();
        for (int v : ring) {
          pairs.add(all.x(v));
          pairs.add(all.y(v));
        }
        assertThat(shapes.shapes().get(0).points()).isEqualTo(points(pairs));
      }
    }
  }
}
