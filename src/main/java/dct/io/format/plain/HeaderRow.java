package dct.io.format.plain;

import dct.io.format.Columns;
import dct.io.text.Shown;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/** The names of columns above the first row of numbers. */
final class HeaderRow {
  private static final Pattern SEPARATOR = Pattern.compile("[,;\t]");
  private static final Pattern BLANKS = Pattern.compile("\\s+");
  private static final Pattern CELL = Pattern.compile("[\\p{L}_][^,;\t\"']*");
  private static final Set<String> X =
      Set.of("x", "xcoord", "xcoordinate", "lon", "long", "lng", "longitude", "easting", "east");
  private static final Set<String> Y =
      Set.of("y", "ycoord", "ycoordinate", "lat", "latitude", "northing", "north");

  private final List<String> names;

  private HeaderRow(List<String> names) {
    this.names = names;
  }

  /** The names in a line, if it is a row of two or more, each a word. */
  static Optional<HeaderRow> of(String line) {
    List<String> names =
        Arrays.stream((isSeparated(line) ? SEPARATOR : BLANKS).split(line))
            .map(cell -> cell.strip().replaceAll("^([\"'])(.*)\\1$", "$2").strip())
            .toList();
    boolean areWords =
        names.size() > 1
            && names.stream().skip(1).allMatch(cell -> CELL.matcher(cell).matches())
            && (names.get(0).isEmpty() || CELL.matcher(names.get(0)).matches());
    return areWords ? Optional.of(new HeaderRow(names)) : Optional.empty();
  }

  /** Whether something else than blanks parts the cells of a line. */
  static boolean isSeparated(String line) {
    return SEPARATOR.matcher(line).find();
  }

  /** The columns of x and y, if one each has such a name. */
  Optional<Columns.Pair> xy() {
    int x = only(X);
    int y = only(Y);
    return x > 0 && y > 0 ? Optional.of(new Columns.Pair(x, y)) : Optional.empty();
  }

  /** What there is to say of taking these columns. */
  String note(Columns.Pair xy) {
    int others = names.size() - 2;
    String left =
        switch (others) {
          case 0 -> "";
          case 1 -> ", 1 other column is left out";
          default -> ", " + others + " other columns are left out";
        };
    return "The header row names x (" + shown(xy.x()) + ") and y (" + shown(xy.y()) + ")" + left;
  }

  private String shown(int column) {
    return Shown.word(names.get(column - 1));
  }

  /** The number of the only column with one of these names, from 1 on; 0 if there is none. */
  private int only(Set<String> words) {
    int found = 0;
    for (int c = 0; c < names.size(); c++) {
      if (words.contains(plain(names.get(c)))) {
        if (found > 0) {
          return 0;
        }
        found = c + 1;
      }
    }
    return found;
  }

  /** Without units in parentheses, blanks and the like, in small letters. */
  private static String plain(String cell) {
    String name = cell.replaceAll("[(\\[].*", "").replaceAll("[\\s_.-]", "");
    return name.toLowerCase(Locale.ROOT);
  }
}
