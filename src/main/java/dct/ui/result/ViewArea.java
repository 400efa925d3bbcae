package dct.ui.result;

import dct.core.geometry.Box;
import dct.ui.canvas.CanvasPanel;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;

/**
 * Shows views beside or below the drawing, or as tabs there; see {@link Arrangement}. Keys go to
 * the view that has the focus, and else to the window.
 */
public final class ViewArea extends JPanel implements ViewHost {
  private static final long serialVersionUID = 1L;

  private final CanvasPanel drawing;
  private final transient Consumer<Boolean> whenShared;
  private final List<ResultView> views = new ArrayList<>(); // as shown, from left to right
  private ResultView used; // last
  private transient Optional<ResultView> front = Optional.empty(); // rather than the drawing
  private transient Consumer<Optional<ResultView>> whenInFront = view -> {};
  private Arrangement arrangement = Arrangement.AUTO;
  private final JTabbedPane tabs = new JTabbedPane();
  private final transient FocusAdapter use =
      new FocusAdapter() {
        @Override
        public void focusGained(FocusEvent e) {
          used = (ResultView) SwingUtilities.getAncestorOfClass(ResultView.class, e.getComponent());
          setFront(Optional.ofNullable(used));
        }
      };

  /**
   * An area that shows nothing but the drawing.
   *
   * @param whenShared is told whether views take room from the drawing
   */
  public ViewArea(CanvasPanel drawing, Consumer<Boolean> whenShared) {
    super(new BorderLayout());
    this.drawing = drawing;
    this.whenShared = whenShared;
    setName("centre");
    tabs.setName("results");
    tabs.getAccessibleContext().setAccessibleName("Results");
    tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
    drawing.setMinimumSize(new Dimension());
    drawing.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusGained(FocusEvent e) {
            setFront(Optional.empty());
          }
        });
    add(drawing, BorderLayout.CENTER);
  }

  /** Says who is told of the view that the user works with now; of none if it is the drawing. */
  public void whenInFront(Consumer<Optional<ResultView>> told) {
    whenInFront = told;
  }

  private void setFront(Optional<ResultView> view) {
    if (!view.equals(front)) {
      front = view;
      views.forEach(each -> each.setInFront(view.filter(each::equals).isPresent()));
      whenInFront.accept(view);
    }
  }

  /** How the views share the room. */
  public Arrangement arrangement() {
    return arrangement;
  }

  /** Lets the views share the room in another way. */
  public void setArrangement(Arrangement other) {
    arrangement = other;
    layOut();
  }

  /** Whether the view in use can be moved by so many places. */
  public boolean canMove(int places) {
    int to = inUse() + places;
    return !views.isEmpty() && to >= 0 && to < views.size();
  }

  /** Moves the view in use by so many places, to the right or downwards if positive. */
  public void move(int places) {
    if (canMove(places)) {
      ResultView view = views.get(inUse());
      Collections.swap(views, inUse(), inUse() + places);
      layOut();
      toFront(view);
    }
  }

  /** The place of the view that was used last; of the newest if it is gone. */
  private int inUse() {
    return views.contains(used) ? views.indexOf(used) : views.size() - 1;
  }

  @Override
  public void show(ResultView view, Optional<ResultView> beside) {
    views.add(view);
    used = view;
    view.canvas().addFocusListener(use);
    view.setMinimumSize(new Dimension());
    view.bindKeys();
    SwingUtilities.updateComponentTreeUI(view); // the look may have changed while it was away
    layOut();
    if (tabs.indexOfComponent(view) >= 0) {
      tabs.setSelectedComponent(view);
    }
  }

  @Override
  public void showAll(List<ResultView> shown) {
    shown.forEach(view -> show(view, Optional.empty()));
  }

  @Override
  public void hide(ResultView view) {
    if (views.remove(view)) {
      view.canvas().removeFocusListener(use);
      if (front.filter(view::equals).isPresent()) {
        setFront(Optional.empty());
      }
      layOut();
    }
  }

  @Override
  public void release(ResultView view) {
    hide(view);
  }

  @Override
  public boolean isShown(ResultView view) {
    return views.contains(view);
  }

  @Override
  public void toFront(ResultView view) {
    used = view;
    if (tabs.indexOfComponent(view) >= 0) {
      tabs.setSelectedComponent(view);
    }
    view.canvas().requestFocusInWindow();
  }

  private void layOut() {
    whenShared.accept(!views.isEmpty());
    Component selected = tabs.getSelectedComponent();
    tabs.removeAll();
    removeAll();
    add(views.isEmpty() ? drawing : shared());
    if (tabs.indexOfComponent(selected) >= 0) {
      tabs.setSelectedComponent(selected);
    }
    revalidate();
    repaint();
  }

  private JComponent shared() {
    Box drawn = drawing.scene().bounds().orElse(new Box(0, 0, 1, 1));
    boolean below = arrangement.isBelow(drawn, getSize());
    int along = below ? JSplitPane.VERTICAL_SPLIT : JSplitPane.HORIZONTAL_SPLIT;
    if (arrangement.isTabbed(views.size())) {
      SwingUtilities.updateComponentTreeUI(tabs);
      views.forEach(this::addTab);
      return split(along, drawing, tabs, 2);
    }
    if (arrangement == Arrangement.AUTO) { // two share the room that one would have
      int across = below ? JSplitPane.HORIZONTAL_SPLIT : JSplitPane.VERTICAL_SPLIT;
      return split(along, drawing, inRow(across, views), 2);
    }
    return split(along, drawing, inRow(along, views), views.size() + 1);
  }

  private static JComponent inRow(int along, List<ResultView> row) {
    JComponent first = titled(row.get(0));
    int count = row.size();
    return count == 1 ? first : split(along, first, inRow(along, row.subList(1, count)), count);
  }

  private void addTab(ResultView view) {
    tabs.addTab(view.title(), view);
    tabs.setTabComponentAt(tabs.getTabCount() - 1, new ViewTitle(view, tabs));
  }

  private static JComponent titled(ResultView view) {
    JPanel titled = new JPanel(new BorderLayout());
    titled.setMinimumSize(new Dimension());
    titled.add(new ViewTitle(view), BorderLayout.NORTH);
    titled.add(view, BorderLayout.CENTER);
    return titled;
  }

  /** Two parts, the first of which gets one of so many shares of the room. */
  private static JSplitPane split(
      int orientation, JComponent first, JComponent second, int shares) {
    JSplitPane split = new JSplitPane(orientation, true, first, second);
    split.setName("split");
    split.setBorder(null);
    split.setResizeWeight(1.0 / shares);
    split.addComponentListener(new Shares(split));
    return split;
  }

  /** Gives the parts of a split their shares of the room when it is shown first. */
  private static final class Shares extends ComponentAdapter {
    private final JSplitPane split;

    Shares(JSplitPane split) {
      this.split = split;
    }

    @Override
    public void componentResized(ComponentEvent e) {
      split.setDividerLocation(split.getResizeWeight());
      split.removeComponentListener(this);
    }
  }
}
