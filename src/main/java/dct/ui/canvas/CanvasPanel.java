package dct.ui.canvas;

import com.formdev.flatlaf.FlatLaf;
import dct.core.degree.Mark;
import dct.core.geometry.Box;
import dct.core.geometry.Points;
import dct.render.GraphicsPen;
import dct.render.Labels;
import dct.render.MarkPainter;
import dct.render.Notes;
import dct.render.Pen;
import dct.render.Scene;
import dct.render.Theme;
import dct.render.Viewport;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GridBagLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.accessibility.AccessibleContext;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;

/**
 * Shows a scene through a viewport, and over it what a tool draws and where the mouse is. It knows
 * nothing of documents.
 */
public final class CanvasPanel extends JPanel implements Navigation.Target {
  /** The width at first: that of the thesis's canvas. */
  public static final int WIDTH_AT_FIRST = 1000;

  /** The height at first. */
  public static final int HEIGHT_AT_FIRST = 700;

  private final transient SceneImage image = new SceneImage(this::repaint);
  private final transient FocusRing ring = new FocusRing(this);
  private final transient List<Runnable> viewListeners = new ArrayList<>();
  private transient Scene given = Scene.sites(Points.ofPairs());
  private transient Scene scene = given; // with the labels
  private transient Scene picture = given; // without those that are written with the marks
  private transient Viewport viewport = Viewport.IDENTITY;
  private final transient List<Consumer<Pen>> overlays = new ArrayList<>();
  private Labels labels = Labels.NONE;
  private transient List<Mark> marks = List.of();
  private String remark = "";
  private String corner = "";
  private transient Notes notes = Notes.at(false);
  private transient View noted; // the picture that the notes were placed in; null before the first
  private transient Consumer<String> aside = words -> {};
  private String told = ""; // aside
  private double grid; // its size, or 0

  /** An empty canvas in actual size. */
  public CanvasPanel() {
    setName("canvas");
    setOpaque(true);
    setFocusable(true);
    setLayout(new GridBagLayout());
    setPreferredSize(new Dimension(WIDTH_AT_FIRST, HEIGHT_AT_FIRST));
    getAccessibleContext().setAccessibleName("Canvas");
    new Navigation(this, this);
  }

  /** Says how what is shown is put into words, for a screen reader; it is asked only by one. */
  public void setDescription(Supplier<String> words) {
    access().setWords(words);
  }

  @Override
  public AccessibleContext getAccessibleContext() {
    return access();
  }

  private CanvasAccess access() {
    if (accessibleContext == null) {
      accessibleContext = new CanvasAccess(this);
    }
    return (CanvasAccess) accessibleContext;
  }

  /** Shows another scene, in the same viewport. */
  public void setScene(Scene scene) {
    if (scene != given) { // an equal one need not be drawn anew
      given = scene;
      take();
      access().changed();
    }
    repaint();
  }

  private void take() {
    scene = given.withLabels(labels).withRemark(remark);
    picture = marks.isEmpty() ? scene : scene.withoutLabels();
  }

  /** What is shown. */
  public Scene scene() {
    return scene;
  }

  /** Chooses what is written beside the vertices. */
  public void setLabels(Labels labels) {
    this.labels = labels;
    take();
    repaint();
  }

  /** Writes a remark behind the counts; none if it is empty. */
  public void setRemark(String words) {
    if (!words.equals(remark)) {
      remark = words;
      take();
      access().changed();
      repaint();
    }
  }

  /** What is written beside the vertices. */
  public Labels labels() {
    return labels;
  }

  /** Where the model is on the screen. */
  public Viewport viewport() {
    return viewport;
  }

  /** Shows another part of the model. */
  public void setViewport(Viewport viewport) {
    this.viewport = viewport;
    repaint();
    viewListeners.forEach(Runnable::run);
  }

  /** Calls the listener after each change of the viewport. */
  public void addViewListener(Runnable listener) {
    viewListeners.add(listener);
  }

  /** Draws something over the scene with each repaint, and over what was added before. */
  public void addOverlay(Consumer<Pen> overlay) {
    overlays.add(overlay);
  }

  /** Marks that are drawn over the scene, below what a tool draws, until others are given. */
  public void setMarks(List<Mark> marks) {
    this.marks = List.copyOf(marks);
    take();
    repaint();
  }

  /** The marks that are drawn over the scene. */
  public List<Mark> marks() {
    return marks;
  }

  /** Draws a soft grid of this size, in units of the model; none if it is 0. */
  public void setGrid(double size) {
    if (size != grid) {
      grid = size;
      repaint();
    }
  }

  /** Writes the mouse's coordinates in the upper left corner. */
  public void setCorner(String text) {
    if (!text.equals(corner)) {
      corner = text;
      repaint();
    }
  }

  /** What is written in the upper left corner. */
  public String corner() {
    return corner;
  }

