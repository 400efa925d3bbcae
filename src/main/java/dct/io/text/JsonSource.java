package dct.io.text;

import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;

/** A text of JSON, read strictly as a stream, which knows the line that it is at. */
public final class JsonSource {
  private final String name;
  private final LineReader lines;
  private JsonReader json;

  /** The text of a stream in UTF-8 that messages call by this name. */
  public JsonSource(String name, InputStream in) {
    this.name = name;
    lines = new LineReader(new InputStreamReader(in, StandardCharsets.UTF_8.newDecoder()));
    json = strict();
  }

  private JsonReader strict() {
    JsonReader reader = new JsonReader(lines);
    reader.setStrictness(Strictness.STRICT);
    return reader;
  }

  /** Takes the end of the line for the end of the text, until {@link #goOn}. */
  public void endAtLine() {
    lines.endAtLine();
  }

  /**
   * Goes on behind the line with another stream of tokens.
   *
   * @return the first character that is no blank there, or −1 if there is none
   */
  public int goOn() throws IOException {
    int first = lines.goOn();
    json = strict();
    return first;
  }

  /** The present stream of its tokens. */
  public JsonReader json() {
    return json;
  }

  /** The present line, from 1 on. */
  public int line() {
    return lines.line();
  }

  /** Where in its arrays and objects the stream is, for a message; empty at the top. */
  public String place() {
    String path = json.getPath();
    String place = path.substring(path.startsWith("$.") ? 2 : 1);
    return place.isEmpty() ? "" : ", at " + Shown.word(place);
  }

  /** An exception for the present line. */
  public BadInputException fault(String fault) {
    return new BadInputException(name, lines.line(), fault);
  }
}
