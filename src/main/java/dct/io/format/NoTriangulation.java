package dct.io.format;

import dct.core.triangulate.Domain;

/** A file holds triangles, or edges, that are no triangulation of its points. */
public final class NoTriangulation extends UnclearInput {
  private static final long serialVersionUID = 1L;

  private final String cause;

  /**
   * Says why.
   *
   * @param what what is none, as {@code triangles}
   * @param domain what the points are taken for
   * @param line where it shows, from 1 on
   * @param why a clause
   */
  public NoTriangulation(String file, String what, Domain domain, int line, String why) {
    super(file, line, clause(what, domain) + why + "; read its points alone with --as points");
    this.cause = clause(what, domain) + why;
  }

  private static String clause(String what, Domain domain) {
    return "its " + what + " are no triangulation of its " + domain.title() + ": ";
  }

  /** What is wrong, without file, line and cure. */
  public String cause() {
    return cause;
  }

  /** The same as a note, where the points are wanted all the same. */
  public String note() {
    return "Line " + line() + ": " + cause + "; only its points are read";
  }
}
