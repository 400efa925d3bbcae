package dct.ui.file;

import dct.core.Progress;
import dct.io.CannotWriteException;
import dct.io.DataFile;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.io.format.Drawing;
import dct.ui.dialog.Chooser;
import dct.ui.dialog.Memory;
import dct.ui.job.Jobs;
import java.awt.Component;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;

/** Writes points and triangulation to a file of another program that the user names. */
public final class DataExport {
  private static final String TITLE = "Export Data";
  private static final String MEMORY = "data.format";

  private final Component parent;
  private final Drawing drawing;
  private final List<FileEnding> endings;
  private FileEnding chosen = FileEnding.WKT; // where the name typed has no ending

  private DataExport(Component parent, Drawing drawing) {
    this.parent = parent;
    this.drawing = drawing;
    boolean all = drawing.triangulation().isPresent();
    endings =
        DataFile.endings().stream().filter(ending -> all || ending.holds(Content.POINTS)).toList();
  }

  /** What Export Data does. */
  public static String description() {
    return "Writes vertices and triangulation for other programs: "
        + String.join(", ", DataFile.endings().stream().map(FileEnding::dotted).toList());
  }

  /**
   * Asks for the file and writes it in the background.
   *
   * @param drawing what is written, as far as the format holds it
   * @param name suggested for the file
   * @param said is told what was written
   */
  public static void ask(
      Component parent, Drawing drawing, String name, Jobs jobs, Consumer<String> said) {
    new DataExport(parent, drawing).ask(name, jobs, said);
  }

  private void ask(String name, Jobs jobs, Consumer<String> said) {
    String plain = PictureExport.fileName(name);
    Chooser.DATA
        .ask(parent, Path.of(plain.isEmpty() ? "untitled" : plain), TITLE, this::offerFormats)
        .map(this::named)
        .filter(file -> files(file).stream().allMatch(this::isFree))
        .ifPresent(file -> write(file, jobs, said));
  }

  private boolean isFree(Path file) {
    return !Files.exists(file) || Chooser.confirmReplacing(parent, file);
  }

  /** One entry for each format; the one used last is chosen. */
  private void offerFormats(JFileChooser chooser) {
    chooser.resetChoosableFileFilters();
    chooser.setAcceptAllFileFilterUsed(false);
    List<FileFilter> filters = new ArrayList<>();
    for (FileEnding ending : endings) {
      String extension = ending.dotted().substring(ending.dotted().lastIndexOf('.') + 1);
      String words = DataFile.title(ending) + " (*" + ending.dotted() + ")";
      filters.add(new FileNameExtensionFilter(words, extension));
    }
    filters.forEach(chooser::addChoosableFileFilter);
    chooser.addPropertyChangeListener(
        JFileChooser.FILE_FILTER_CHANGED_PROPERTY,
        e -> chosen = endings.get(Math.max(0, filters.indexOf(chooser.getFileFilter()))));
    int last =
        endings.stream()
            .map(FileEnding::dotted)
            .toList()
            .indexOf(Memory.get(MEMORY).orElse(FileEnding.WKT.dotted()));
    chooser.setFileFilter(filters.get(Math.max(0, last)));
  }

  /** The name that was typed, with an ending that says the format. */
  private Path named(Path typed) {
    boolean said = FileEnding.of(typed, Content.values()).filter(endings::contains).isPresent();
    Path file = said ? typed : withEnding(typed);
    Memory.put(MEMORY, ending(file).dotted());
    return file;
  }

  /** The last part of an ending need not be typed in full: of {@code .instance.json}, .json. */
  private Path withEnding(Path typed) {
    String last = chosen.dotted().substring(chosen.dotted().lastIndexOf('.'));
    return typed.toString().endsWith(last)
        ? chosen.insteadOf(typed)
        : typed.resolveSibling(typed.getFileName() + chosen.dotted());
  }

  private static FileEnding ending(Path file) {
    return FileEnding.require(file, Content.values());
  }

  private static List<Path> files(Path file) {
    return DataFile.files(file, ending(file));
  }

  private void write(Path file, Jobs jobs, Consumer<String> said) {
    FileEnding ending = ending(file);
    jobs.write(
        "Exporting " + file.getFileName(),
        progress -> written(file, ending, progress),
        files -> said.accept(words(files, ending)));
  }

  private List<Path> written(Path file, FileEnding ending, Progress progress) {
    try {
      return DataFile.write(file, ending, drawing, progress);
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }

  private String words(List<Path> files, FileEnding ending) {
    Optional<String> left =
        Optional.of("; it holds the points alone")
            .filter(words -> drawing.triangulation().isPresent())
            .filter(words -> !ending.holds(Content.TRIANGULATION));
    String beside = files.size() > 1 ? ", and its vertices in " + files.get(1).getFileName() : "";
    return "Exported " + files.get(0) + beside + left.orElse("");
  }
}
