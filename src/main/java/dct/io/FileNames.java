package dct.io;

import dct.core.triangulate.Domain;
import dct.io.text.BadInputException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The naming convention of the thesis: {@code NAME_polygonbased.txt} for polygons, {@code
 * NAME_pointbased.txt} for sites. A name ending in {@code _region} says nothing: such a file itself
 * tells.
 */
public final class FileNames {
  private static final String EXTENSION = FileEnding.TXT.dotted();

  private FileNames() {}

  /** The suffix of file names of this kind, without extension. */
  public static String suffix(Domain domain) {
    return switch (domain) {
      case POLYGON -> "_polygonbased";
      case SITES -> "_pointbased";
      case REGION -> "_region";
    };
  }

  /** What a file holds by its name, whatever its extension; nothing if the name does not say. */
  public static Optional<Domain> domain(Path file) {
    String stem = stem(name(file)).toLowerCase(Locale.ROOT);
    for (Domain domain : Domain.applications()) {
      if (stem.endsWith(suffix(domain))) {
        return Optional.of(domain);
      }
    }
    return Optional.empty();
  }

  /**
   * The file to save to when the user typed this name.
   *
   * <p>Suffix and extension are added where neither was typed, the extension alone where only the
   * suffix was. A name with an extension is kept. The suffix of the other kind is replaced: such a
   * file would be opened as what it is not.
   */
  public static Path forSaving(Path typed, Domain domain) {
    String name = name(typed);
    String stem = stem(name);
    String extension = name.substring(stem.length());
    Optional<Domain> said = domain(typed);
    if (said.isPresent() && said.get() != domain) {
      stem = stem.substring(0, stem.length() - suffix(said.get()).length()) + suffix(domain);
    } else if (said.isEmpty() && extension.isEmpty()) {
      stem += suffix(domain);
    }
    return typed.resolveSibling(stem + (extension.isEmpty() ? EXTENSION : extension));
  }

  /**
   * Why a file of this name should not be written with data of this kind: it would be opened as
   * what it is not. Nothing if the name says nothing else.
   */
  public static Optional<String> contradiction(Path typed, Domain domain) {
    return domain(typed)
        .filter(said -> said != domain)
        .map(
            said ->
                String.format(
                    Locale.ROOT,
                    "%s would be read as %s, but this is %s; name it %s",
                    typed,
                    said.word(),
                    domain.word(),
                    forSaving(typed, domain)));
  }

  /**
   * The file to open when the user typed this name: that very file, or else the one that the
   * extension, or suffix and extension, lead to.
   *
   * @return the typed name itself if there is no such file either
   * @throws BadInputException if there is both a polygon and a set of sites of that name
   */
  public static Path forOpening(Path typed) {
    if (Files.exists(typed) && !Files.isDirectory(typed)) {
      return typed;
    }
    Path extended = sibling(typed, EXTENSION);
    if (Files.isRegularFile(extended)) {
      return extended;
    }
    List<Path> suffixed =
        Domain.applications().stream()
            .map(d -> sibling(typed, suffix(d) + EXTENSION))
            .filter(Files::isRegularFile)
            .toList();
    if (suffixed.size() > 1) {
      throw new BadInputException(
          typed.toString(),
          0,
          String.format(
              Locale.ROOT,
              "there is both %s and %s; say which",
              name(suffixed.get(0)),
              name(suffixed.get(1))));
    }
    return suffixed.isEmpty() ? typed : suffixed.get(0);
  }

  private static Path sibling(Path file, String end) {
    return file.resolveSibling(name(file) + end);
  }

  private static String name(Path file) {
    Path last = file.getFileName();
    return last == null ? "" : last.toString();
  }

  /**
   * The name without its extension, a dot and one to five letters that do not make up all of it.
   */
  private static String stem(String name) {
    int dot = name.lastIndexOf('.');
    int letters = name.length() - dot - 1;
    boolean extension =
        dot > 0
            && letters >= 1
            && letters <= 5
            && name.substring(dot + 1).chars().allMatch(Character::isLetter);
    return extension ? name.substring(0, dot) : name;
  }
}
