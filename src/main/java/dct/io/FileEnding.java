package dct.io;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The endings of the files that the program writes, and what a file of each can hold. */
public enum FileEnding {
  TXT(Content.POINTS),
  JSON(Content.POINTS, Content.TRIANGULATION),
  WKT(Content.POINTS),
  GEOJSON(Content.POINTS),
  NODE(Content.POINTS),
  POLY(Content.POINTS),
  ELE(Content.TRIANGULATION),
  EDGE(Content.TRIANGULATION),
  OFF(Content.POINTS, Content.TRIANGULATION),
  OBJ(Content.POINTS, Content.TRIANGULATION),
  /** An instance of CG:SHOP 2026: points and triangulations of them. */
  INSTANCE(".instance.json", Content.TRIANGULATION),
  /** A solution of CG:SHOP 2026: flips. */
  SOLUTION(".solution.json", Content.TRIANGULATION),
  PNG(Content.PICTURE, Content.CHART),
  SVG(Content.PICTURE, Content.CHART),
  PDF(Content.PICTURE, Content.CHART),
  IPE(Content.PICTURE),
  TEX(Content.PICTURE, Content.TABLES),
  CSV(Content.ROWS),
  MD(Content.TABLES);

  /** What a file can hold. */
  public enum Content {
    POINTS,
    TRIANGULATION,
    /** A picture of a scene. */
    PICTURE,
    /** The rows of a study. */
    ROWS,
    /** The tables of a study. */
    TABLES,
    /** A chart of a study. */
    CHART
  }

  private final String dotted;
  private final Content content;
  private final Content other; // what it can hold, too; the same again if there is nothing else

  FileEnding(Content content) {
    this(content, content);
  }

  FileEnding(String dotted, Content content) {
    this(Optional.of(dotted), content, content);
  }

  FileEnding(Content content, Content other) {
    this(Optional.empty(), content, other);
  }

  FileEnding(Optional<String> dotted, Content content, Content other) {
    this.dotted = dotted.orElseGet(() -> "." + name().toLowerCase(Locale.ROOT));
    this.content = content;
    this.other = other;
  }

  /** The ending of a file's name, in capitals or not, if a file of it can hold one of these. */
  public static Optional<FileEnding> of(Path file, Content... contents) {
    return of(file.toString(), contents);
  }

  /** The same for a name. */
  public static Optional<FileEnding> of(String name, Content... contents) {
    return holding(contents).stream()
        .filter(ending -> ending.isOf(name))
        .max(Comparator.comparingInt(ending -> ending.dotted.length()));
  }

  /** Whether a file's name ends so, in capitals or not. */
  public boolean isOf(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(dotted());
  }

  /**
   * The same for a file that is about to be written.
   *
   * @throws IllegalArgumentException if the ending is none of these; its message lists them
   */
  public static FileEnding require(Path file, Content... contents) {
    return of(file, contents)
        .orElseThrow(
            () -> new IllegalArgumentException(file + " does not end in " + list(contents)));
  }

  /** The endings of files that can hold one of these, as {@code .md or .tex}. */
  public static String list(Content... contents) {
    List<String> words = holding(contents).stream().map(FileEnding::dotted).toList();
    int last = words.size() - 1;
    return last == 0
        ? words.get(0)
        : String.join(", ", words.subList(0, last)) + " or " + words.get(last);
  }

  /** Whether a file of this ending can hold one of these. */
  public boolean holds(Content... contents) {
    return holding(contents).contains(this);
  }

  private static List<FileEnding> holding(Content... contents) {
    List<Content> wished = List.of(contents);
    return Arrays.stream(values())
        .filter(ending -> wished.contains(ending.content) || wished.contains(ending.other))
        .toList();
  }

  /** The ending with its dot, in small letters. */
  public String dotted() {
    return dotted;
  }

  /** The endings of files that can hold one of these, without dots, as file panels take them. */
  public static String[] extensions(Content... contents) {
    return holding(contents).stream()
        .map(ending -> ending.dotted().substring(1))
        .toArray(String[]::new);
  }

  /** The file itself if its ending is one of these, or else with this ending after its name. */
  public Path orElseOn(Path typed, Content... contents) {
    return of(typed, contents).isPresent()
        ? typed
        : typed.resolveSibling(typed.getFileName() + dotted());
  }

  /** A name without its ending, if it has one. */
  public static String without(String name) {
    return name.replaceFirst("\\.[A-Za-z]{1,5}$", "");
  }

  /** The file of the same name with this ending in place of its own. */
  public Path insteadOf(Path file) {
    String name = file.getFileName().toString();
    return file.resolveSibling(without(name) + dotted());
  }
}
