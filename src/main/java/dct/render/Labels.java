package dct.render;

/**
 * What is written beside the vertices.
 *
 * @param numbers whether the vertex numbers are
 * @param degrees whether the degrees are
 * @param coordinates whether the coordinates are, rounded to be read
 */
public record Labels(boolean numbers, boolean degrees, boolean coordinates) {
  /** Nothing is written. */
  public static final Labels NONE = new Labels(false, false);

  /** Labels without coordinates. */
  public Labels(boolean numbers, boolean degrees) {
    this(numbers, degrees, false);
  }

  /** Whether anything is written. */
  public boolean any() {
    return numbers || degrees || coordinates;
  }
}
