package dct.io.format.drawing;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Shapes;
import java.io.IOException;

/** SVG: polygons, polylines, rectangles and paths of straight edges. */
public final class SvgFormat implements Format {

  @Override
  public String title() {
    return "SVG";
  }

  @Override
  public boolean yUp() {
    return false;
  }

  @Override
  public boolean fits(Head head) {
    return RootName.of(head).equals("svg");
  }

  @Override
  public Shapes read(Input input) throws IOException {
    return new SvgReader(input, title()).read();
  }
}
