package dct.ui;

import dct.render.Labels;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandMenu;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Result;
import dct.ui.job.Jobs;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JFrame;

/** A frame that shows one result. */
public final class ResultFrame extends JFrame implements CommandWindow {
  private static final long serialVersionUID = 1L;
  private static final Dimension CANVAS = new Dimension(600, 480);

  private final CanvasPanel canvas = new CanvasPanel();
  private final transient CommandRegistry commands = new CommandRegistry();
  private final String name; // of what the result is of

  /**
   * A frame that is not visible yet.
   *
   * @param method what was done
   * @param name what it was done to
   * @param labels what is written beside the vertices at first
   * @param jobs write pictures in the background
   */
  public ResultFrame(String method, String name, Scene scene, Labels labels, Jobs jobs) {
    super(method + " · " + name);
    setName("result");
    this.name = name;
    canvas.setPreferredSize(CANVAS);
    canvas.setLabels(labels);
    canvas.setScene(scene);
    describe();
    canvas.addComponentListener(new FitAtFirst());
    add(canvas, BorderLayout.CENTER);
    offer(name, jobs);
    setJMenuBar(CommandMenu.bar(MenuTable.RESULT, commands));
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
  }

  private void offer(String name, Jobs jobs) {
    commands.add(
        "Export Picture",
        "ctrl E",
        FileCommands.pictures(),
        () -> PictureExport.ask(this, canvas, name, jobs, done -> {}));
    commands.add("Close", "ctrl W", "Closes this window", this::dispose);
    ViewCommands.offer(commands, canvas);
    commands.bindKeys(getRootPane());
  }

  /** Shows a result of the same points, in the same part of the canvas. */
  void show(Result result) {
    setTitle(result.title() + " · " + name);
    canvas.setScene(result.scene());
    describe();
  }

  private void describe() {
    canvas
        .getAccessibleContext()
        .setAccessibleDescription(String.join("; ", canvas.scene().counts()));
  }

  @Override
  public CommandRegistry commands() {
    return commands;
  }

  /** The canvas. */
  public CanvasPanel canvas() {
    return canvas;
  }

  /** Fits the scene whenever the size changes, until the user has chosen a view. */
  private final class FitAtFirst extends ComponentAdapter {
    private boolean fitting;
    private boolean chosen;

    FitAtFirst() {
      canvas.addViewListener(() -> chosen |= !fitting);
    }

    @Override
    public void componentResized(ComponentEvent e) {
      if (!chosen) {
        fitting = true;
        canvas.fit();
        fitting = false;
      }
    }
  }
}
