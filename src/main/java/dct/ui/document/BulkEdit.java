package dct.ui.document;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;

/** Changes of many vertices at once, each one step of the history, in linear time. */
public final class BulkEdit {
  private BulkEdit() {}

  /** How many vertices, or sites, in the words of a label: "1 Vertex", "12 Sites". */
  public static String words(int count, Domain domain) {
    String one = domain == Domain.POLYGON ? "Vertex" : "Site";
    String many = domain == Domain.POLYGON ? "Vertices" : "Sites";
    return count + " " + (count == 1 ? one : many);
  }

  /** The selected vertices at other places. */
  public static Edit move(Document document, Selection which, Points places) {
    String label = "Move " + words(which.count(), document.domain());
    return new Move(label, which, which.of(document.points()), places);
  }

  /**
   * New vertices.
   *
   * @param what what is done, as "Paste"; the number of the vertices is written behind it
   * @param first the number of the first of them; those from there on move up. In a polygon it is
   *     one more than that of the vertex behind which they come, or the next to be drawn
   * @param wishes the parity wished of each
   */
  public static Edit insert(
      String what, Document document, int first, Points points, ParityGoal wishes) {
    String label = what + " " + words(points.size(), document.domain());
    Selection which = Selection.range(first, first + points.size());
    Layout before = document.layout();
    Layout after = before.with(first, points.size(), document.size());
    return new Insert(label, which, points, wishes, before, after);
  }

  /**
   * The document without the selected vertices; their neighbours are joined.
   *
   * @param what what is done, as "Delete" or "Cut"
   */
  public static Edit delete(String what, Document document, Selection which) {
    String label = what + " " + words(which.count(), document.domain());
    Layout before = document.layout();
    return new Delete(
        label,
        which,
        which.of(document.points()),
        wishes(document, which),
        before,
        before.without(which, document.size()));
  }

  /** What is wished of the selected vertices. */
  public static ParityGoal wishes(Document document, Selection which) {
    Wish[] wishes = new Wish[which.count()];
    int k = 0;
    for (int v = which.next(0); v >= 0; v = which.next(v + 1)) {
      wishes[k++] = document.wishes().wish(v);
    }
    return ParityGoal.of(wishes);
  }

  /** These points with the selected ones at other places. */
  public static Points moved(Points points, Selection which, Points places) {
    double[] x = points.xs();
    double[] y = points.ys();
    int k = 0;
    for (int v = which.next(0); v >= 0; v = which.next(v + 1)) {
      x[v] = places.x(k);
      y[v] = places.y(k++);
    }
    return Points.of(x, y);
  }

  /** The document with these vertices, which get the numbers of the selection. */
  private static Document with(
      Document document, Selection which, Points points, ParityGoal wishes, Layout layout) {
    int n = document.size() + points.size();
    double[] x = new double[n];
    double[] y = new double[n];
    Wish[] all = new Wish[n];
    int old = 0;
    int added = 0;
    for (int v = 0; v < n; v++) {
      boolean isNew = which.has(v);
      Points from = isNew ? points : document.points();
      int k = isNew ? added++ : old++;
      x[v] = from.x(k);
      y[v] = from.y(k);
      all[v] = (isNew ? wishes : document.wishes()).wish(k);
    }
    return new Document(document.domain(), Points.of(x, y), layout, ParityGoal.of(all));
  }

  private static Document without(Document document, Selection which, Layout layout) {
    int n = document.size() - which.count();
    double[] x = new double[n];
    double[] y = new double[n];
    Wish[] wishes = new Wish[n];
    int k = 0;
    for (int v = 0; v < document.size(); v++) {
      if (!which.has(v)) {
        x[k] = document.points().x(v);
        y[k] = document.points().y(v);
        wishes[k++] = document.wishes().wish(v);
      }
    }
    return new Document(document.domain(), Points.of(x, y), layout, ParityGoal.of(wishes));
  }

  /** See {@link BulkEdit#move}. */
  record Move(String label, Selection which, Points before, Points after) implements Edit {
    @Override
    public Document apply(Document document) {
      return document.with(moved(document.points(), which, after));
    }

    @Override
    public Document revert(Document document) {
      return document.with(moved(document.points(), which, before));
    }
  }

  /** See {@link BulkEdit#insert}. */
  record Insert(
      String label, Selection which, Points points, ParityGoal wishes, Layout before, Layout after)
      implements Edit {
    @Override
    public Document apply(Document document) {
      return with(document, which, points, wishes, after);
    }

    @Override
    public Document revert(Document document) {
      return without(document, which, before);
    }
  }

  /** See {@link BulkEdit#delete}. */
  record Delete(
      String label, Selection which, Points points, ParityGoal wishes, Layout before, Layout after)
      implements Edit {
    @Override
    public Document apply(Document document) {
      return without(document, which, after);
    }

    @Override
    public Document revert(Document document) {
      return with(document, which, points, wishes, before);
    }
  }
}
