package dct.ui.result;

import dct.core.geometry.Box;
import java.awt.Dimension;
import java.util.Locale;

/** How views share the room with the drawing. */
public enum Arrangement {
  /** By the room there is: two views beside or below the drawing, more as tabs. */
  AUTO(
      "Arrange Views by Room",
      "Shows one or two results beside or below the drawing, where it is larger, and more as tabs"),
  /** All beside each other. */
  SIDE_BY_SIDE("Views Side by Side", "Shows the results in this window beside each other"),
  /** All below each other. */
  STACKED("Views Stacked", "Shows the results in this window below each other"),
  /** One at a time, with tabs to choose from. */
  TABS("Views as Tabs", "Shows one result in this window at a time, with tabs to choose from");

  private final String title;
  private final String description;

  Arrangement(String title, String description) {
    this.title = title;
    this.description = description;
  }

  /** What its command is called. */
  public String title() {
    return title;
  }

  /** What its command does, in one line. */
  public String description() {
    return description;
  }

  /** The arrangement of this name, as {@link #word} gives it; by room for any other. */
  public static Arrangement of(String word) {
    for (Arrangement arrangement : values()) {
      if (arrangement.word().equals(word)) {
        return arrangement;
      }
    }
    return AUTO;
  }

  /** Its name in the settings. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Whether views are below the drawing rather than beside it. */
  boolean isBelow(Box drawn, Dimension room) {
    return switch (this) {
      case SIDE_BY_SIDE -> false;
      case STACKED -> true;
      case AUTO, TABS -> isLargerBelow(drawn, room);
    };
  }

  /** Whether what is drawn can be shown larger in the upper half of the room than in the left. */
  private static boolean isLargerBelow(Box drawn, Dimension room) {
    double width = Math.max(drawn.halfWidth(), Double.MIN_NORMAL);
    double height = Math.max(drawn.halfHeight(), Double.MIN_NORMAL);
    double beside = Math.min(room.width / 2.0 / width, room.height / height);
    double below = Math.min(room.width / width, room.height / 2.0 / height);
    return below > beside;
  }

  /** Whether so many views are shown as tabs. */
  boolean isTabbed(int views) {
    return this == TABS || (this == AUTO && views > 2);
  }
}
