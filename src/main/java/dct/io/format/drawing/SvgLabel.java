package dct.io.format.drawing;

import java.util.function.Supplier;

/**
 * What an element of SVG is called: by Inkscape's label, else its title, else its id, else as the
 * group that it is in.
 */
final class SvgLabel implements Supplier<String> {
  private static final String INKSCAPE = "http://www.inkscape.org/namespaces/inkscape";

  private final Supplier<String> group;
  private final String label;
  private final String id;
  private String title = "";

  /** The label of the element that has just been opened. */
  SvgLabel(XmlText xml, Supplier<String> group) {
    this.group = group;
    label = xml.attribute(INKSCAPE, "label");
    id = xml.attribute("id");
  }

  /** Says what the element's title is. */
  void title(String text) {
    title = text.strip();
  }

  @Override
  public String get() {
    if (!label.isEmpty()) {
      return label;
    }
    if (!title.isEmpty()) {
      return title;
    }
    return id.isEmpty() ? group.get() : id;
  }
}
