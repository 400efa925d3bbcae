package dct.experiment.study;

import dct.problem.Method;
import java.util.ArrayList;
import java.util.List;

/** The names of the numbers that the study of polygons counts, and what follows from a row. */
final class PolygonsColumns {
  static final String REFLEX = "reflex";
  static final String PIECES = "pieces";

  /** The methods that are studied, also with Scan-Flip after them. */
  static final List<Method> METHODS =
      List.of(Method.EAR_CLIPPING, Method.MONOTONE, Method.CONVEX_EVEN);

  private PolygonsColumns() {}

  /** The name of the number of even vertices of a method before Scan-Flip. */
  static String before(Method method) {
    return "even_" + method.column();
  }

  /** The name of the number of even vertices of a method after Scan-Flip. */
  static String after(Method method) {
    return before(method) + "_flip";
  }

  /** All names, in the order of the columns. */
  static List<String> all() {
    List<String> all = new ArrayList<>(List.of(REFLEX, PIECES));
    all.addAll(ofMethods());
    return all;
  }

  /** The names of what the methods and the optimizer make. */
  static List<String> ofMethods() {
    List<String> names = new ArrayList<>();
    for (Method method : METHODS) {
      names.add(before(method));
      names.add(after(method));
    }
    names.addAll(List.of(StudyRow.BEST, StudyRow.LIMIT));
    return names;
  }

  /** Whether the row belongs to a file. */
  static boolean isFile(StudyRow row) {
    return row.trial().seed() == 0;
  }

  /** The convex pieces for each vertex. */
  static double pieces(StudyRow row) {
    return row.perVertex(PIECES);
  }

  /** The share of reflex vertices. */
  static double reflex(StudyRow row) {
    return row.perVertex(REFLEX);
  }
}
