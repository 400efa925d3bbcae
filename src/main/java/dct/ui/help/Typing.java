package dct.ui.help;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;

/**
 * Hears of each change of what is typed in a field.
 *
 * @param changed is run behind each
 */
record Typing(Runnable changed) implements DocumentListener {
  @Override
  public void insertUpdate(DocumentEvent e) {
    changed.run();
  }

  @Override
  public void removeUpdate(DocumentEvent e) {
    changed.run();
  }

  @Override
  public void changedUpdate(DocumentEvent e) {
    // attributes of a plain text
  }
}