  /** Shows or hides the legend. */
  public void setLegend(boolean shown) {
    boolean all = isAllInSight();
    notes = notes.withLegend(shown);
    noted = null;
    if (shown && all && !haveNotesRoom(viewport)) {
      fit();
    }
    repaint();
  }

  /** Whether the legend is shown. */
  public boolean hasLegend() {
    return notes.legend();
  }

  /** What is written in the corners, and in which, as it was painted last. */
  public Notes notes() {
    return notes;
  }

  /**
   * Says who shows the words that have no room on the canvas beside the vertices; is told of
   * changes, of no words if all have room again.
   */
  public void setAside(Consumer<String> listener) {
    aside = listener;
  }

  /** Puts a component into the middle: what to do with a canvas that shows nothing. */
  public void setInvitation(JComponent invitation) {
    add(invitation);
  }

  /** Shows the whole scene as large as it fits. */
  public void fit() {
    notes = Notes.at(notes.legend());
    setViewport(fitted(scene, viewport.yUp()));
  }

  /** The viewport that shows a whole scene as large as it fits here beside its notes. */
  Viewport fitted(Scene whole, boolean yUp) {
    return notes.fittedForFlips(whole, getWidth(), getHeight(), yUp);
  }

  private boolean haveNotesRoom(Viewport view) {
    Box screen = new Box(0, 0, getWidth(), getHeight());
    return Notes.at(notes.legend()).haveRoom(scene, view, screen);
  }

  /** One model unit a pixel, the origin in the corner: the thesis's canvas. */
  public void showActualSize() {
    setViewport(
        viewport.yUp()
            ? Viewport.IDENTITY.panned(0, getHeight() - 1.0).flipped(0, getHeight() - 1.0)
            : Viewport.IDENTITY);
  }

  /**
   * Shows the scene in actual size if all of it is in sight then, not too small to see and not in
   * the way of the notes, and fitted otherwise.
   */
  public void showWell() {
    Box canvas = new Box(0, 0, getWidth() - 1.0, getHeight() - 1.0);
    boolean suits =
        !viewport.yUp()
            && scene.bounds().map(canvas::suits).orElse(true)
            && haveNotesRoom(Viewport.IDENTITY);
    if (suits) {
      showActualSize();
    } else {
      fit();
    }
  }

  /** Whether no part of the scene is out of sight. */
  public boolean isAllInSight() {
    return isAllInSight(getSize());
  }

  /** Whether none would be if the canvas had this size. */
  boolean isAllInSight(Dimension size) {
    Box canvas = new Box(0, 0, size.width, size.height);
    return scene
        .bounds()
        .filter(
            box ->
                !canvas.holds(viewport.screenX(box.minX()), viewport.screenY(box.minY()))
                    || !canvas.holds(viewport.screenX(box.maxX()), viewport.screenY(box.maxY())))
        .isEmpty();
  }

  /** Whether some of the scene is in sight, or there is nothing to see. */
  public boolean isAnyInSight() {
    Box canvas = new Box(0, 0, getWidth(), getHeight());
    return scene
        .bounds()
        .map(
            box ->
                canvas.mayMeet(
                    viewport.screenX(box.minX()),
                    viewport.screenY(box.minY()),
                    viewport.screenX(box.maxX()),
                    viewport.screenY(box.maxY())))
        .orElse(true);
  }

  @Override
  public void pan(double dx, double dy) {
    setViewport(viewport.panned(dx, dy));
  }

  @Override
  public void zoom(double factor, double x, double y) {
    setViewport(viewport.zoomed(factor, x, y));
  }

  /** The look of the canvas: that of the window. */
  public Theme theme() {
    return FlatLaf.isLafDark() ? Theme.DARK : Theme.LIGHT;
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D graphics = (Graphics2D) g.create();
    View view = new View(picture, viewport, theme(), getSize(), scaleOf(graphics));
    Box screen = new Box(0, 0, getWidth(), getHeight());
    image.paint(graphics, view);
    if (!view.equals(noted) && scene.isAtHand()) {
      notes = notes.placed(scene, viewport, screen);
      noted = view;
    }
    if (grid > 0) {
      GridLines.paint(graphics, grid, viewport, getSize(), theme());
    }
    GraphicsPen pen = new GraphicsPen(graphics, theme());
    MarkPainter.paint(marks, scene, viewport, screen, pen);
    notes.paint(scene, screen, pen, corner);
    tellAside(String.join("   ", notes.aside(scene, corner)));
    overlays.forEach(overlay -> overlay.accept(pen));
    graphics.dispose();
    ring.paint(g);
  }

  /** Other components change after the painting, not within it. */
  private void tellAside(String words) {
    if (!words.equals(told)) {
      told = words;
      SwingUtilities.invokeLater(() -> aside.accept(words));
    }
  }

  private static double scaleOf(Graphics2D graphics) {
    return graphics.getTransform().getScaleX();
  }
}
