package dct.io.format.drawing;

import static dct.io.format.drawing.Drawn.refuses;
import static dct.io.format.drawing.Drawn.said;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.io.format.Head;
import dct.io.format.Input;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Formats that are XML are told apart, and none of it is trusted. */
class XmlTest {
  private static final String SQUARE = "<rect width='9' height='9'/>";

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<svg> | svg",
        "<s:svg xmlns:s='x'/> | svg",
        "<?xml version='1.0'?>  <!-- <ipe> --> <?x <a>?> <svg | svg",
        "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'a>b'><svg/> | svg",
        "<!DOCTYPE svg [<!ENTITY a '<b>]'> ]><svg/> | svg",
        "<kml xmlns='x'> | kml",
        "<!doctype html><html lang='en'> | html",
        "<!-- no end | ''",
        "<!DOCTYPE | ''",
        "<a:> | a",
        "<?xml?> text | ''",
        "<1, 2> | ''",
        "1 2 | ''",
      })
  void the_outermost_element_is_named(String start, String name) {
    assertThat(RootName.of(new Head(start))).isEqualTo(name);
  }

  @Test
  void other_xml_is_refused_by_its_name() {
    refuses(
        "<?xml version='1.0'?>\n<kml xmlns='http://www.opengis.net/kml/2.2'><Point/></kml>",
        "1: this is XML of <kml>, which is not read; save it as SVG, WKT or GeoJSON, or write one"
            + " vertex a line, as two numbers x y");
    refuses(
        "<!-- nothing -->",
        "1: this looks like XML, but no element follows soon; correct its start");
  }

  @Test
  void entities_are_refused() {
    refuses(
        "<!DOCTYPE svg [<!ENTITY a 'aaaaaaaaaa'><!ENTITY b '&a;&a;&a;&a;&a;&a;&a;&a;'>]>\n"
            + "<svg><title>&b;</title>"
            + SQUARE
            + "</svg>",
        "1: the DOCTYPE declares entities or more, which is not read for safety; save the drawing"
            + " anew without, from Inkscape as plain SVG");
  }

  @Test
  void no_other_file_is_read(@TempDir Path folder) throws IOException {
    Path other = Files.writeString(folder.resolve("other.dtd"), "<!ENTITY a 'read'>");
    String doctype = "<!DOCTYPE svg SYSTEM '" + other.toUri() + "'>";
    assertThat(said(doctype + "<svg>" + SQUARE + "</svg>")).startsWith("ring: 0 0");
    refuses(
        doctype + "<svg><title>&a;</title>" + SQUARE + "</svg>",
        "1: the XML is not well-formed here; mend it, or save the drawing anew");
  }

  @Test
  void deep_nesting_is_refused() throws IOException {
    String deepest = "<g>".repeat(XmlText.DEEPEST - 2) + SQUARE + "</g>".repeat(998);
    assertThat(said("<svg>" + deepest + "</svg>")).startsWith("ring: 0 0");
    refuses(
        "<svg>" + "<g>".repeat(100_000),
        "1: elements are nested more than 1000 deep; ungroup the drawing");
    refuses(
        "<svg><defs>" + "<g>".repeat(100_000),
        "1: elements are nested more than 1000 deep; ungroup the drawing");
  }

  @Test
  void a_reading_that_is_cancelled_or_fails_is_so_to_the_caller() {
    InputStream cancelled =
        new InputStream() {
          @Override
          public int read() {
            throw new CancellationException();
          }

          @Override
          public int read(byte[] bytes, int from, int length) {
            return read();
          }
        };
    assertThatThrownBy(() -> new SvgFormat().read(Input.of("in", cancelled)))
        .isInstanceOf(CancellationException.class);
    InputStream failing =
        new InputStream() {
          private int given;

          @Override
          public int read() throws IOException {
            if (given == 100_000) {
              throw new IOException("the disk is gone");
            }
            return "<svg>   ".charAt(Math.min(given++, 7));
          }

          @Override
          public int read(byte[] bytes, int from, int length) throws IOException {
            bytes[from] = (byte) read();
            return 1;
          }
        };
    assertThatThrownBy(() -> new SvgFormat().read(Input.of("in", failing)))
        .isInstanceOf(IOException.class)
        .hasMessage("the disk is gone");
  }
}
