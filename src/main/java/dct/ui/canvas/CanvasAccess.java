package dct.ui.canvas;

import java.beans.PropertyChangeListener;
import java.util.function.Supplier;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;
import javax.swing.Timer;

/**
 * What a screen reader is told of a canvas: what is there, once it has come to rest after a change.
 * Where no screen reader listens, nothing is put into words.
 */
final class CanvasAccess extends JComponent.AccessibleJComponent {
  private static final long serialVersionUID = 1L;
  private static final int PAUSE_MILLIS = 300;

  private final Timer pause = new Timer(PAUSE_MILLIS, e -> tell());
  private transient Supplier<String> words = super::getAccessibleDescription;
  private boolean isHeard; // somebody listens
  private String told = "";

  CanvasAccess(JComponent canvas) {
    canvas.super();
    pause.setRepeats(false);
  }

  /** Says how what is shown is put into words. */
  void setWords(Supplier<String> others) {
    words = others;
  }

  @Override
  public AccessibleRole getAccessibleRole() {
    return AccessibleRole.CANVAS;
  }

  @Override
  public String getAccessibleDescription() {
    return words.get();
  }

  @Override
  public void addPropertyChangeListener(PropertyChangeListener listener) {
    isHeard = true;
    super.addPropertyChangeListener(listener);
  }

  /** Something else is shown. */
  void changed() {
    if (isHeard) {
      pause.restart();
    }
  }

  private void tell() {
    String before = told;
    told = words.get();
    firePropertyChange(ACCESSIBLE_DESCRIPTION_PROPERTY, before, told);
  }
}
