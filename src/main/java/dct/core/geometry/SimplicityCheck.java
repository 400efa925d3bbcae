package dct.core.geometry;

import java.util.Optional;

/** Whether a closed chain of vertices bounds a simple polygon. */
public final class SimplicityCheck {

  private SimplicityCheck() {}

  /** The first defect of the closed chain through these points, or nothing if it is simple. */
  public static Optional<Defect> firstDefect(Points points) {
    return null;
  }
}
