package dct.ui;

import dct.ui.dialog.Placement;
import dct.ui.file.WindowHost;
import dct.ui.session.Orphan;
import dct.ui.session.Session;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;

/** The main windows of the program. Lives on the event thread. */
public final class Windows implements WindowHost {
  private final Session session;
  private final List<MainWindow> open = new ArrayList<>(); // in the order opened

  /** No window yet. */
  public Windows(Session session) {
    this.session = session;
  }

  /** Opens an empty window, a little lower and further right than the one opened before. */
  public MainWindow openWindow() {
    MainWindow window = new MainWindow(session, this);
    Optional<MainWindow> before =
        open.isEmpty() ? Optional.empty() : Optional.of(open.get(open.size() - 1));
    before.ifPresentOrElse(
        other -> Placement.below(window, other),
        () -> Placement.restore(window, session.settings()));
    open.add(window);
    window.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent e) {
            open.remove(window);
          }
        });
    window.setVisible(true);
    return window;
  }

  @Override
  public void openEmpty() {
    openWindow();
  }

  @Override
  public void open(List<Path> files) {
    files.forEach(file -> openWindow().open(file));
  }

  @Override
  public boolean isLast(JFrame window) {
    return open.stream().allMatch(window::equals);
  }

  /** Offers to bring back drawings that were not saved when the program was killed. */
  void offer(List<Orphan> orphans) {
    for (Orphan orphan : orphans) {
      Recovery.ask(open.isEmpty() ? null : open.get(0), orphan, this::windowFor);
    }
  }

  private MainWindow windowFor(Orphan orphan) {
    return open.stream()
        .filter(window -> window.isFree(orphan.document().domain()))
        .findFirst()
        .orElseGet(this::openWindow);
  }
}
