package dct.ui;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Point;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Tells what has arrived of a robot's mouse and keyboard: an event that was sent takes its time,
 * and an idle queue does not say that none is on its way.
 */
final class InputLog implements AWTEventListener {
  private final AtomicLong mousePresses = new AtomicLong();
  private final AtomicLong mouseReleases = new AtomicLong();
  private final AtomicLong keyReleases = new AtomicLong();
  private final AtomicReference<MouseEvent> lastMouse = new AtomicReference<>();

  void start() {
    Toolkit.getDefaultToolkit()
        .addAWTEventListener(
            this,
            AWTEvent.MOUSE_EVENT_MASK | AWTEvent.MOUSE_MOTION_EVENT_MASK | AWTEvent.KEY_EVENT_MASK);
  }

  void stop() {
    Toolkit.getDefaultToolkit().removeAWTEventListener(this);
  }

  long mousePresses() {
    return mousePresses.get();
  }

  long mouseReleases() {
    return mouseReleases.get();
  }

  long keyReleases() {
    return keyReleases.get();
  }

  /** Whether the last that was heard of the mouse is that it is at this place of the component. */
  boolean isMouseAt(Component component, Point place) {
    MouseEvent last = lastMouse.get();
    return last != null && last.getComponent() == component && last.getPoint().equals(place);
  }

  @Override
  public void eventDispatched(AWTEvent event) {
    if (event instanceof MouseEvent mouse) {
      lastMouse.set(mouse);
    }
    switch (event.getID()) {
      case MouseEvent.MOUSE_PRESSED -> mousePresses.incrementAndGet();
      case MouseEvent.MOUSE_RELEASED -> mouseReleases.incrementAndGet();
      case KeyEvent.KEY_RELEASED -> keyReleases.incrementAndGet();
      default -> {}
    }
  }
}
