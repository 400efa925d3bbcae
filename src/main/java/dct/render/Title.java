package dct.render;

/**
 * What a picture is called, and in a sentence what it shows: for those who search or do not see it.
 */
record Title(String title, String description) {

  /** The name of what is drawn, and its numbers. */
  static Title of(String name, Scene scene) {
    String what =
        kind(scene)
            + scene.size()
            + (scene.size() == 1 ? " vertex, " : " vertices, ")
            + scene.edgeCount()
            + (scene.edgeCount() == 1 ? " edge" : " edges");
    String counts = String.join("; ", scene.counts());
    return new Title(
        name.isEmpty() ? "Degree constrained triangulation" : name,
        counts.isEmpty() ? what : what + ". " + counts);
  }

  private static String kind(Scene scene) {
    if (scene.isPolygon()) {
      return "A polygon of ";
    }
    return scene.hasInside() ? "A region of " : "Sites: ";
  }
}
