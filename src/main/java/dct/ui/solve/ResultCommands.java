package dct.ui.solve;

import dct.io.format.Drawing;
import dct.ui.command.CommandMenu.Plan;
import dct.ui.document.Result;
import dct.ui.explain.Explainer;
import dct.ui.file.DataExport;
import dct.ui.file.FileCommands;
import dct.ui.file.FileWork;
import dct.ui.file.PictureExport;
import dct.ui.file.Saving;
import dct.ui.help.HelpCommands;
import dct.ui.job.Jobs;
import dct.ui.menu.MenuTable;
import dct.ui.menu.ViewCommands;
import dct.ui.result.ResultView;
import java.awt.Frame;
import java.awt.Window;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.SwingUtilities;

/** The commands of a view of a result. */
public final class ResultCommands {

  private ResultCommands() {}

  /**
   * Offers the commands of a view.
   *
   * @param jobs write pictures in the background
   * @param said is told what was written or copied
   * @param frames which no explanation may cover
   */
  static void offer(
      ResultView view, Jobs jobs, Consumer<String> said, Supplier<List<? extends Window>> frames) {
    view.commands()
        .add("Export Picture", "ctrl E", FileCommands.pictures(), () -> export(view, jobs, said));
    view.commands()
        .add("Export Data", "", DataExport.description(), () -> exportData(view, jobs, said))
        .enabledWhen(() -> view.result().isPresent());
    view.commands().add("Close", "ctrl W", "Closes this view", view::close);
    ViewCommands.offer(view.commands(), view.canvas());
    Explainer explainer =
        new Explainer(view.canvas(), jobs, () -> view.result().map(Result::solution), frames);
    explainer.offer(view.commands());
    HelpCommands.offerSearch(
        view.commands(), menus(view), () -> (Frame) SwingUtilities.getWindowAncestor(view), said);
    view.addListener(explainer::refresh);
  }

  /** The menus of a frame that shows a view; what is no result of a document cannot be flipped. */
  static List<Plan> menus(ResultView view) {
    return view.result().isPresent() ? MenuTable.RESULT : MenuTable.PICTURE;
  }

  /**
   * Offers what saves the result of a view.
   *
   * @param said is told what was saved
   */
  static void offerSaving(ResultView view, FileWork files, Consumer<String> said) {
    Saving.Asked by = new Saving.Asked(view, said);
    view.commands()
        .add(
            "Save",
            "ctrl S",
            "Saves the drawing with this result; asks for a file if it has none that keeps both",
            () -> view.result().ifPresent(r -> files.save(by, r, view.document())))
        .enabledWhen(() -> view.result().isPresent());
    view.commands()
        .add(
            "Save As",
            "ctrl shift S",
            "Saves the drawing with this result under a new name or replaces a file",
            () -> view.result().ifPresent(r -> files.saveAs(by, r, view.document())))
        .enabledWhen(() -> view.result().isPresent());
  }

  private static void export(ResultView view, Jobs jobs, Consumer<String> said) {
    PictureExport.ask(view, view.canvas(), fileName(view), jobs, said);
  }

  private static void exportData(ResultView view, Jobs jobs, Consumer<String> said) {
    view.result()
        .map(result -> Drawing.of(result.solution()))
        .ifPresent(drawing -> DataExport.ask(view, drawing, fileName(view), jobs, said));
  }

  private static String fileName(ResultView view) {
    return PictureExport.fileName(view.document()) + " " + view.method();
  }
}
