package dct.ui.document;

import dct.core.geometry.Points;

/** A named change of the points that can be taken back: {@code revert(apply(p))} equals p. */
public sealed interface Edit {

  /** What the menus call it, behind "Undo" or "Redo". */
  String label();

  /** The points after the change. */
  Points apply(Points points);

  /** The points before it. */
  Points revert(Points points);

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
    return new Delete(vertex, points.x(vertex), points.y(vertex));
  }

  /** A vertex at another place. */
  static Edit move(Document document, int vertex, double x, double y) {
    Points points = document.points();
    return new Move(vertex, points.x(vertex), points.y(vertex), x, y);
  }

  /** Other points altogether. */
  static Edit replace(String label, Document document, Points points) {
    return new Replace(label, document.points(), points);
  }

  /** See {@link #draw} and {@link #split}. */
  record Insert(String label, int vertex, double x, double y) implements Edit {
    @Override
    public Points apply(Points points) {
      return points.inserted(vertex, x, y);
    }

    @Override
    public Points revert(Points points) {
      return points.removed(vertex);
    }
  }

  /** See {@link #delete}. */
  record Delete(int vertex, double x, double y) implements Edit {
    @Override
    public String label() {
      return "Delete Vertex v" + vertex;
    }

    @Override
    public Points apply(Points points) {
      return points.removed(vertex);
    }

    @Override
    public Points revert(Points points) {
      return points.inserted(vertex, x, y);
    }
  }

  /** See {@link #move}. */
  record Move(int vertex, double oldX, double oldY, double x, double y) implements Edit {
    @Override
    public String label() {
      return "Edit Vertex v" + vertex;
    }

    @Override
    public Points apply(Points points) {
      return points.moved(vertex, x, y);
    }

    @Override
    public Points revert(Points points) {
      return points.moved(vertex, oldX, oldY);
    }
  }

  /** See {@link #replace}. */
  record Replace(String label, Points before, Points after) implements Edit {
    @Override
    public Points apply(Points points) {
      return after;
    }

    @Override
    public Points revert(Points points) {
      return before;
    }
  }
}
