package dct.ui.command;

import java.awt.event.ActionEvent;
import java.awt.event.WindowEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.KeyStroke;

/** The Escape key of dialogs that leave the window usable. */
public final class EscapeKey extends AbstractAction {
  private static final long serialVersionUID = 1L;
  private static final String CLOSE = "close";

  private final JDialog dialog;

  private EscapeKey(JDialog dialog) {
    this.dialog = dialog;
  }

  /** Lets Escape close a dialog as its close button does; open lists and cells come first. */
  public static void closes(JDialog dialog) {
    dialog
        .getRootPane()
        .getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
        .put(KeyStroke.getKeyStroke("ESCAPE"), CLOSE);
    dialog.getRootPane().getActionMap().put(CLOSE, new EscapeKey(dialog));
  }

  @Override
  public void actionPerformed(ActionEvent e) {
    dialog.dispatchEvent(new WindowEvent(dialog, WindowEvent.WINDOW_CLOSING));
  }
}
