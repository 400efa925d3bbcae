package dct.ui;

import java.awt.Component;
import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;

/** The file panels. Each kind begins in the folder where it was last. */
enum Chooser {
  DOCUMENTS("Polygons and sites", "txt"),
  WISHES("Wished parities", "txt"),
  PICTURES("Pictures", "png svg pdf ipe tex"),
  STUDIES("Rows, tables and charts", "csv md tex svg png pdf");

  private final String filter;
  private final String endings; // separated by blanks

  Chooser(String title, String endings) {
    filter = title + " (*." + endings.replace(" ", ", *.") + ")";
    this.endings = endings;
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
    chooser.setFileFilter(new FileNameExtensionFilter(filter, endings.split(" ")));
    return chooser;
  }

  private static Optional<Path> chosen(JFileChooser chooser, int answer) {
    return answer == JFileChooser.APPROVE_OPTION
        ? Optional.of(chooser.getSelectedFile().toPath())
        : Optional.empty();
  }
}
