package dct.io.format.json;

import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import com.google.gson.stream.MalformedJsonException;
import dct.io.format.Input;
import dct.io.format.PointColumns;
import dct.io.text.BadInputException;
import dct.io.text.JsonSource;
import dct.io.text.Shown;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.util.Arrays;
import java.util.Optional;

/** A stream of JSON, and the pieces of it that geometries are made of. */
final class JsonScanner {
  private static final int DEEPEST = 100;
  private static final String PAIR = "write a point as [x, y]";

  private final String name;
  private final JsonSource source;
  private int rounded; // fractions that no double equals
  JsonReader json;

  JsonScanner(Input input) {
    name = input.name();
    source = new JsonSource(input.name(), input.in());
    json = source.json();
    json.setNestingLimit(DEEPEST);
  }

  /** What reads a whole text. */
  @FunctionalInterface
  interface Body {
    void read() throws IOException;
  }

  /**
   * Reads a whole text, also of several objects on lines of their own; whatever is wrong with its
   * form becomes one sentence.
   */
  void whole(Body body) throws IOException {
    try {
      boolean isObject = json.peek() == JsonToken.BEGIN_OBJECT;
      do {
        body.read();
      } while (goOn(isObject));
    } catch (EOFException e) {
      throw fault("the JSON text ends too early; restore the rest of the file");
    } catch (MalformedJsonException | IllegalStateException e) {
      String deep = String.valueOf(e.getMessage()).startsWith("Nesting limit") ? ", too deep" : "";
      throw fault("this is not JSON as expected" + deep + source.place() + "; correct it");
    } catch (CharacterCodingException e) {
      throw fault("the text is not UTF-8; save it as UTF-8");
    }
  }

  /** Whether another object follows on the next line. */
  private boolean goOn(boolean isObject) throws IOException {
    source.endAtLine();
    boolean isLine = json.peek() == JsonToken.END_DOCUMENT;
    int first = source.goOn();
    json = source.json();
    json.setNestingLimit(DEEPEST);
    if (!isLine || (first >= 0 && !(isObject && first == '{'))) {
      throw fault("something follows the JSON text; remove it");
    }
    return first >= 0;
  }

  BadInputException fault(int line, String fault) {
    return new BadInputException(name, line, fault);
  }

  BadInputException fault(String fault) {
    return source.fault(fault);
  }

  /** How many fractions were read of which no double is the value. */
  int rounded() {
    return rounded;
  }

  /**
   * A finite number, written plainly, in quotation marks, or as a fraction: {@code "1/3"} or {@code
   * {"num": 1, "den": 3}}.
   */
  double number() throws IOException {
    if (json.peek() == JsonToken.BEGIN_OBJECT) {
      return fraction();
    }
    String text = json.nextString();
    return finite(Fraction.of(text), text);
  }

  private double fraction() throws IOException {
    String above = "";
    String below = "1";
    json.beginObject();
    while (json.hasNext()) {
      switch (json.nextName()) {
        case "num" -> above = json.nextString();
        case "den" -> below = json.nextString();
        default -> json.skipValue();
      }
    }
    json.endObject();
    return finite(Fraction.of(above, below), above + "/" + below);
  }

  private double finite(Fraction fraction, String text) {
    if (!Double.isFinite(fraction.value())) {
      throw fault(
          "\"" + Shown.word(text) + "\" is no finite number" + source.place() + "; correct it");
    }
    rounded += fraction.isExact() ? 0 : 1;
    return fraction.value();
  }

  /** A list of numbers. */
  double[] numbers() throws IOException {
    json.beginArray();
    return rest();
  }

  /** The rest of a list of numbers. */
  private double[] rest() throws IOException {
    double[] numbers = new double[16];
    int size = 0;
    while (json.hasNext()) {
      if (size == numbers.length) {
        numbers = Arrays.copyOf(numbers, Math.multiplyExact(2, size));
      }
      numbers[size++] = number();
    }
    json.endArray();
    return Arrays.copyOf(numbers, size);
  }

  /** Arrays of points, however deep. */
  Nested nested() throws IOException {
    Nested nested = new Nested();
    array(nested);
    return nested;
  }

