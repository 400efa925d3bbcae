package dct.io.format.drawing;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Shapes;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import java.io.BufferedInputStream;
import java.io.IOException;

/** XML of which nothing is read, which is said together with the name of its outermost element. */
public final class OtherXml implements Format {

  @Override
  public String title() {
    return "XML";
  }

  @Override
  public boolean fits(Head head) {
    return RootName.isXml(head);
  }

  @Override
  public Shapes read(Input input) throws IOException {
    String root = RootName.of(Head.of(new BufferedInputStream(input.in(), Head.LENGTH)));
    throw new BadInputException(
        input.name(),
        1,
        root.isEmpty()
            ? "this looks like XML, but no element follows soon; correct its start"
            : "this is XML of <"
                + Shown.word(root)
                + ">, which is not read; save it as SVG, WKT or GeoJSON, or write one vertex a"
                + " line, as two numbers x y");
  }
}
