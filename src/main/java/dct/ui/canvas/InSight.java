package dct.ui.canvas;

import dct.render.Viewport;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.ArrayList;
import java.util.List;

/**
 * Keeps a drawing in sight that was all in sight when its canvas gets less room for the sake of
 * others, and shows it as it was when there is room again.
 */
public final class InSight extends ComponentAdapter {
  private final CanvasPanel canvas;
  private final Links links;
  private Dimension size; // before it changes
  private Viewport wished; // with more room
  private Viewport fitted; // shown in its stead; null if it is what is shown
  private final List<Component> neighbours = new ArrayList<>(); // which take room while visible
  private boolean shared;

  /** Watches the size of a canvas. */
  public InSight(CanvasPanel canvas, Links links) {
    this.canvas = canvas;
    this.links = links;
    size = canvas.getSize();
    canvas.addComponentListener(this);
  }

  /** Says that the canvas shares its room with others, or does so no longer. */
  public void setShared(boolean shares) {
    shared = shares;
  }

  /** Says that the canvas shares its room with a component while that is visible. */
  public void shareWith(Component neighbour) {
    neighbours.add(neighbour);
  }

  private boolean isShared() {
    return shared || neighbours.stream().anyMatch(Component::isVisible);
  }

  @Override
  public void componentResized(ComponentEvent e) {
    boolean wasAll = canvas.isAllInSight(size);
    size = canvas.getSize();
    boolean shrinking = isShared();
    boolean isOurs = canvas.viewport().equals(fitted);
    if (isOurs) {
      links.quietly(() -> canvas.setViewport(wished));
    }
    if (shrinking && (wasAll || isOurs) && !canvas.isAllInSight()) {
      wished = canvas.viewport();
      links.quietly(canvas::fit);
      fitted = canvas.viewport();
    } else {
      fitted = null;
      if (shrinking && !wasAll) {
        links.resized(canvas);
      }
    }
  }
}