  /**
   * Arrays of points, or one array of numbers, which are kept as they are; an array of anything
   * else is skipped.
   */
  Optional<Nested> nestedOrNumbers() throws IOException {
    if (!begin()) {
      return Optional.empty();
    }
    Nested nested = new Nested();
    if (json.peek() == JsonToken.NUMBER) {
      nested.numbers = rest();
    } else {
      elements(nested);
    }
    return Optional.of(nested);
  }

  /** Begins an array; skips it and says so if it begins with a text, a truth value or null. */
  boolean begin() throws IOException {
    json.beginArray();
    boolean isOther =
        switch (json.peek()) {
          case STRING, BOOLEAN, NULL -> true;
          default -> false;
        };
    while (isOther && json.hasNext()) {
      json.skipValue();
    }
    if (isOther) {
      json.endArray();
    }
    return !isOther;
  }

  private boolean isNumber() throws IOException {
    JsonToken next = json.peek();
    return next == JsonToken.NUMBER || next == JsonToken.STRING;
  }

  /** Reads an array or an object with x and y; gives how deep it is nested, 0 if it is empty. */
  private int array(Nested into) throws IOException {
    if (json.peek() == JsonToken.BEGIN_OBJECT) {
      object(into);
      return 1;
    }
    json.beginArray();
    if (isNumber()) {
      pair(into);
      json.endArray();
      into.depth = Math.max(into.depth, 1);
      return 1;
    }
    return elements(into);
  }

  private int elements(Nested into) throws IOException {
    int depth = 1;
    boolean isFirst = true;
    boolean hasPoint = false;
    boolean hasEmpty = false;
    while (json.hasNext()) {
      int found = array(into);
      hasPoint |= found == 1;
      hasEmpty |= found == 0;
      if (hasPoint && hasEmpty) {
        throw fault("a point has no numbers" + source.place() + "; " + PAIR);
      }
      int inner = Math.max(found, 1);
      if (!isFirst && inner != depth - 1) {
        throw fault(
            "points and lists of points stand side by side" + source.place() + "; part them");
      }
      depth = inner + 1;
      isFirst = false;
      if (depth == 3) {
        into.ring();
      } else if (depth == 4) {
        into.polygon();
      }
    }
    json.endArray();
    into.depth = Math.max(into.depth, depth);
    return isFirst ? 0 : depth;
  }

  private void pair(Nested into) throws IOException {
    int line = source.line();
    double x = number();
    if (!json.hasNext()) {
      throw fault("a point has one number only" + source.place() + "; " + PAIR);
    }
    double y = number();
    into.point(x, y, line);
    if (json.hasNext()) {
      double z = number();
      into.beyond++;
      if (json.hasNext()) {
        more(into, line, x, y, z);
      }
    }
  }

  /** The rest of a list of four numbers or more, which may be a point or a ring. */
  private void more(Nested into, int line, double x, double y, double z) throws IOException {
    PointColumns ring = new PointColumns();
    ring.add(x, y, line);
    double even = z;
    boolean isEven = false;
    while (json.hasNext()) {
      double next = number();
      into.beyond++;
      isEven = !isEven;
      if (isEven) {
        ring.add(even, next, source.line());
      } else {
        even = next;
      }
    }
    if (isEven && ring.size() > 2) {
      into.flat.add(ring);
    }
  }

  /** A point as an object. */
  private void object(Nested into) throws IOException {
    int line = source.line();
    double x = Double.NaN;
    double y = Double.NaN;
    json.beginObject();
    while (json.hasNext()) {
      switch (json.nextName()) {
        case "x", "X" -> x = number();
        case "y", "Y" -> y = number();
        default -> json.skipValue();
      }
    }
    json.endObject();
    if (Double.isNaN(x) || Double.isNaN(y)) {
      throw fault("a point lacks x or y" + source.place() + "; write {\"x\": 1, \"y\": 2}");
    }
    into.point(x, y, line);
    into.depth = Math.max(into.depth, 1);
  }

  /** The present line, from 1 on. */
  int line() {
    return source.line();
  }
}
