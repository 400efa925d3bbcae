package dct.ui.solve;

import dct.core.geometry.Box;
import dct.render.Viewport;
import dct.ui.canvas.CanvasPanel;
import dct.ui.dialog.Placement;
import dct.ui.result.ResultView;
import dct.ui.result.Tiling;
import dct.ui.result.Tiling.Obstacle;
import dct.ui.result.ViewHost;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;

/** Shows each view in a frame of its own, placed so that it covers as little as possible. */
public final class FrameHost implements ViewHost {
  private static final int WINDOW = 1; // how much a pixel of each matters
  private static final int DRAWN = 2;
  private static final int CONTROLS = 3;
  private static final int VIEW = 4;
  private static final int TITLE = 60; // of a view
  private static final int TITLE_HEIGHT = 28;

  private final JFrame owner;
  private final CanvasPanel canvas;
  private final Map<ResultView, ResultFrame> frames = new LinkedHashMap<>();

  /**
   * Frames of a window; there are none yet.
   *
   * @param canvas the window's canvas
   */
  FrameHost(JFrame owner, CanvasPanel canvas) {
    this.owner = owner;
    this.canvas = canvas;
  }

  @Override
  public void show(ResultView view, Optional<ResultView> beside) {
    ResultFrame frame = frames.get(view);
    if (frame == null) {
      frame = new ResultFrame(view);
      SwingUtilities.updateComponentTreeUI(frame); // the look may have changed while it was away
      frames.put(view, frame);
      frame.pack();
      place(frame, beside.map(frames::get).filter(ResultFrame::isShowing));
    }
    frame.setVisible(true);
  }

  private void place(ResultFrame frame, Optional<ResultFrame> beside) {
    if (beside.isPresent()) {
      placeBeside(frame, beside.get());
    } else {
      place(frame, 1);
    }
  }

  /** Places one of so many frames that are opened together. */
  private void place(ResultFrame frame, int together) {
    Rectangle screen = Placement.usable(owner);
    Dimension size = Tiling.size(frame.getSize(), together, screen);
    frame.setBounds(Tiling.place(size, screen, controls(), obstacles(frame)));
  }

  private void placeBeside(ResultFrame frame, ResultFrame other) {
    Rectangle screen = Placement.usable(owner);
    Tiling.Pair pair = Tiling.pair(other.getBounds(), screen, controls(), obstacles(frame));
    other.setBounds(pair.first());
    other.validate();
    frame.setBounds(pair.second());
    other.toFront();
  }

  @Override
  public void showAll(List<ResultView> views) {
    for (ResultView view : views) {
      ResultFrame frame = new ResultFrame(view);
      frames.put(view, frame);
      frame.pack();
      place(frame, views.size());
      frame.setVisible(true);
    }
  }

  /** The frames of all windows that are on the screen and can be moved there. */
  public static List<ResultFrame> shown() {
    return Arrays.stream(Window.getWindows())
        .filter(ResultFrame.class::isInstance)
        .map(ResultFrame.class::cast)
        .filter(frame -> frame.isShowing() && frame.getExtendedState() == Frame.NORMAL)
        .toList();
  }

  private List<Obstacle> obstacles(Window without) {
    List<Obstacle> obstacles = new ArrayList<>();
    for (Window window : Window.getWindows()) {
      if (window.isShowing() && window != without) {
        obstacles.add(new Obstacle(window.getBounds(), weight(window)));
        if (window instanceof ResultFrame) {
          obstacles.add(new Obstacle(titleBar(window), TITLE));
        }
      }
    }
    controls().forEach(part -> obstacles.add(new Obstacle(part, CONTROLS)));
    drawn().ifPresent(box -> obstacles.add(new Obstacle(box, DRAWN)));
    return obstacles;
  }

  private static int weight(Window window) {
    if (window instanceof ResultFrame) {
      return VIEW;
    }
    return window instanceof Dialog ? CONTROLS : WINDOW;
  }

  /** By which a window is found and moved. */
  private static Rectangle titleBar(Window window) {
    return new Rectangle(window.getX(), window.getY(), window.getWidth(), TITLE_HEIGHT);
  }

  /** The menus, tools and buttons of the main window, where they are on the screen. */
  private List<Rectangle> controls() {
    List<Component> controls = new ArrayList<>();
    controls.add(owner.getJMenuBar());
    if (owner.getContentPane().getLayout() instanceof BorderLayout layout) {
      controls.add(layout.getLayoutComponent(BorderLayout.NORTH));
      controls.add(layout.getLayoutComponent(BorderLayout.EAST));
    }
    return controls.stream()
        .filter(part -> part != null && part.isShowing())
        .map(part -> new Rectangle(part.getLocationOnScreen(), part.getSize()))
        .toList();
  }

  /** Where the points are drawn. */
  private Optional<Rectangle> drawn() {
    return canvas.scene().bounds().filter(box -> canvas.isShowing()).map(this::drawn);
  }

  private Rectangle drawn(Box box) {
    Viewport view = canvas.viewport();
    Rectangle drawn = new Rectangle(corner(view, box.minX(), box.minY()));
    drawn.add(corner(view, box.maxX(), box.maxY()));
    Rectangle seen = drawn.intersection(new Rectangle(canvas.getSize()));
    Point at = canvas.getLocationOnScreen();
    seen.translate(at.x, at.y);
    return seen;
  }

  private static Point corner(Viewport view, double x, double y) {
    return new Point((int) view.screenX(x), (int) view.screenY(y));
  }

  @Override
  public void hide(ResultView view) {
    Optional.ofNullable(frames.get(view)).ifPresent(frame -> frame.setVisible(false));
  }

  @Override
  public void release(ResultView view) {
    Optional.ofNullable(frames.remove(view)).ifPresent(ResultFrame::dispose);
  }

  @Override
  public boolean isShown(ResultView view) {
    return Optional.ofNullable(frames.get(view)).filter(ResultFrame::isVisible).isPresent();
  }

  @Override
  public void toFront(ResultView view) {
    ResultFrame frame = frames.get(view);
    frame.setVisible(true);
    toFront(frame);
    view.canvas().requestFocusInWindow();
  }

  /** Brings a window to the front, also where it is but an icon. */
  static void toFront(JFrame window) {
    window.setExtendedState(window.getExtendedState() & ~Frame.ICONIFIED);
    window.toFront();
  }
}
