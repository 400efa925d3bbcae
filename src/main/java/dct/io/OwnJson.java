package dct.io;

import dct.core.Progress;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.RegionShape;
import dct.io.format.Shape;
import dct.io.format.Shapes;
import dct.io.format.Touch;
import dct.problem.verify.Claims;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The program's own JSON as a document, or as shapes to choose from. */
final class OwnJson {
  private static final String TITLE = "JSON";

  private OwnJson() {}

  /**
   * The document; where it holds no triangulation and rings touch, they are taken apart or parted
   * if that is asked for.
   *
   * @throws dct.io.format.SeveralShapes if it falls apart and nothing says which part is meant
   * @throws dct.io.text.BadInputException if its rings have vertices that there are not
   */
  static PointDocument document(Claims said, Choice choice, Progress progress) {
    PointDocument document = PointDocument.of(said, choice);
    if (choice.touch() == Touch.KEPT || said.hasEdges() || document.domain() == Domain.SITES) {
      return document;
    }
    Shapes shapes = shapes(said, document.rings());
    PointDocument apart =
        ChosenShape.of(
            said.source(), shapes, document.yUp(), choice.as(document.domain()), progress);
    boolean isSame = apart.points().equals(document.points());
    return isSame && apart.rings().equals(document.rings()) ? document : apart;
  }

  /** All shapes that it holds. */
  static Shapes shapes(Claims said) {
    boolean isRegion = said.domain().equals(Optional.of(Domain.REGION));
    return shapes(said, isRegion ? PointDocument.of(said, Choice.NONE).rings() : Optional.empty());
  }

  private static Shapes shapes(Claims said, Optional<Rings> rings) {
    Shape.Kind kind =
        said.domain()
            .map(domain -> domain == Domain.SITES ? Shape.Kind.SITES : Shape.Kind.RING)
            .orElse(Shape.Kind.POINTS);
    Shape shape = new Shape(kind, "", said.points(), said.lines(), Optional.empty());
    List<String> notes =
        said.text(ResultJson.DRAWN_WISHES).isPresent() ? List.of("Wishes are left out") : List.of();
    return new Shapes(
        TITLE,
        List.of(shape),
        notes,
        rings.map(all -> new Shapes.Whole(region(said, all), notes)),
        rings.isPresent());
  }

  private static RegionShape region(Claims said, Rings rings) {
    List<int[]> all = new ArrayList<>();
    for (int r = 0; r < rings.count(); r++) {
      all.add(rings.ring(r));
    }
    return new RegionShape("", said.points(), said.lines(), all, rings.fixed());
  }
}
