package dct.ui.result;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Insets;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;

/** What a view is called, and a button that closes it. */
final class ViewTitle extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int LEAST = 170; // of a title in a tab, if it is as long
  private static final int AROUND = 70; // what the rest of a tab takes

  private final transient ResultView view;
  private final JLabel title = new JLabel();
  private final JButton close;
  private final JTabbedPane tabs; // null if it is in none

  /** A title that takes the room which it is given. */
  ViewTitle(ResultView view) {
    this(view, null);
  }

  /**
   * A title for a tab.
   *
   * @param tabs which share their room, and show the whole title under the mouse
   */
  ViewTitle(ResultView view, JTabbedPane tabs) {
    super(new BorderLayout(6, 0));
    this.view = view;
    this.tabs = tabs;
    setOpaque(false);
    setBorder(BorderFactory.createEmptyBorder(2, 8, 2, 4));
    title.setName("title");
    add(title, BorderLayout.CENTER);
    close = closeButton(view);
    add(close, BorderLayout.EAST);
    write();
    view.addListener(this::write);
  }

  /** The title of the view in front is bold. */
  private void write() {
    title.setText(view.method());
    close.getAccessibleContext().setAccessibleName("Close " + view.title());
    title.putClientProperty("FlatLaf.style", view.isInFront() ? "font: bold" : "font: -bold");
    if (tabs == null) {
      title.setToolTipText(view.title());
    } else if (tabs.indexOfComponent(view) >= 0) { // a label with a tip would keep clicks
      tabs.setToolTipTextAt(tabs.indexOfComponent(view), view.title());
    }
  }

  /** Not kept, as others are: the room of a tab is another one after each change of the tabs. */
  @Override
  public Dimension getPreferredSize() {
    Dimension wished = getLayout().preferredLayoutSize(this);
    if (tabs == null) {
      return wished;
    }
    int room = tabs.getWidth() / Math.max(1, tabs.getTabCount()) - AROUND;
    int cut = title.getPreferredSize().width - Math.max(LEAST, room);
    return new Dimension(wished.width - Math.max(0, cut), wished.height);
  }

  private static JButton closeButton(ResultView view) {
    JButton close = new JButton("×");
    close.setName("Close View");
    close.setToolTipText("Closes this view (Ctrl+W)");
    close.setMargin(new Insets(0, 4, 0, 4));
    close.putClientProperty("JButton.buttonType", "toolBarButton");
    close.setFocusable(true);
    close.addActionListener(e -> view.close());
    return close;
  }
}
