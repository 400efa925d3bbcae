package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.render.Figure;
import dct.render.PictureFile;
import java.awt.Image;
import java.awt.Toolkit;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;

/** What other programs paste, and what is pasted from them. */
class ClipboardWindowTest extends WindowTest {
  private static final double[] SQUARE = {100, 100, 300, 100, 300, 300, 100, 300};

  private static Clipboard clipboard() {
    return Toolkit.getDefaultToolkit().getSystemClipboard();
  }

  private static int[] pixels(Image image) {
    BufferedImage drawn = (BufferedImage) image;
    assertThat(drawn.getColorModel().hasAlpha()).isFalse();
    int width = drawn.getWidth();
    return drawn.getRGB(0, 0, width, drawn.getHeight(), null, 0, width);
  }

  @Test
  void aPictureIsCopiedAsExportPictureWritesIt() throws Exception {
    choose("Point Sites Based");
    check("Draw Vertex");
    clickAt(SQUARE);
    clickMenu("Edit");
    clickMenu("Copy Picture");
    await("the copy", () -> frame.label("status").text().startsWith("Copied a picture of 992 × "));
    Image copied = (Image) clipboard().getData(DataFlavor.imageFlavor);
    Image exported =
        onEventThread(() -> PictureFile.image(canvas().scene(), Figure.DEFAULT, Progress.NONE));
    assertThat(pixels(copied)).isEqualTo(pixels(exported));
    assertThat(List.of(clipboard().getAvailableDataFlavors()))
        .containsExactly(DataFlavor.imageFlavor);
    type(KeyEvent.VK_V, KeyEvent.VK_CONTROL);
    assertThat(frame.label("status").text()).startsWith("The clipboard holds no text");
  }

  @Test
  void theFormatsOfOtherProgramsArePasted() {
    choose("Polygon Based");
    for (String text :
        List.of(
            "100 100\n300 100\n300 300\n100 300\n",
            "x,y\n100,100\n300,100\n300,300\n100,300\n",
            "POLYGON ((100 100, 300 100, 300 300, 100 300, 100 100))",
            "{\"type\": \"Polygon\", \"coordinates\":"
                + " [[[100, 100], [300, 100], [300, 300], [100, 300], [100, 100]]]}",
            """
            <ipeselection pos="0 0">
            <path>
            100 -100 m
            300 -100 l
            300 -300 l
            100 -300 l
            h
            </path>
            </ipeselection>
            """)) {
      clipboard().setContents(new StringSelection(text), null);
      type(KeyEvent.VK_V, KeyEvent.VK_CONTROL);
      assertThat(points()).as(text).isEqualTo(Points.ofPairs(SQUARE));
      type(KeyEvent.VK_A, KeyEvent.VK_CONTROL);
      type(KeyEvent.VK_DELETE);
      assertThat(points().size()).isZero();
    }
  }

  @Test
  void whatIsCopiedInAnyFormatIsPastedAsItWas() {
    choose("Polygon Based");
    check("Draw Vertex");
    clickAt(SQUARE);
    for (String command : List.of("Copy", "Copy as WKT", "Copy as GeoJSON", "Copy for Ipe")) {
      type(KeyEvent.VK_A, KeyEvent.VK_CONTROL);
      clickMenu("Edit");
      clickMenu(command);
      type(KeyEvent.VK_DELETE);
      assertThat(points().size()).isZero();
      type(KeyEvent.VK_V, KeyEvent.VK_CONTROL);
      assertThat(points()).as(command).isEqualTo(Points.ofPairs(SQUARE));
    }
  }

  @Test
  void everyTableTellsHowManyRowsWereCopied() {
    choose("Point Sites Based");
    check("Draw Vertex");
    clickAt(100, 100, 300, 60, 500, 120, 560, 300, 800, 200, 900, 400, 850, 600, 600, 650);
    clickAt(450, 500, 200, 620, 80, 400);
    push("Perform Flip");
    copyRows("vertices", 1, 3);
    awaitStatus("Copied 3 rows");
    perform("Flips");
    perform("Last Flip");
    copyRows("flipList", 0, 0);
    awaitStatus("Copied 1 row");
    perform("Table of Results");
    copyRows("results", 0, 1);
    awaitStatus("Copied 2 rows");
    perform("Commands and Keys");
    copyRows("commands", 2, 2);
    awaitStatus("Copied 1 row");
  }

  /** Selects rows of a table and copies them by the table's key. */
  private void copyRows(String name, int first, int last) {
    JTable table = onEventThread(() -> robot.finder().findByName(name, JTable.class, false));
    onEventThread(
        () -> {
          table.setRowSelectionInterval(first, last);
          return null;
        });
    settle();
    onEventThread(
        () -> {
          KeyStroke key = KeyStroke.getKeyStroke(KeyEvent.VK_C, KeyEvent.CTRL_DOWN_MASK);
          Object copy = table.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).get(key);
          table.getActionMap().get(copy).actionPerformed(new ActionEvent(table, 0, ""));
          return null;
        });
  }

  private void awaitStatus(String words) {
    await(words, () -> words.equals(frame.label("status").text()));
  }

  private void perform(String command) {
    onEventThread(
        () -> {
          window.commands().get(command).perform();
          return null;
        });
    settle();
  }
}
