package dct.ui.canvas;

import dct.core.geometry.Points;
import dct.render.Scene;
import dct.render.Viewport;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Links canvases that show the same points: where the user moves one, the others show the same part
 * of the model, and what is under the mouse in one is ringed in the others. Canvases of one size
 * show exactly the same, others as much more or less as the whole is larger or smaller when it is
 * fitted into them; but where all of the drawing is in sight, so it is in them. Lives on the event
 * thread; a move costs constant time for each canvas.
 */
public final class Links {
  private final List<Member> members = new ArrayList<>();
  private boolean on = true;
  private boolean moving; // the links themselves move a canvas

  /** Whether the canvases are linked. */
  public boolean isOn() {
    return on;
  }

  /** Links the canvases, or lets each go its own way; where each is then stays as it is. */
  public void setOn(boolean linked) {
    on = linked;
    if (!linked) {
      members.forEach(member -> member.mark(Optional.empty()));
    }
  }

  /** Takes in the canvas in which the points are drawn. */
  public void addDrawing(CanvasPanel canvas) {
    members.add(new Member(canvas, true));
  }

  /** Takes in the canvas of a view. */
  public void add(CanvasPanel canvas) {
    members.add(new Member(canvas, false));
  }

  /** Leaves a canvas alone from now on. */
  public void remove(CanvasPanel canvas) {
    find(canvas)
        .ifPresent(
            member -> {
              others(member).forEach(other -> other.mark(Optional.empty()));
              members.remove(member);
            });
  }

  /** Moves canvases without moving those that are linked with them. */
  public void quietly(Runnable moves) {
    boolean before = moving;
    moving = true;
    moves.run();
    moving = before;
  }

  /**
   * Shows in a canvas, whose size is new, what fits in with the others: the part that the user has
   * chosen there or in another view, or the part of the drawing that is in sight, or else
   * everything, as large as it is in other views of this size. The drawing itself stays where it is
   * unless there is a view whose part was chosen.
   */
  public void resized(CanvasPanel canvas) {
    find(canvas).filter(Member::hasRoom).ifPresent(member -> quietly(() -> settle(member)));
    members.stream()
        .filter(member -> !member.drawing && !member.chosen && member.hasRoom())
        .forEach(member -> quietly(() -> settle(member)));
  }

  private void settle(Member member) {
    List<Member> linked = on ? others(member).toList() : List.of();
    Optional<Member> chosen =
        linked.stream().filter(other -> other.chosen && !other.drawing).findFirst();
    Optional<Member> zoomed =
        linked.stream().filter(other -> other.drawing && !other.canvas.isAllInSight()).findFirst();
    if (chosen.isPresent()) {
      member.follow(chosen.get());
      member.chosen = true;
    } else if (!member.chosen && !member.drawing) {
      zoomed.ifPresentOrElse(
          member::follow, () -> member.canvas.setViewport(fitted(member, linked)));
    }
  }

  /** Below the counts of whichever view has the most of them. */
  private static Viewport fitted(Member member, List<Member> linked) {
    boolean yUp = linked.stream().findFirst().orElse(member).canvas.viewport().yUp();
    return Stream.concat(Stream.of(member), linked.stream().filter(other -> !other.drawing))
        .map(other -> member.fitted(other.canvas.scene(), yUp))
        .min(Comparator.comparingDouble(Viewport::scale))
        .orElseThrow();
  }

  private Optional<Member> find(CanvasPanel canvas) {
    return members.stream().filter(member -> member.canvas.equals(canvas)).findFirst();
  }

  private Stream<Member> others(Member member) {
    return members.stream().filter(other -> !other.equals(member) && member.isLike(other));
  }

  private void moved(Member member) {
    if (moving || !members.contains(member)) {
      return;
    }
    member.chosen = true;
    if (on) {
      boolean isPart = !member.drawing || !member.canvas.isAllInSight();
      List<Member> linked = others(member).filter(Member::hasRoom).toList(); // others settle later
      linked.forEach(other -> other.chosen = isPart);
      quietly(() -> linked.forEach(isPart ? other -> other.follow(member) : this::settle));
    }
  }

