package dct.ui;

import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.render.Labels;
import dct.render.Scene;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.Command;
import dct.ui.command.CommandMenu;
import dct.ui.job.Jobs;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JFrame;
import javax.swing.JMenuBar;

/** A frame that shows one result. */
public final class ResultFrame extends JFrame {
  private static final long serialVersionUID = 1L;
  private static final Dimension CANVAS = new Dimension(600, 480);

  private final CanvasPanel canvas = new CanvasPanel();

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
    canvas.setPreferredSize(CANVAS);
    canvas.setLabels(labels);
    canvas.setScene(scene);
    canvas.getAccessibleContext().setAccessibleDescription(String.join("; ", scene.counts()));
    canvas.addComponentListener(new FitAtFirst());
    add(canvas, BorderLayout.CENTER);
    setJMenuBar(menuBar(name, jobs));
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
  }

  private JMenuBar menuBar(String name, Jobs jobs) {
    JMenuBar bar = new JMenuBar();
    bar.add(
        new CommandMenu("File")
            .with(
                new Command(
                    "Export Picture",
                    "ctrl E",
                    "Writes what is seen to a picture: " + FileEnding.list(Content.PICTURE),
                    () -> PictureExport.ask(this, canvas, name, jobs)))
            .line()
            .with(new Command("Close", "ctrl W", "Closes this window", this::dispose)));
    bar.add(ViewMenu.of(canvas));
    return bar;
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
