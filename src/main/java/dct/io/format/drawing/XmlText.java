package dct.io.format.drawing;

import dct.io.format.Input;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import java.io.BufferedInputStream;
import java.io.IOException;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * The elements of a file of XML, one after the other, in memory that does not grow with the file.
 *
 * <p>Nothing outside the file is ever read; a file that declares entities is refused, and so is one
 * whose elements are nested more than {@value #DEEPEST} deep.
 */
final class XmlText {
  static final int DEEPEST = 1000;

  private final String name;
  private final WatchedReader characters;
  private final XMLStreamReader xml;
  private int depth;
  private int line = 1;

  /** Opens the file; {@link #next} gives its outermost element first. */
  XmlText(Input input) throws IOException {
    name = input.name();
    characters = new WatchedReader(XmlEncoding.reader(name, new BufferedInputStream(input.in())));
    try {
      xml = factory().createXMLStreamReader(characters);
    } catch (XMLStreamException e) {
      throw damage(1);
    }
  }

  private static XMLInputFactory factory() {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setXMLResolver(
        (publicId, systemId, base, namespace) -> {
          throw new XMLStreamException("nothing outside the file is read");
        });
    return factory;
  }

  /** What comes next in the file. */
  enum Event {
    OPENED,
    CLOSED,
    TEXT,
    END
  }

  /**
   * Goes to the next start or end of an element, or text between them.
   *
   * @throws BadInputException if it is not well-formed there
   */
  Event next() throws IOException {
    while (true) {
      line = Math.max(xml.getLocation().getLineNumber(), 0);
      switch (advance()) {
        case XMLStreamConstants.START_ELEMENT -> {
          return opened();
        }
        case XMLStreamConstants.END_ELEMENT -> {
          depth--;
          return Event.CLOSED;
        }
        case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> {
          return Event.TEXT;
        }
        case XMLStreamConstants.END_DOCUMENT -> {
          return Event.END;
        }
        case XMLStreamConstants.DTD -> refuseDeclarations();
        default -> {
          // comments and instructions for programs
        }
      }
    }
  }

  // The parser of the JDK meets some malformed files with a RuntimeException of its own.
  private int advance() throws IOException {
    try {
      return xml.next();
    } catch (XMLStreamException | RuntimeException e) {
      characters.rethrow();
      throw damage(Math.max(xml.getLocation().getLineNumber(), 0));
    }
  }

  private Event opened() {
    if (++depth > DEEPEST) {
      throw fault("elements are nested more than " + DEEPEST + " deep; ungroup the drawing");
    }
    return Event.OPENED;
  }

  /** Refuses declarations within the file: entities among them may grow without bound. */
  private void refuseDeclarations() {
    if (xml.getText().endsWith("]>")) {
      throw fault(
          "the DOCTYPE declares entities or more, which is not read for safety; save the drawing"
              + " anew without, from Inkscape as plain SVG");
    }
  }

  private BadInputException damage(int at) {
    return new BadInputException(
        name,
        at,
        characters.isAtEnd()
            ? "the XML ends before its last element is closed; restore the rest of the file"
            : "the XML is not well-formed here; mend it, or save the drawing anew");
  }

  /** Skips what the element that has just been opened holds, and its end. */
  void skip() throws IOException {
    int outside = depth - 1;
    while (depth > outside) {
      next();
    }
  }

  /** The text in the element that has just been opened, without that in others; then its end. */
  String text() throws IOException {
    StringBuilder text = new StringBuilder();
    int inside = depth;
    while (depth >= inside) {
      if (next() == Event.TEXT && depth == inside) {
        text.append(xml.getTextCharacters(), xml.getTextStart(), xml.getTextLength());
      }
    }
    return text.toString();
  }

  /** How deep the element that has just been opened is nested: 1 for the outermost. */
  int depth() {
    return depth;
  }

  /** The element's name without its prefix. */
  String element() {
    return xml.getLocalName();
  }

  /** The element's namespace; empty if it has none. */
  String namespace() {
    String uri = xml.getNamespaceURI();
    return uri == null ? "" : uri;
  }

  /** An attribute without a prefix; empty if it is missing. */
  String attribute(String attribute) {
    String value = xml.getAttributeValue("", attribute);
    return value == null ? "" : value;
  }

  /** An attribute of a namespace; empty if it is missing. */
  String attribute(String namespace, String attribute) {
    String value = xml.getAttributeValue(namespace, attribute);
    return value == null ? "" : value;
  }

  /** The line in which what was last gone to starts, from 1 on. */
  int line() {
    return line;
  }

  /** The line in which the start of the element ends. */
  int lineBehind() {
    return Math.max(xml.getLocation().getLineNumber(), 0);
  }

  /** That something is wrong in {@link #line}. */
  BadInputException fault(String sentence) {
    return fault(line, sentence);
  }

  /** That something is wrong in a line. */
  BadInputException fault(int at, String sentence) {
    return new BadInputException(name, at, sentence);
  }

  /**
   * Lets only doubles pass that are numbers.
   *
   * @throws BadInputException if one of them is none
   */
  void checkFinite(double x, double y, int at) {
    if (!Double.isFinite(x) || !Double.isFinite(y)) {
      throw fault(at, "a point is beyond the range of double numbers; scale the drawing down");
    }
  }

  /** That a word stands where a number should. */
  BadInputException noNumber(int at, String word, String place) {
    return fault(
        at,
        word.isEmpty()
            ? "a number is missing at the end of " + place + "; add it"
            : "\"" + Shown.word(word) + "\" in " + place + " is not a number; correct it");
  }
}
