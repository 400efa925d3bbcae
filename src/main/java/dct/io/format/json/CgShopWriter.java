package dct.io.format.json;

import com.google.gson.JsonPrimitive;
import dct.core.degree.Flip;
import dct.core.degree.FlipList;
import dct.core.degree.FlipResult;
import dct.core.geometry.Points;
import dct.core.triangulate.Triangulation;
import dct.io.format.CannotHold;
import dct.io.format.Drawing;
import dct.io.format.TextOut;
import dct.problem.Solution;
import java.io.IOException;
import java.util.Optional;

/**
 * Writes for the challenge CG:SHOP 2026, which takes triangulations of the same sites to one by
 * flips.
 *
 * <p>The instance holds the triangulations before and after the flips; the solution takes the first
 * to the second by our flips, each a step of its own, and leaves the second as it is. Without flips
 * there is one triangulation and no step.
 */
public final class CgShopWriter {
  private static final String SITES_ONLY =
      "CG:SHOP 2026 has triangulations of sites alone; choose .json or .off";

  private CgShopWriter() {}

  /**
   * Writes the instance.
   *
   * @throws CannotHold if the points are no sites with whole coordinates, or not triangulated
   */
  public static void writeInstance(Drawing drawing, TextOut out) throws IOException {
    Solution solution = sites(drawing);
    Points points = drawing.points();
    for (int v = 0; v < points.size(); v++) {
      if (!isWhole(points.x(v)) || !isWhole(points.y(v))) {
        throw new CannotHold("coordinates of CG:SHOP are whole numbers; choose .json or .off");
      }
    }
    head("Instance", drawing, out);
    out.add("\"points_x\": [");
    for (int v = 0; v < points.size(); v++) {
      out.add(v == 0 ? "" : ", ").add(points.x(v));
    }
    out.add("],\n \"points_y\": [");
    for (int v = 0; v < points.size(); v++) {
      out.add(v == 0 ? "" : ", ").add(points.y(v));
    }
    out.add("],\n \"triangulations\": [\n");
    Optional<FlipResult> flips = solution.flips();
    if (flips.isPresent()) {
      edges(flips.get().before(), out);
      out.add(",\n");
    }
    edges(solution.triangulation(), out);
    out.add("\n]}\n");
  }

  /**
   * Writes the solution.
   *
   * @throws CannotHold if the points are no sites, or not triangulated
   */
  public static void writeSolution(Drawing drawing, TextOut out) throws IOException {
    Optional<FlipResult> flips = sites(drawing).flips();
    head("Solution", drawing, out);
    out.add("\"flips\": [[");
    if (flips.isPresent()) {
      boolean isFirst = true;
      for (Flip flip : FlipList.of(flips.get()).flips()) {
        out.add(isFirst ? "\n" : ",\n");
        out.add("[[").add(flip.u()).add(", ").add(flip.v()).add("]]");
        isFirst = false;
      }
      out.add("], [");
    }
    out.add("]],\n \"meta\": {}}\n");
  }

  private static Solution sites(Drawing drawing) throws CannotHold {
    if (drawing.isRing()) {
      throw new CannotHold(SITES_ONLY);
    }
    return drawing
        .solution()
        .orElseThrow(() -> new CannotHold("CG:SHOP 2026 has triangulations; triangulate first"));
  }

  private static boolean isWhole(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1L << 53;
  }

  private static void head(String what, Drawing drawing, TextOut out) throws IOException {
    out.add("{\"content_type\": \"CGSHOP2026_" + what + "\",\n \"instance_uid\": ");
    out.add(new JsonPrimitive(drawing.name()).toString()).add(",\n ");
  }

  private static void edges(Triangulation triangulation, TextOut out) throws IOException {
    out.add("[");
    for (int e = 0; e < triangulation.edgeCount(); e++) {
      out.tick(e, triangulation.edgeCount());
      out.add(e == 0 ? "" : ", ").add("[").add(triangulation.from(e)).add(", ");
      out.add(triangulation.to(e)).add("]");
    }
    out.add("]");
  }
}
