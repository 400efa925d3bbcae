package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.PointFile;
import java.awt.Component;
import java.awt.Frame;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.TransferHandler;
import javax.swing.TransferHandler.TransferSupport;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** Files dropped on a window. */
class FileDropWindowTest extends WindowTest {
  private static final Points TRIANGLE = Points.ofPairs(100, 100, 500, 100, 300, 400);

  /** Not removed: a window that closes may still write its settings there. */
  @TempDir(cleanup = CleanupMode.NEVER)
  Path folder;

  private Path one;
  private Path bad;
  private Path two;

  @BeforeEach
  void writeFiles() throws Exception {
    one = folder.resolve("one_polygonbased.txt");
    bad = Files.writeString(folder.resolve("bad.txt"), "0 0\nno point\n");
    two = folder.resolve("two_pointbased.txt");
    PointFile.write(one, Domain.POLYGON, TRIANGLE, Progress.NONE);
    PointFile.write(two, Domain.SITES, TRIANGLE, Progress.NONE);
  }

  private static List<MainWindow> windows() {
    return onEventThread(
        () ->
            Arrays.stream(Frame.getFrames())
                .filter(f -> f instanceof MainWindow && f.isShowing())
                .map(MainWindow.class::cast)
                .toList());
  }

  private static boolean isOpen(String title) {
    return windows().stream().anyMatch(w -> w.getTitle().startsWith(title));
  }

  /** What gets the drops at a component: the innermost around it that has a target for them. */
  private static TransferHandler handlerAt(Component component) {
    Component target = component;
    while (target.getDropTarget() == null) {
      target = target.getParent();
    }
    return target instanceof JFrame frame
        ? frame.getTransferHandler()
        : ((JComponent) target).getTransferHandler();
  }

  private void drop(Component place, Path... paths) {
    List<File> files = Arrays.stream(paths).map(Path::toFile).toList();
    TransferHandler handler = onEventThread(() -> handlerAt(place));
    TransferSupport dropped = new TransferSupport(place, new Dropped(files));
    assertThat(onEventThread(() -> handler.canImport(dropped))).isTrue();
    SwingUtilities.invokeLater(() -> handler.importData(dropped));
  }

  @Test
  void severalFilesOpenInWindowsOfTheirOwn() {
    drop(canvas(), one, two);
    await("both files", () -> isOpen("one_") && isOpen("two_"));
    assertThat(windows()).hasSize(2);
  }

  @Test
  void aFileThatCannotBeReadKeepsNoOtherBackAndLeavesNoEmptyWindow() {
    drop(canvas(), one, bad, two);
    assertThat(message(dialog())).startsWith("bad.txt, line 2: ");
    answer(dialog(), "OK");
    await("both files", () -> isOpen("one_") && isOpen("two_"));
    await("no empty window", () -> windows().size() == 2);
  }

  @Test
  void theFirstWindowStaysIfItsFileCannotBeRead() {
    drop(canvas(), bad);
    assertThat(message(dialog())).startsWith("bad.txt, line 2: ");
    answer(dialog(), "OK");
    settle();
    assertThat(windows()).containsExactly(window);
  }

  @Test
  void aFileDroppedOnTheCoordinatesOpensAlsoInAnotherLook() {
    choose("Polygon Based");
    Component coordinates = frame.textBox("coordinates").target();
    drop(coordinates, one);
    await("the file is open", () -> isOpen("one_"));
    onEventThread(
        () -> {
          SwingUtilities.updateComponentTreeUI(window);
          return null;
        });
    drop(coordinates, two);
    await("the other file is open", () -> isOpen("two_"));
  }

  @Test
  void aFileDroppedOnTheVerticesOpens() {
    choose("Polygon Based");
    frame.tabbedPane("tabs").selectTab("Vertices");
    drop(frame.table("vertices").target(), one);
    await("the file is open", () -> isOpen("one_"));
  }

  @Test
  void textDroppedOnTheCoordinatesOpensNothing() {
    choose("Polygon Based");
    Component coordinates = frame.textBox("coordinates").target();
    TransferHandler handler = onEventThread(() -> handlerAt(coordinates));
    TransferSupport text = new TransferSupport(coordinates, new StringSelection("0 0"));
    assertThat(onEventThread(() -> handler.canImport(text))).isFalse();
  }

  /** What a file manager drops. */
  private record Dropped(List<File> files) implements Transferable {
    @Override
    public DataFlavor[] getTransferDataFlavors() {
      return new DataFlavor[] {DataFlavor.javaFileListFlavor};
    }

    @Override
    public boolean isDataFlavorSupported(DataFlavor flavor) {
      return DataFlavor.javaFileListFlavor.equals(flavor);
    }

    @Override
    public Object getTransferData(DataFlavor flavor) {
      return files;
    }
  }
}
