package dct.io.format.plain;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Shapes;
import java.io.IOException;

/** Text with a vertex a line; what no other format fits is taken for it. */
public final class PlainFormat implements Format {
  /** What the format is called. */
  public static final String TITLE = "Text";

  @Override
  public String title() {
    return TITLE;
  }

  /** In the thesis's files y grows downwards, as on its canvas. */
  @Override
  public boolean yUp() {
    return false;
  }

  @Override
  public boolean fits(Head head) {
    return true;
  }

  @Override
  public Shapes read(Input input) throws IOException {
    return VertexText.read(input);
  }
}
