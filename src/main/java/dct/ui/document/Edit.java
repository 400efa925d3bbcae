package dct.ui.document;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import java.util.Optional;

/**
 * A named change of a document that can be taken back: {@code revert(apply(d))} equals d. A change
 * of the points drops the result, which {@link History} brings back.
 */
public sealed interface Edit
    permits Edit.Insert,
        Edit.Delete,
        Edit.Move,
        Edit.Laid,
        Edit.Wished,
        Edit.Replace,
        Edit.Made,
        BulkEdit.Move,
        BulkEdit.Insert,
        BulkEdit.Delete {

  /** What the menus call it, behind "Undo" or "Redo". */
  String label();

  /** The document after the change. */
  Document apply(Document document);

  /** The document before it. */
  Document revert(Document document);

  /** A new vertex at the end of the ring that is drawn, or a new site. */
  static Edit draw(Document document, double x, double y) {
    int n = document.size();
    int number = document.layout().next(n);
    Layout before = document.layout();
    return new Insert("Draw Vertex v" + number, number, x, y, before, before.drawn(n));
  }

  /** A new vertex between the ends of an edge of a polygon, or a new site. */
  static Edit split(Document document, int from, int to, double x, double y) {
    int n = document.size();
    Layout before = document.layout();
    boolean sites = document.domain() == Domain.SITES;
    int number = sites ? n : before.splitNumber(from, to, n);
    return new Insert("Split Vertex v" + number, number, x, y, before, before.split(from, to, n));
  }

  /** A new site inside a polygon. */
  static Edit site(Document document, double x, double y) {
    int n = document.size();
    Layout before = document.layout();
    return new Insert("Draw Inner Site v" + n, n, x, y, before, before.withSite(n));
  }

  /** The same vertices hanging together otherwise. */
  static Edit layout(String label, Document document, Layout after) {
    return new Laid(label, document.layout(), after);
  }

  /** One vertex less; its neighbours are joined. */
  static Edit delete(Document document, int vertex) {
    Points points = document.points();
    Layout before = document.layout();
    return new Delete(
        vertex,
        points.x(vertex),
        points.y(vertex),
        document.wishes().wish(vertex),
        before,
        before.without(Selection.of(vertex), document.size()));
  }

  /** A vertex at another place. */
  static Edit move(Document document, int vertex, double x, double y) {
    Points points = document.points();
    return new Move(vertex, points.x(vertex), points.y(vertex), x, y);
  }

  /** Another wish for a vertex. */
  static Edit wish(Document document, int vertex, Wish wish) {
    return new Wished(vertex, document.wishes().wish(vertex), wish);
  }

  /** Other wishes altogether. */
  static Edit wishes(String label, Document document, ParityGoal wishes) {
    return new Replace(label, document, document.with(wishes));
  }

  /** Other points altogether, every one wished to be even. */
  static Edit replace(String label, Document document, Points points) {
    return new Replace(label, document, new Document(document.domain(), points));
  }

  /** Something made of the points, or nothing: the points alone. */
  static Edit result(String label, Document document, Optional<Result> after) {
    return new Made(label, document.result(), after);
  }

  private static Document inserted(
      Document document, int vertex, double x, double y, Wish wish, Layout layout) {
    return new Document(
        document.domain(),
        document.points().inserted(vertex, x, y),
        layout,
        document.wishes().inserted(vertex, wish));
  }

  private static Document removed(Document document, int vertex, Layout layout) {
    return new Document(
        document.domain(),
        document.points().removed(vertex),
        layout,
        document.wishes().removed(vertex));
  }

  /** See {@link #draw}, {@link #split} and {@link #site}. */
  record Insert(String label, int vertex, double x, double y, Layout before, Layout after)
      implements Edit {
    @Override
    public Document apply(Document document) {
      return inserted(document, vertex, x, y, Wish.EVEN, after);
    }

    @Override
    public Document revert(Document document) {
      return removed(document, vertex, before);
    }
  }

  /** See {@link #delete}. */
  record Delete(int vertex, double x, double y, Wish wish, Layout before, Layout after)
      implements Edit {
    @Override
    public String label() {
      return "Delete Vertex v" + vertex;
    }

    @Override
    public Document apply(Document document) {
      return removed(document, vertex, after);
    }

    @Override
    public Document revert(Document document) {
      return inserted(document, vertex, x, y, wish, before);
    }
  }

  /** See {@link #layout}. */
  record Laid(String label, Layout before, Layout after) implements Edit {
    @Override
    public Document apply(Document document) {
      return document.with(after);
    }

    @Override
    public Document revert(Document document) {
      return document.with(before);
    }
  }

  /** See {@link #move}. */
  record Move(int vertex, double oldX, double oldY, double x, double y) implements Edit {
    @Override
    public String label() {
      return "Edit Vertex v" + vertex;
    }

    @Override
    public Document apply(Document document) {
      return document.with(document.points().moved(vertex, x, y));
    }

    @Override
    public Document revert(Document document) {
      return document.with(document.points().moved(vertex, oldX, oldY));
    }
  }

  /** See {@link #wish}. */
  record Wished(int vertex, Wish before, Wish after) implements Edit {
    @Override
    public String label() {
      return "Wish Parity v" + vertex;
    }

    @Override
    public Document apply(Document document) {
      return document.with(document.wishes().with(vertex, after));
    }

    @Override
    public Document revert(Document document) {
      return document.with(document.wishes().with(vertex, before));
    }
  }

  /** See {@link #replace} and {@link #wishes}. */
  record Replace(String label, Document before, Document after) implements Edit {
    @Override
    public Document apply(Document document) {
      return after;
    }

    @Override
    public Document revert(Document document) {
      return before;
    }
  }

  /** See {@link #result}. */
  record Made(String label, Optional<Result> before, Optional<Result> after) implements Edit {
    @Override
    public Document apply(Document document) {
      return document.with(after);
    }

    @Override
    public Document revert(Document document) {
      return document.with(before);
    }
  }
}
