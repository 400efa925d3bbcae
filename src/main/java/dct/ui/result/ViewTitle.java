package dct.ui.result;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Insets;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;

/** What a view is called, and a button that closes it. */
final class ViewTitle extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int WIDEST = 170; // of a title in a tab

  ViewTitle(ResultView view) {
    super(new BorderLayout(6, 0));
    setOpaque(false);
    setBorder(BorderFactory.createEmptyBorder(2, 8, 2, 4));
    JLabel title = new Title(view.method());
    title.setName("title");
    view.addListener(() -> title.setText(view.method()));
    add(title, BorderLayout.CENTER);
    add(closeButton(view), BorderLayout.EAST);
  }

  private static JButton closeButton(ResultView view) {
    JButton close = new JButton("×");
    close.setName("Close View");
    close.setToolTipText("Closes this view (Ctrl+W)");
    close.getAccessibleContext().setAccessibleName("Close " + view.title());
    close.setMargin(new Insets(0, 4, 0, 4));
    close.putClientProperty("JButton.buttonType", "toolBarButton");
    close.setFocusable(true);
    close.addActionListener(e -> view.close());
    return close;
  }

  /** A text that is cut where it is too long for a tab. */
  private static final class Title extends JLabel {
    private static final long serialVersionUID = 1L;

    Title(String text) {
      super(text);
    }

    @Override
    public Dimension getPreferredSize() {
      Dimension wished = super.getPreferredSize();
      return new Dimension(Math.min(WIDEST, wished.width), wished.height);
    }
  }
}
