package dct.core.geometry;

/** Points that are not what they were said to be; carries the {@link Defect} that shows it. */
public final class InvalidGeometryException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final transient Defect defect;

  public InvalidGeometryException(Defect defect) {
    super(defect.message());
    this.defect = defect;
  }

  /** What is wrong, and where. */
  public Defect defect() {
    return defect;
  }
}
