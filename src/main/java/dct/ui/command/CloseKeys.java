package dct.ui.command;

import java.awt.event.ActionEvent;
import java.awt.event.WindowEvent;
import javax.swing.AbstractAction;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.KeyStroke;

/** The keys that close dialogs which leave the window usable: Esc, and Ctrl+W as of a window. */
public final class CloseKeys extends AbstractAction {
  private static final long serialVersionUID = 1L;
  private static final String CLOSE = "close";

  private final JDialog dialog;

  private CloseKeys(JDialog dialog) {
    this.dialog = dialog;
  }

  /** Lets the keys close a dialog as its close button does; open lists and cells come first. */
  public static void close(JDialog dialog) {
    InputMap keys = dialog.getRootPane().getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW);
    keys.put(KeyStroke.getKeyStroke("ESCAPE"), CLOSE);
    keys.put(KeyStroke.getKeyStroke("ctrl W"), CLOSE);
    dialog.getRootPane().getActionMap().put(CLOSE, new CloseKeys(dialog));
  }

  @Override
  public void actionPerformed(ActionEvent e) {
    dialog.dispatchEvent(new WindowEvent(dialog, WindowEvent.WINDOW_CLOSING));
  }
}
