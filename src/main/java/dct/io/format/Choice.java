package dct.io.format;

import dct.core.triangulate.Domain;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What is to be taken of a file, where it leaves a choice.
 *
 * @param as what the points are to be; nothing if name and content shall tell
 * @param otherwise what they are where neither tells
 * @param pick the number of the shape, from 1 on; none if there is to be one only
 * @param columns which columns of a text are meant
 * @param touch what is made of a ring that meets itself
 */
public record Choice(
    Optional<Domain> as, Domain otherwise, OptionalInt pick, Columns columns, Touch touch) {

  /** Name and content tell, or else it is a polygon. */
  public static final Choice NONE =
      new Choice(
          Optional.empty(),
          Domain.POLYGON,
          OptionalInt.empty(),
          Columns.TOLD_BY_CONTENT,
          Touch.KEPT);

  /** The same, but the points are to be of this domain. */
  public Choice as(Domain domain) {
    return new Choice(Optional.of(domain), otherwise, pick, columns, touch);
  }

  /** The same, but of this domain where neither name nor content tells. */
  public Choice otherwise(Domain domain) {
    return new Choice(as, domain, pick, columns, touch);
  }

  /** The same, but of these columns. */
  public Choice with(Columns meant) {
    return new Choice(as, otherwise, pick, meant, touch);
  }

  /** The same, but of the shape with this number, from 1 on. */
  public Choice picking(int number) {
    return new Choice(as, otherwise, OptionalInt.of(number), columns, touch);
  }
}
