package dct.ui;

import dct.ui.dialog.Ask;
import dct.ui.dialog.Memory;
import dct.ui.dialog.Placement;
import dct.ui.file.WindowHost;
import dct.ui.session.Orphan;
import dct.ui.session.Session;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
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
    Memory.keepIn(session.settings());
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
    files.forEach(file -> openWindow().openOrClose(file));
  }

  @Override
  public void exit(JFrame from) {
    List<MainWindow> all = new ArrayList<>(open);
    all.sort(Comparator.comparing(window -> window != from)); // the others as they were opened
    if (all.size() == 1) {
      all.get(0).exit();
    } else {
      List<MainWindow> asked = all.stream().filter(MainWindow::hasSomethingToLose).toList();
      boolean agreed = !asked.isEmpty() || confirms(from, all.size());
      if (agreed) {
        askAll(asked, () -> all.forEach(MainWindow::closeForGood));
      }
    }
  }

  private static boolean confirms(JFrame from, int count) {
    String question = "Close the application with its " + count + " windows?";
    return Ask.confirm(from, "Exit", question, "Exit");
  }

  /** Asks one window after the other; then follows only if none was answered with Cancel. */
  private static void askAll(List<MainWindow> windows, Runnable then) {
    if (windows.isEmpty()) {
      then.run();
    } else {
      MainWindow first = windows.get(0);
      first.toFront();
      first.agree(() -> askAll(windows.subList(1, windows.size()), then));
    }
  }

  @Override
  public boolean isLast(JFrame window) {
    return open.stream().allMatch(window::equals);
  }

  /**
   * Offers to bring back drawings that were not saved when the program was killed.
   *
   * @param unread sentences that say which of them cannot be read
   */
  void offer(List<Orphan> orphans, List<String> unread) {
    for (Orphan orphan : orphans) {
      Recovery.ask(open.isEmpty() ? null : open.get(0), orphan, this::windowFor);
    }
    open.stream().limit(1).forEach(window -> unread.forEach(window::say));
  }

  private MainWindow windowFor(Orphan orphan) {
    return open.stream()
        .filter(window -> window.isFree(orphan.document().domain()))
        .findFirst()
        .orElseGet(this::openWindow);
  }
}
