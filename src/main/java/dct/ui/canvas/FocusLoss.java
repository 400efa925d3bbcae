package dct.ui.canvas;

import java.awt.Window;
import java.awt.event.HierarchyEvent;
import java.awt.event.WindowEvent;
import java.awt.event.WindowFocusListener;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/** Runs something whenever the window of a component loses the keyboard, as to a dialog. */
final class FocusLoss implements WindowFocusListener {
  private final Runnable action;
  private Window window; // that is listened to; null while the component is not shown

  private FocusLoss(Runnable action) {
    this.action = action;
  }

  static void of(JComponent component, Runnable action) {
    FocusLoss loss = new FocusLoss(action);
    component.addHierarchyListener(
        e -> {
          if ((e.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0) {
            loss.listen(component);
          }
        });
  }

  private void listen(JComponent component) {
    if (window != null) {
      window.removeWindowFocusListener(this);
    }
    window = component.isShowing() ? SwingUtilities.getWindowAncestor(component) : null;
    if (window != null) {
      window.addWindowFocusListener(this);
    }
  }

  @Override
  public void windowGainedFocus(WindowEvent e) {}

  @Override
  public void windowLostFocus(WindowEvent e) {
    action.run();
  }
}
