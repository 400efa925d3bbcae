package dct.ui;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.degree.Mark;
import dct.core.geometry.Points;
import dct.ui.dialog.Placement;
import dct.ui.menu.CommandWindow;
import dct.ui.solve.ResultFrame;
import java.awt.Dialog;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import javax.swing.JTextArea;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;

/** Why? and Verify Result, of sites in the canvas and of a polygon's result. */
class ExplainWindowTest extends WindowTest {
  private static final double[] PENTAGON = {100, 100, 500, 80, 620, 300, 350, 520, 90, 350};

  @Test
  void whyExplainsTheBoundOfSitesAndMarksItOnTheCanvas() {
    draw("Point Sites Based");
    perform(window, "Most Even Vertices");
    perform(window, "Why?");
    assertThat(text("why")).contains("5");
    List<Mark> marks = onEventThread(() -> canvas().marks());
    assertThat(marks).filteredOn(Mark.Vertex.class::isInstance).hasSizeGreaterThanOrEqualTo(5);
    robot.pressAndReleaseKeys(KeyEvent.VK_ESCAPE);
    await("the marks are gone", () -> onEventThread(() -> canvas().marks().isEmpty()));
  }

  @Test
  void theTextCoversNoVertexOfThePicture() {
    choose("Point Sites Based");
    check("Draw Vertex");
    clickAt(40, 60, 980, 80, 960, 350, 985, 660, 500, 640, 60, 650, 400, 300);
    perform(window, "Why?");
    text("why");
    Rectangle on =
        onEventThread(
            () -> {
              Rectangle bounds = dialogs("why").get(0).getBounds();
              Point corner = canvas().getLocationOnScreen();
              bounds.translate(-corner.x, -corner.y);
              return bounds;
            });
    Points points = points();
    for (int v = 0; v < points.size(); v++) {
      assertThat(on.contains(at(canvas(), points.x(v), points.y(v)))).as("v" + v).isFalse();
    }
  }

  @Test
  void theHeadingIsWrappedWhereTheDialogIsNarrow() {
    draw("Point Sites Based");
    perform(window, "Why?");
    text("why");
    Dialog why = dialogs("why").get(0);
    JTextComponent heading =
        onEventThread(() -> robot.finder().findByName(why, "heading", JTextComponent.class));
    onEventThread(
        () -> {
          why.setSize(200, why.getHeight());
          why.validate();
          return null;
        });
    await(
        "all of the heading is in the dialog",
        () ->
            onEventThread(
                () -> {
                  Rectangle2D end = heading.modelToView2D(heading.getDocument().getLength());
                  return heading.getWidth() <= 200
                      && end.getMaxX() <= heading.getWidth()
                      && end.getMinY() > end.getHeight()
                      && end.getMaxY() <= heading.getHeight();
                }));
  }

  @Test
  void noFormulaIsBrokenWhereTheTextIsWrapped() {
    draw("Point Sites Based");
    perform(window, "Most Even Vertices");
    perform(window, "Why?");
    assertThat(text("why")).contains("3\u00a0×\u00a0black");
    JTextArea area =
        onEventThread(
            () -> robot.finder().findByName(dialogs("why").get(0), "whyText", JTextArea.class));
    int formula = area.getText().indexOf("3\u00a0×");
    int end = area.getText().indexOf(":", formula);
    for (int width = 240; width <= 460; width += 20) {
      int wide = width;
      assertThat(onEventThread(() -> isOnOneLine(area, wide, formula, end)))
          .as("at a width of " + wide)
          .isTrue();
    }
  }

  private static boolean isOnOneLine(JTextArea area, int width, int from, int to)
      throws BadLocationException {
    area.setSize(width, area.getHeight());
    return area.modelToView2D(from).getMinY() == area.modelToView2D(to).getMinY();
  }

  @Test
  void anEditTakesTheExplanationAway() {
    draw("Point Sites Based");
    perform(window, "Most Even Vertices");
    perform(window, "Why?");
    assertThat(onEventThread(() -> canvas().marks())).isNotEmpty();
    perform(window, "Undo");
    await("the marks are gone", () -> onEventThread(() -> canvas().marks().isEmpty()));
    assertThat(dialogs("why")).isEmpty();
  }

  @Test
  void aResultIsVerifiedFromItsPointsAndEdges() {
    draw("Polygon Based");
    ResultFrame frame = pushForResult("Perform Flip");
    perform(frame, "Verify Result");
    assertThat(text("verdict")).contains("✓").doesNotContain("✗").contains("read back");
    perform(frame, "Why?");
    assertThat(onEventThread(() -> frame.canvas().marks())).isNotEmpty();
  }

  @Test
  void theTextCoversNoFrameOfAResult() {
    draw("Polygon Based");
    ResultFrame left = pushForResult("Monotone Polygon Triangulation");
    perform(window, "Convex Polygon Odd Triangulation");
    await("the frames", () -> results().size() == 2);
    ResultFrame right = (ResultFrame) results().get(results().get(0) == left ? 1 : 0);
    onEventThread(
        () -> {
          Rectangle screen = Placement.usable(window);
          int half = (screen.width - 120) / 2; // a strip is left that is too narrow for any text
          left.setBounds(screen.x, screen.y, half, screen.height);
          right.setBounds(screen.x + half, screen.y, half, screen.height);
          return null;
        });
    settle();
    perform(right, "Why?");
    text("why");
    Dialog why = dialogs("why").get(0);
    await(
        "nothing is covered",
        () ->
            onEventThread(
                () ->
                    !why.getBounds().intersects(left.getBounds())
                        && !why.getBounds().intersects(right.getBounds())
                        && !left.getBounds().intersects(right.getBounds())));
  }

  private void draw(String application) {
    choose(application);
    check("Draw Vertex");
    clickAt(PENTAGON);
  }

  private void perform(CommandWindow of, String command) {
    onEventThread(
        () -> {
          of.commands().get(command).perform();
          return null;
        });
    settle();
  }

  private String text(String name) {
    await("the dialog", () -> dialogs(name).size() == 1);
    return onEventThread(
        () ->
            robot
                .finder()
                .findByName(dialogs(name).get(0), name + "Text", JTextArea.class)
                .getText());
  }

  private static List<Dialog> dialogs(String name) {
    return Arrays.stream(Window.getWindows())
        .filter(w -> w instanceof Dialog && w.isShowing() && name.equals(w.getName()))
        .map(Dialog.class::cast)
        .toList();
  }
}
