package dct.io.format.drawing;

/** What a drawing may hold that is no polygon. */
enum LeftOut {
  BACKGROUND("background", "backgrounds"),
  CURVED("curved path", "curved paths"),
  LINE("line of fewer than 3 vertices", "lines of fewer than 3 vertices"),
  SIZELESS("rectangle without a plain size", "rectangles without a plain size"),
  CIRCLE("circle or ellipse", "circles and ellipses"),
  TEXT("text", "texts"),
  IMAGE("image", "images"),
  USE("copy by reference", "copies by reference"),
  SYMBOL("symbol that is no mark", "symbols that are no marks"),
  DEFINITION("shape in definitions", "shapes in definitions"),
  HIDDEN("hidden element", "hidden elements"),
  EMBEDDED("embedded drawing", "embedded drawings");

  private final String one;
  private final String several;

  LeftOut(String one, String several) {
    this.one = one;
    this.several = several;
  }

  /** How many of it there are, as {@code 2 texts}. */
  String counted(int count) {
    return count + " " + (count == 1 ? one : several);
  }

  /** A sentence without its full stop. */
  String note(int count) {
    return counted(count) + (count == 1 ? " is" : " are") + " left out";
  }
}
