package dct.ui.result;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;

/**
 * Shows views beside the drawing: one to its right, two there above each other, more as tabs. Keys
 * go to the view that has the focus, and else to the window.
 */
public final class ViewArea extends JPanel implements ViewHost {
  private static final long serialVersionUID = 1L;
  private static final int WITHOUT_TABS = 2;

  private final JComponent drawing;
  private final transient Consumer<Boolean> whenShared;
  private final List<ResultView> views = new ArrayList<>(); // as shown, from the oldest on
  private final JTabbedPane tabs = new JTabbedPane();

  /**
   * An area that shows nothing but the drawing.
   *
   * @param whenShared is told whether views take room from the drawing
   */
  public ViewArea(JComponent drawing, Consumer<Boolean> whenShared) {
    super(new BorderLayout());
    this.drawing = drawing;
    this.whenShared = whenShared;
    setName("centre");
    tabs.setName("results");
    tabs.getAccessibleContext().setAccessibleName("Results");
    tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
    drawing.setMinimumSize(new Dimension());
    add(drawing, BorderLayout.CENTER);
  }

  @Override
  public void show(ResultView view, Optional<ResultView> beside) {
    views.add(view);
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
    add(views.isEmpty() ? drawing : split(JSplitPane.HORIZONTAL_SPLIT, drawing, right()));
    if (tabs.indexOfComponent(selected) >= 0) {
      tabs.setSelectedComponent(selected);
    }
    revalidate();
    repaint();
  }

  private JComponent right() {
    if (views.size() > WITHOUT_TABS) {
      SwingUtilities.updateComponentTreeUI(tabs);
      views.forEach(this::addTab);
      return tabs;
    }
    JComponent first = titled(views.get(0));
    return views.size() == 1
        ? first
        : split(JSplitPane.VERTICAL_SPLIT, first, titled(views.get(1)));
  }

  private void addTab(ResultView view) {
    tabs.addTab(view.title(), view);
    tabs.setTabComponentAt(tabs.getTabCount() - 1, new ViewTitle(view));
  }

  private static JComponent titled(ResultView view) {
    JPanel titled = new JPanel(new BorderLayout());
    titled.setMinimumSize(new Dimension());
    titled.add(new ViewTitle(view), BorderLayout.NORTH);
    titled.add(view, BorderLayout.CENTER);
    return titled;
  }

  private static JSplitPane split(int orientation, JComponent first, JComponent second) {
    JSplitPane split = new JSplitPane(orientation, true, first, second);
    split.setName("split");
    split.setBorder(null);
    split.setResizeWeight(0.5);
    split.addComponentListener(new Halves(split));
    return split;
  }

  /** Gives both sides of a split the same room when it is shown first. */
  private static final class Halves extends ComponentAdapter {
    private final JSplitPane split;

    Halves(JSplitPane split) {
      this.split = split;
    }

    @Override
    public void componentResized(ComponentEvent e) {
      split.setDividerLocation(0.5);
      split.removeComponentListener(this);
    }
  }
}
