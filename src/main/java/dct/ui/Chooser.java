package dct.ui;

import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;

/** The file panels. Each kind begins in the folder where it was last. */
enum Chooser {
  DOCUMENTS("Polygons and sites", FileEnding.TXT.dotted().substring(1)),
  WISHES("Wished parities", FileEnding.TXT.dotted().substring(1)),
  PICTURES("Pictures", FileEnding.extensions(Content.PICTURE)),
  STUDIES(
      "Rows, tables and charts",
      FileEnding.extensions(Content.ROWS, Content.TABLES, Content.CHART));

  private final String filter;
  private final String extensions; // separated by blanks

  Chooser(String title, String... extensions) {
    filter = title + " (*." + String.join(", *.", extensions) + ")";
    this.extensions = String.join(" ", extensions);
  }

  /** Asks for a file to open. */
  Optional<Path> open(Component parent, Optional<Path> folder) {
    JFileChooser chooser = panel(folder);
    return chosen(chooser, chooser.showOpenDialog(parent));
  }

  /** Asks for a file to save to; the one suggested may be a bare name. */
  Optional<Path> save(Component parent, Path suggested) {
    JFileChooser chooser = panel(Optional.ofNullable(suggested.getParent()));
    chooser.setSelectedFile(
        suggested.isAbsolute()
            ? suggested.toFile()
            : new File(chooser.getCurrentDirectory(), suggested.toString()));
    return chosen(chooser, chooser.showSaveDialog(parent));
  }

  /** Asks whether a file may be replaced. */
  static boolean confirmReplacing(Component parent, Path file) {
    return Ask.confirm(
        parent, "Replace File", file.getFileName() + " is there already. Replace it?", "Replace");
  }

  private JFileChooser panel(Optional<Path> folder) {
    JFileChooser chooser = new JFileChooser(folder.map(Path::toFile).orElse(new File(".")));
    chooser.setFileFilter(new FileNameExtensionFilter(filter, extensions.split(" ")));
    return chooser;
  }

  private static Optional<Path> chosen(JFileChooser chooser, int answer) {
    return answer == JFileChooser.APPROVE_OPTION
        ? Optional.of(chooser.getSelectedFile().toPath())
        : Optional.empty();
  }
}
