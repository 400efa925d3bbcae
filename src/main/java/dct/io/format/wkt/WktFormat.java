package dct.io.format.wkt;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Shapes;
import java.io.IOException;
import java.util.regex.Pattern;

/** Well-Known Text, and its extension with a reference system: geometries one after the other. */
public final class WktFormat implements Format {
  private static final Pattern START =
      Pattern.compile(
          "(?i)(SRID\\s*=\\s*\\d+\\s*;\\s*)?(MULTI)?(POINT|LINESTRING|LINEARRING|"
              + "POLYGON|GEOMETRYCOLLECTION|TRIANGLE|TIN|POLYHEDRALSURFACE|CURVE|SURFACE|"
              + "CIRCULARSTRING|COMPOUNDCURVE|CURVEPOLYGON)\\s*(Z|M|ZM)?\\s*(\\(|EMPTY\\b)");

  @Override
  public String title() {
    return WktReader.TITLE;
  }

  @Override
  public boolean fits(Head head) {
    return head.withoutComments().startsWith(START);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    return WktReader.read(input);
  }
}
