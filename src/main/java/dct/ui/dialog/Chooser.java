package dct.ui.dialog;

import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import java.awt.Component;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;

/**
 * The file panels. Each kind begins in the folder where it was last, in this run or one before,
 * unless told another; one that was nowhere yet begins where documents were.
 */
public enum Chooser {
  DOCUMENTS("Polygons and sites", "txt", "json"),
  FLIPS("Lists of flips", "txt"),
  WISHES("Wished parities", "txt"),
  PICTURES("Pictures", FileEnding.extensions(Content.PICTURE)),
  DATA("Files of other programs", FileEnding.extensions(Content.POINTS, Content.TRIANGULATION)),
  STUDIES(
      "Rows, tables and charts",
      FileEnding.extensions(Content.ROWS, Content.TABLES, Content.CHART));

  /** Endings of the formats that documents are read from; any other file can be named, too. */
  private static final String[] READABLE = {
    "txt",
    "json",
    "csv",
    "tsv",
    "dat",
    "xyz",
    "bln",
    "wkt",
    "geojson",
    "ndjson",
    "geojsonl",
    "node",
    "poly",
    "ele",
    "edge",
    "off",
    "obj",
    "tsp",
    "svg",
    "ipe",
    "gz"
  };

  private final String filter;
  private final String extensions; // separated by blanks

  Chooser(String title, String... extensions) {
    filter = title + " (*." + String.join(", *.", extensions) + ")";
    this.extensions = String.join(" ", extensions);
  }

  /** Asks for a file to open. */
  public Optional<Path> open(Component parent, Optional<Path> folder) {
    return open(parent, folder, "Open");
  }

  /** Asks for a file to open; the title is that of the panel. */
  public Optional<Path> open(Component parent, Optional<Path> folder, String title) {
    JFileChooser chooser = panel(folder);
    chooser.setDialogTitle(title);
    if (this == DOCUMENTS) {
      chooser.setFileFilter(
          new FileNameExtensionFilter("Polygons, sites and triangulations", READABLE));
    }
    return chosen(chooser, chooser.showOpenDialog(parent));
  }

  /** Asks for a file to save to; the one suggested may be a bare name, the title as below. */
  public Optional<Path> save(Component parent, Path suggested, String title) {
    return ask(parent, suggested, title, chooser -> {});
  }

  /**
   * Asks for a file to write to; the one suggested may be a bare name.
   *
   * @param title what is done to it, for the panel's title and button
   * @param extend adds to the panel what else is to be asked
   */
  public Optional<Path> ask(
      Component parent, Path suggested, String title, Consumer<JFileChooser> extend) {
    JFileChooser chooser = panel(Optional.ofNullable(suggested.getParent()));
    chooser.setDialogTitle(title);
    extend.accept(chooser);
    chooser.setSelectedFile(
        suggested.isAbsolute()
            ? suggested.toFile()
            : new File(chooser.getCurrentDirectory(), suggested.toString()));
    chooser.setDialogType(JFileChooser.SAVE_DIALOG);
    chooser.setApproveButtonText(title.replaceFirst(" .*", ""));
    return chosen(chooser, chooser.showDialog(parent, null)); // a text would change the type
  }

  /** Asks whether a file may be replaced. */
  public static boolean confirmReplacing(Component parent, Path file) {
    return Ask.confirm(
        parent, "Replace File", file.getFileName() + " is there already. Replace it?", "Replace");
  }

  private JFileChooser panel(Optional<Path> folder) {
    Path begin = folder.or(this::last).or(DOCUMENTS::last).orElse(Path.of(""));
    JFileChooser chooser = new JFileChooser(begin.toAbsolutePath().toFile());
    chooser.setFileFilter(new FileNameExtensionFilter(filter, extensions.split(" ")));
    return chooser;
  }

  private Optional<Path> chosen(JFileChooser chooser, int answer) {
    if (answer != JFileChooser.APPROVE_OPTION) {
      return Optional.empty();
    }
    Path file = chooser.getSelectedFile().toPath();
    used(file);
    return Optional.of(file);
  }

  /** Says that a file of this kind is used, however it was named. */
  public void used(Path file) {
    Optional.ofNullable(file.toAbsolutePath().getParent())
        .ifPresent(folder -> Memory.put(memory(), folder));
  }

  /** The name under which the folder is kept. */
  private String memory() {
    return "folder." + name().toLowerCase(Locale.ROOT);
  }

  private Optional<Path> last() {
    try {
      return Memory.get(memory()).map(Path::of).filter(Files::isDirectory);
    } catch (InvalidPathException e) {
      return Optional.empty(); // no name of a folder on this system
    }
  }
}
