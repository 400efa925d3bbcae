package dct.ui.result;

import dct.render.Labels;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
import dct.ui.canvas.Links;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Result;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPanel;

/**
 * A view of one result: its canvas, what belongs to it, and its commands. Where it is shown, in a
 * frame of its own or within another window, is for others to say; it may change.
 */
public final class ResultView extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final Dimension CANVAS = new Dimension(600, 480);

  private final CanvasPanel canvas = new CanvasPanel();
  private final transient CommandRegistry commands = new CommandRegistry();
  private final transient List<Runnable> listeners = new ArrayList<>();
  private final transient Links links;
  private transient Runnable whenClosed = () -> {};
  private String name; // of what the result is of
  private String method;
  private transient Optional<Result> result = Optional.empty();
  private boolean isInFront;

  /**
   * A view of a picture that is no result of a document.
   *
   * @param method what was done
   * @param name what it was done to
   * @param labels what is written beside the vertices at first
   * @param links with other views of the same points
   */
  public ResultView(String method, String name, Scene scene, Labels labels, Links links) {
    super(new BorderLayout());
    this.links = links;
    this.method = method;
    this.name = name;
    setName("view");
    canvas.setPreferredSize(CANVAS);
    canvas.setLabels(labels);
    canvas.addComponentListener(new Sizes());
    add(canvas, BorderLayout.CENTER);
    show(scene);
    links.add(canvas);
  }

  /**
   * A view of a result.
   *
   * @param name of what the result is of
   * @param labels what is written beside the vertices at first
   * @param links with other views of the same points
   */
  public ResultView(Result result, String name, Labels labels, Links links) {
    this(result.title(), name, result.scene(), labels, links);
    this.result = Optional.of(result);
  }

  /** Calls the listener after each change of the result. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Shows a result of the same points, in the same part of the canvas. */
  public void show(Result other) {
    if (!result.equals(Optional.of(other))) {
      result = Optional.of(other);
      method = other.title();
      show(other.scene());
      listeners.forEach(Runnable::run);
    }
  }

  /** Shows a state on the way to the result, or the result itself again. */
  public void showState(Optional<Scene> state) {
    state.or(() -> result.map(Result::scene)).ifPresent(this::show);
  }

  private void show(Scene scene) {
    canvas.setScene(scene);
    canvas.getAccessibleContext().setAccessibleDescription(String.join("; ", scene.counts()));
  }

  /** Puts a component below the canvas. */
  public void addBelow(JComponent component) {
    add(component, BorderLayout.SOUTH);
  }

  /** Lets the keys of its commands work while the focus is within the view. */
  void bindKeys() {
    commands.bindKeysWithin(this);
  }

  /** Says whether the commands of the window around it are done in this view now. */
  void setInFront(boolean inFront) {
    if (inFront != isInFront) {
      isInFront = inFront;
      listeners.forEach(Runnable::run);
    }
  }

  /** Whether the commands of the window around it are done in this view now. */
  boolean isInFront() {
    return isInFront;
  }

  /** Says who takes the view away when it is closed. */
  public void whenClosed(Runnable action) {
    whenClosed = action;
  }

  /** Closes the view for good. */
  public void close() {
    links.remove(canvas);
    whenClosed.run();
  }

  /** What is shown, if it is a result of a document. */
  public Optional<Result> result() {
    return result;
  }

  /** What was done. */
  public String method() {
    return method;
  }

  /** What it was done to. */
  public String document() {
    return name;
  }

  /** Says what it was done to: a drawing has another name once it is saved under that. */
  public void setDocument(String other) {
    if (!other.equals(name)) {
      name = other;
      listeners.forEach(Runnable::run);
    }
  }

  /** What was done to what. */
  public String title() {
    return method + " · " + name;
  }

  /** Its commands; they are bound to keys by who shows it. */
  public CommandRegistry commands() {
    return commands;
  }

  /** The canvas. */
  public CanvasPanel canvas() {
    return canvas;
  }

  /** Shows a part that fits in with other views whenever the size changes. */
  private final class Sizes extends ComponentAdapter {
    @Override
    public void componentResized(ComponentEvent e) {
      links.resized(canvas);
    }
  }
}
