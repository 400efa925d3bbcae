package dct.ui.document;

import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.core.geometry.Points;
import java.util.Optional;

/**
 * A named change of a document that can be taken back: {@code revert(apply(d))} equals d. A change
 * of the points drops the result, which {@link History} brings back.
 */
public sealed interface Edit
    permits Edit.Insert,
        Edit.Delete,
        Edit.Move,
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

  /** A new vertex at the end. */
  static Edit draw(Document document, double x, double y) {
    return new Insert("Draw Vertex v" + document.size(), document.size(), x, y);
  }

  /** A new vertex with this number; those from there on move up by one. */
  static Edit split(int vertex, double x, double y) {
    return new Insert("Split Vertex v" + vertex, vertex, x, y);
  }

  /** One vertex less; its neighbours are joined. */
  static Edit delete(Document document, int vertex) {
    Points points = document.points();
    return new Delete(vertex, points.x(vertex), points.y(vertex), document.wishes().wish(vertex));
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

  private static Document inserted(Document document, int vertex, double x, double y, Wish wish) {
    return new Document(
        document.domain(),
        document.points().inserted(vertex, x, y),
        document.wishes().inserted(vertex, wish));
  }

  private static Document removed(Document document, int vertex) {
    return new Document(
        document.domain(), document.points().removed(vertex), document.wishes().removed(vertex));
  }

  /** See {@link #draw} and {@link #split}. */
  record Insert(String label, int vertex, double x, double y) implements Edit {
    @Override
    public Document apply(Document document) {
      return inserted(document, vertex, x, y, Wish.EVEN);
    }

    @Override
    public Document revert(Document document) {
      return removed(document, vertex);
    }
  }

  /** See {@link #delete}. */
  record Delete(int vertex, double x, double y, Wish wish) implements Edit {
    @Override
    public String label() {
      return "Delete Vertex v" + vertex;
    }

    @Override
    public Document apply(Document document) {
      return removed(document, vertex);
    }

    @Override
    public Document revert(Document document) {
      return inserted(document, vertex, x, y, wish);
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
