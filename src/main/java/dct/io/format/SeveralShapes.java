package dct.io.format;

/** A file holds several shapes and nothing says which is meant. */
public final class SeveralShapes extends UnclearInput {
  private static final long serialVersionUID = 1L;

  private final transient Shapes shapes;

  /** Says how many there are and how to choose. */
  public SeveralShapes(String file, Shapes shapes) {
    super(
        file,
        0,
        shapes.format()
            + " with "
            + shapes.shapes().size()
            + " shapes; choose one by --pick N, or read all as sites by --as points");
    this.shapes = shapes;
  }

  /** What there is to choose from. */
  public Shapes shapes() {
    return shapes;
  }
}
