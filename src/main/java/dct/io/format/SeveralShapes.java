package dct.io.format;

/** A file holds several shapes and nothing says which is meant. */
public final class SeveralShapes extends UnclearInput {
  private static final long serialVersionUID = 1L;

  private final transient Shapes shapes;

  /** Says how many there are and how to choose. */
  public SeveralShapes(String file, Shapes shapes) {
    this(file, shapes, orElse(shapes) + ", or read all as sites by --as points");
  }

  /** Several regions. */
  public static SeveralShapes ofRegions(String file, Shapes outlines) {
    return new SeveralShapes(file, outlines, "");
  }

  private static String orElse(Shapes shapes) {
    boolean holes = shapes.shapes().stream().anyMatch(shape -> shape.kind() == Shape.Kind.HOLE);
    return holes ? ", read rings with their holes by --as region" : "";
  }

  private SeveralShapes(String file, Shapes shapes, String orElse) {
    super(
        file,
        0,
        shapes.format()
            + " with "
            + shapes.shapes().size()
            + " shapes; choose one by --pick N"
            + orElse);
    this.shapes = shapes;
  }

  /** The same where one of them has to be chosen. */
  public static SeveralShapes mustChoose(String file, Shapes shapes) {
    return new SeveralShapes(file, shapes, "");
  }

  /** What there is to choose from. */
  public Shapes shapes() {
    return shapes;
  }
}
