package dct.ui.document;

import dct.core.degree.ParityGoal;

/** The goals of the optimizer that have a menu item. */
public enum MostVertices {
  EVEN("Most Even Vertices", "ctrl shift E", "Finds the triangulation with the most even vertices"),
  ODD("Most Odd Vertices", "ctrl shift O", "Finds the triangulation with the most odd vertices");

  private final String title;
  private final String key;
  private final String description;

  MostVertices(String title, String key, String description) {
    this.title = title;
    this.key = key;
    this.description = description;
  }

  /** The title of a result that was made for this goal, whichever it is. */
  static String title(ParityGoal goal) {
    return goal.equals(EVEN.goal(goal.size()))
        ? EVEN.title
        : goal.equals(ODD.goal(goal.size())) ? ODD.title : "Wished Parities";
  }

  public String title() {
    return title;
  }

  public String key() {
    return key;
  }

  public String description() {
    return description;
  }

  /** The goal for n vertices. */
  public ParityGoal goal(int n) {
    return this == EVEN ? ParityGoal.allEven(n) : ParityGoal.allOdd(n);
  }
}
