package dct.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A page in Markdown that has generated parts, each between the comments {@code <!-- begin NAME
 * -->} and {@code <!-- end NAME -->}.
 */
final class Page {
  private final Path file;
  private String text;

  private Page(Path file, String text) {
    this.file = file;
    this.text = text;
  }

  static Page read(Path file) throws IOException {
    return new Page(file, Files.readString(file));
  }

  /** The text between the comments, with a line break at its end. */
  String part(String name) {
    return text.substring(start(name), end(name));
  }

  /** Puts another text between the comments. */
  Page with(String name, String content) {
    text = text.substring(0, start(name)) + content + text.substring(end(name));
    return this;
  }

  void write() throws IOException {
    Files.writeString(file, text);
  }

  private int start(String name) {
    String comment = "<!-- begin " + name + " -->\n";
    int at = text.indexOf(comment);
    if (at < 0) {
      throw new IllegalArgumentException(file + " has no part " + name);
    }
    return at + comment.length();
  }

  private int end(String name) {
    return text.indexOf("<!-- end " + name + " -->\n", start(name));
  }
}