  private void hovered(Member member, Optional<Hover> hover) {
    if (on && members.contains(member)) {
      others(member).forEach(other -> other.mark(hover));
    }
  }

  /** A canvas with what its links know of it. */
  private final class Member extends MouseAdapter {
    private final CanvasPanel canvas;
    private final boolean drawing;
    private final Map<Member, Known> known = new HashMap<>();
    private boolean chosen; // the user has chosen a part, here or in a canvas that it followed
    private Optional<Hover> hover = Optional.empty(); // in another canvas
    private Scene hoverOf; // the scene in which it was marked

    /** Whether two lists of points are the same: long ones are compared once. */
    private record Known(Points mine, Points theirs, boolean same) {}

    Member(CanvasPanel canvas, boolean drawing) {
      this.canvas = canvas;
      this.drawing = drawing;
      canvas.addViewListener(() -> moved(this));
      canvas.addMouseListener(this);
      canvas.addMouseMotionListener(this);
      canvas.addOverlay(
          pen ->
              hover
                  .filter(h -> canvas.scene().points().equals(hoverOf.points()))
                  .ifPresent(h -> h.paint(canvas.scene(), canvas.viewport(), pen)));
    }

    boolean isLike(Member other) {
      Points mine = canvas.scene().points();
      Points theirs = other.canvas.scene().points();
      if (mine.size() < 2 || mine.size() != theirs.size()) {
        return false;
      }
      Known last = known.get(other);
      if (last == null || !isOf(last, mine, theirs)) {
        last = new Known(mine, theirs, mine.equals(theirs));
        known.put(other, last);
      }
      return last.same();
    }

    @SuppressWarnings("ReferenceEquality") // other objects are compared anew
    private static boolean isOf(Known known, Points mine, Points theirs) {
      return known.mine() == mine && known.theirs() == theirs;
    }

    Viewport fitted(Scene scene, boolean yUp) {
      return canvas.fitted(scene, yUp);
    }

    boolean hasRoom() {
      return canvas.getWidth() > 0 && canvas.getHeight() > 0;
    }

    /** Shows the part that another shows. */
    void follow(Member other) {
      Viewport view = other.canvas.viewport();
      boolean sameSize = canvas.getSize().equals(other.canvas.getSize());
      canvas.setViewport(sameSize ? view : sized(other, view));
      if (other.canvas.isAllInSight() && !canvas.isAllInSight()) {
        canvas.setViewport(fitted(canvas.scene(), view.yUp()));
      }
    }

    private Viewport sized(Member other, Viewport view) {
      double toX = canvas.getWidth() / 2.0;
      double toY = canvas.getHeight() / 2.0;
      double fromX = other.canvas.getWidth() / 2.0;
      double fromY = other.canvas.getHeight() / 2.0;
      double ratio = measure() / other.measure();
      return view.panned(toX - fromX, toY - fromY).zoomed(ratio, toX, toY);
    }

    /** The scale at which the whole would fit, whatever is written over it. */
    private double measure() {
      return canvas
          .scene()
          .bounds()
          .map(box -> Viewport.fit(box, canvas.getWidth(), canvas.getHeight(), 0, false).scale())
          .orElse(1.0);
    }

    void mark(Optional<Hover> other) {
      if (!hover.equals(other)) {
        hover = other;
        hoverOf = canvas.scene();
        canvas.repaint();
      }
    }

    @Override
    public void mouseMoved(MouseEvent e) {
      mark(Optional.empty());
      hovered(this, Hover.at(canvas.scene(), canvas.viewport(), e.getX(), e.getY()));
    }

    @Override
    public void mousePressed(MouseEvent e) {
      hovered(this, Optional.empty()); // a click may flip the edge
    }

    @Override
    public void mouseExited(MouseEvent e) {
      hovered(this, Optional.empty());
    }
  }
}
