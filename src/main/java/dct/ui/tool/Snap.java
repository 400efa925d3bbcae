package dct.ui.tool;

import dct.core.Decimals;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** What the places of vertices snap to, as the user has set it. Lives on the event thread. */
public final class Snap {

  /** The things that a place can snap to, in the order of Ipe's keys F4, F5, F7, F9. */
  public enum To {
    /** Another vertex. */
    VERTICES,
    /** An edge. */
    EDGES,
    /** The points whose coordinates are multiples of the grid's size. */
    GRID,
    /** Directions from the vertex before, or from where a drag began. */
    ANGLES
  }

  /** The grid at first: it divides the thesis's canvas of 1000 × 700. */
  private static final double GRID_AT_FIRST = 20;

  /** The angle at first: 30°, 45°, 60° and 90° are multiples of it. */
  private static final double ANGLE_AT_FIRST = 15;

  private final Runnable changed;
  private final Set<To> on = EnumSet.noneOf(To.class);
  private double grid = GRID_AT_FIRST;
  private double angle = ANGLE_AT_FIRST;

  /**
   * Nothing snaps at first.
   *
   * @param changed is run after each change
   */
  public Snap(Runnable changed) {
    this.changed = changed;
  }

  /** Whether places snap to these. */
  public boolean isOn(To to) {
    return on.contains(to);
  }

  /** Lets places snap to these, or no longer. */
  public void toggle(To to) {
    if (!on.remove(to)) {
      on.add(to);
    }
    changed.run();
  }

  /** The size of the grid, in units of the model. */
  public double grid() {
    return grid;
  }

  /** Sets the size of the grid. */
  public void setGrid(double size) {
    if (!(size > 0 && size < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("the size of a grid is " + size);
    }
    grid = size;
    changed.run();
  }

  /** The angle between directions, in degrees. */
  public double angle() {
    return angle;
  }

  /** Sets the angle between directions. */
  public void setAngle(double degrees) {
    if (!(degrees > 0 && degrees <= 180)) {
      throw new IllegalArgumentException("the angle between directions is " + degrees);
    }
    angle = degrees;
    changed.run();
  }

  /** What is on, for the status line; empty if nothing is. */
  public String words() {
    List<String> words = new ArrayList<>();
    for (To to : on) {
      String name = to.name().toLowerCase(Locale.ROOT);
      words.add(
          switch (to) {
            case VERTICES, EDGES -> name;
            case GRID -> name + " " + Decimals.format(grid);
            case ANGLES -> name + " " + Decimals.format(angle) + "°";
          });
    }
    return words.isEmpty() ? "" : "Snap: " + String.join(", ", words);
  }
}
