package dct.ui.study;

import dct.experiment.study.StudyExport;
import dct.experiment.study.StudyPicture;
import dct.ui.canvas.CanvasPanel;
import dct.ui.canvas.Links;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Chooser;
import dct.ui.dialog.Failures;
import dct.ui.dialog.Placement;
import dct.ui.result.ResultView;
import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JFrame;

/**
 * The commands of the menu Study: a dialog for each study, and frames for the pictures of its rows.
 */
public final class StudyWork implements StudyHost {
  private final JFrame owner;
  private final CanvasPanel canvas;
  private final Links links;
  private final Consumer<List<ResultView>> opener;
  private final Map<StudyKind, StudyDialog> dialogs = new EnumMap<>(StudyKind.class);

  /**
   * Studies of a window.
   *
   * @param canvas the one whose labels the pictures show
   * @param links between views of the same points
   * @param opener shows views that belong together
   */
  public StudyWork(
      JFrame owner, CanvasPanel canvas, Links links, Consumer<List<ResultView>> opener) {
    this.owner = owner;
    this.canvas = canvas;
    this.links = links;
    this.opener = opener;
  }

  /** Offers a command for each study. */
  public void offer(CommandRegistry commands) {
    for (StudyKind kind : StudyKind.values()) {
      commands.add(kind.title() + "…", "", kind.description(), () -> open(kind));
    }
  }

  private void open(StudyKind kind) {
    StudyDialog dialog = dialogs.computeIfAbsent(kind, this::dialog);
    dialog.setVisible(true);
    dialog.toFront();
  }

  /** A dialog that is no larger than the screen. */
  private StudyDialog dialog(StudyKind kind) {
    StudyDialog dialog = new StudyDialog(owner, kind, this);
    Placement.centre(dialog);
    return dialog;
  }

  @Override
  public void show(Component over, String name, List<StudyPicture> pictures) {
    opener.accept(pictures.stream().map(picture -> view(picture, name)).toList());
  }

  private ResultView view(StudyPicture picture, String name) {
    return new ResultView(picture.method(), name, picture.scene(), canvas.labels(), links);
  }

  @Override
  public Optional<Path> askFile(Component over, String suggested) {
    return Chooser.STUDIES
        .save(over, Path.of(suggested), "Export Study")
        .map(typed -> withEnding(typed, suggested))
        .filter(file -> !Files.exists(file) || Chooser.confirmReplacing(over, file));
  }

  private static Path withEnding(Path typed, String suggested) {
    boolean said = StudyExport.ending(typed.toString()).isPresent();
    String ending = suggested.substring(suggested.lastIndexOf('.'));
    return said ? typed : typed.resolveSibling(typed.getFileName() + ending);
  }

  @Override
  public void sorry(Component over, String title, String sentence) {
    Ask.sorry(over, title, sentence);
  }

  @Override
  public void failed(Component over, String what, Throwable cause) {
    new Failures(over, List.of()).show(what, cause);
  }

  /** Ends all studies and closes their dialogs. */
  public void dispose() {
    dialogs.values().forEach(StudyDialog::dispose);
  }
}
