package dct.io.format.drawing;

import dct.io.format.Format;
import dct.io.format.Head;
import dct.io.format.Input;
import dct.io.format.Shapes;
import java.io.IOException;

/** Files of Ipe 7 that are XML, and what it copies: paths of straight edges, and marks. */
public final class IpeFormat implements Format {

  @Override
  public String title() {
    return "Ipe";
  }

  @Override
  public boolean fits(Head head) {
    String root = RootName.of(head);
    return root.equals("ipe") || root.equals("ipeselection");
  }

  @Override
  public Shapes read(Input input) throws IOException {
    return new IpeReader(input, title()).read();
  }
}
