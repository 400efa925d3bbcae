package dct.render;

/**
 * What is written beside the vertices.
 *
 * @param numbers whether the vertex numbers are
 * @param degrees whether the degrees are
 */
public record Labels(boolean numbers, boolean degrees) {
  /** Nothing is written. */
  public static final Labels NONE = new Labels(false, false);

  /** Whether anything is written. */
  public boolean any() {
    return numbers || degrees;
  }
}
