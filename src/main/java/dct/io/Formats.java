package dct.io;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.drawing.IpeFormat;
import dct.io.format.drawing.OtherXml;
import dct.io.format.drawing.SvgFormat;
import dct.io.format.json.JsonFormat;
import dct.io.format.lists.CgalFormat;
import dct.io.format.lists.QhullFormat;
import dct.io.format.lists.RpgFormat;
import dct.io.format.lists.TsplibFormat;
import dct.io.format.mesh.EdgeFormat;
import dct.io.format.mesh.EleFormat;
import dct.io.format.mesh.ObjFormat;
import dct.io.format.mesh.OffFormat;
import dct.io.format.mesh.PlyFormat;
import dct.io.format.mesh.TriangleFormat;
import dct.io.format.plain.PlainFormat;
import dct.io.format.wkt.WktFormat;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The formats that shapes are read from; the first that fits a file's start is taken. */
public final class Formats {
  private static final Pattern NUMBER_IN_BRACE = Pattern.compile("\\{\\s*[-+.0-9{]");
  private static final List<Format> FOREIGN =
      List.of(
          new WktFormat(),
          new JsonFormat(),
          new OffFormat(),
          new ObjFormat(),
          new PlyFormat(),
          new TsplibFormat(),
          new CgalFormat(),
          new QhullFormat(),
          new RpgFormat(),
          new TriangleFormat(),
          new EleFormat(),
          new EdgeFormat(),
          new SvgFormat(),
          new IpeFormat());
  private static final Format OTHER_XML = new OtherXml(); // of which nothing is read
  private static final Format PLAIN = new PlainFormat();

  private Formats() {}

  /** What lists call the formats of other programs that are read, each once. */
  public static List<String> titles() {
    return FOREIGN.stream().map(Format::title).distinct().toList();
  }

  /** The format of a file that starts so; nothing if it is the program's own JSON. */
  static Optional<Format> of(Head head) {
    Optional<Format> foreign =
        Stream.concat(FOREIGN.stream(), Stream.of(OTHER_XML))
            .filter(format -> format.fits(head))
            .findFirst();
    boolean isOwnJson = head.first() == '{' && !head.startsWith(NUMBER_IN_BRACE);
    return foreign.isPresent() || isOwnJson ? foreign : Optional.of(PLAIN);
  }
}
