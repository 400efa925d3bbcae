package dct.ui.file;

import dct.core.Progress;
import dct.render.Figure;
import dct.render.PictureFile;
import dct.render.Scene;
import dct.render.Theme;
import dct.ui.dialog.Fields;
import dct.ui.dialog.Memory;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.BorderFactory;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.SwingWorker;

/**
 * What is asked of a picture beside its file, with a preview: what it shows and how large, its
 * colours, counts and legend. The answers are those of the last time.
 */
final class FigurePanel extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final int GAP = 6;

  private final transient Scene scene;
  private final boolean yUp;
  private final JComboBox<String> extent =
      new JComboBox<>(
          new String[] {"As in the window", "Figure, column (84 mm)", "Figure, page (174 mm)"});
  private final JComboBox<String> scale =
      new JComboBox<>(new String[] {"1 ×", "2 ×", "3 ×", "4 ×"});
  private final JComboBox<String> theme = new JComboBox<>(new String[] {"Light", "Print", "Dark"});
  private final JCheckBox counts = new JCheckBox("Counts");
  private final JCheckBox legend = new JCheckBox("Legend");
  private final Preview preview = new Preview();

  /**
   * Fields for pictures of a scene.
   *
   * @param yUp whether y grows upwards in them
   */
  FigurePanel(Scene scene, boolean yUp) {
    super(new BorderLayout(0, GAP));
    this.scene = scene;
    this.yUp = yUp;
    setBorder(BorderFactory.createEmptyBorder(0, 2 * GAP, 0, 0));
    Fields fields = new Fields();
    fields.ask("Shows:", 'h', "extent", extent, "The window's part, or all, cropped, for a paper");
    fields.ask("PNG scale:", 'g', "scale", scale, "Pixels of a PNG; others are sharp at any size");
    fields.ask("Colours:", 'o', "theme", theme, "Print is told apart in grey, too");
    fields.offer(counts, 't', "counts", "Writes how many vertices are even and odd");
    fields.offer(legend, 'l', "legend", "Says what colours and shapes stand for");
    add(fields, BorderLayout.NORTH);
    add(preview);
    recall(extent);
    recall(scale);
    recall(theme);
    counts.setSelected(Memory.get(memory(counts)).map(Boolean::valueOf).orElse(true));
    legend.setSelected(Memory.get(memory(legend)).map(Boolean::valueOf).orElse(false));
    extent.addActionListener(e -> changed());
    theme.addActionListener(e -> changed());
    counts.addActionListener(e -> changed());
    legend.addActionListener(e -> changed());
    changed();
  }

  /** The figure asked for; nothing if the window's part is. */
  Optional<Figure> figure() {
    Theme colours = Theme.valueOf(theme.getSelectedItem().toString().toUpperCase(Locale.ROOT));
    double width = extent.getSelectedIndex() == 2 ? 174 : 84;
    Figure figure =
        new Figure(
            new Figure.Size(width, Figure.Unit.MM),
            scale(),
            true,
            scene.labels(),
            counts.isSelected(),
            legend.isSelected(),
            yUp,
            colours,
            false);
    return extent.getSelectedIndex() == 0 ? Optional.empty() : Optional.of(figure);
  }

  /** How many times finer the pixels of a PNG are. */
  int scale() {
    return scale.getSelectedIndex() + 1;
  }

  /** Keeps the answers for the next time. */
  void remember() {
    for (JComboBox<String> choice : List.of(extent, scale, theme)) {
      Memory.put(memory(choice), choice.getSelectedIndex());
    }
    for (JCheckBox box : List.of(counts, legend)) {
      Memory.put(memory(box), box.isSelected());
    }
  }

  private static void recall(JComboBox<String> choice) {
    int last = Memory.number(memory(choice)).orElse(0);
    choice.setSelectedIndex(last < 0 || last >= choice.getItemCount() ? 0 : last);
  }

  private static String memory(Component field) {
    return "figure." + field.getName();
  }

  private void changed() {
    boolean isFigure = extent.getSelectedIndex() > 0;
    for (Component field : new Component[] {theme, counts, legend}) {
      field.setEnabled(isFigure);
    }
    preview.show(figure());
  }

  /** A small picture of what will be written, drawn in the background. */
  private final class Preview extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int WIDTH = 260;
    private static final int HEIGHT = 200;

    private final transient AtomicInteger turn = new AtomicInteger();
    private transient BufferedImage image;

    Preview() {
      setOpaque(false);
      setPreferredSize(new Dimension(WIDTH, HEIGHT));
      setName("preview");
      getAccessibleContext().setAccessibleName("Preview");
    }

    void show(Optional<Figure> figure) {
      int mine = turn.incrementAndGet();
      image = null;
      repaint();
      figure.ifPresent(shown -> new Drawing(shown, mine).execute());
    }

    /** The drawing of one figure, in the background. */
    private final class Drawing extends SwingWorker<BufferedImage, Void> {
      private final Figure figure;
      private final int mine;

      Drawing(Figure figure, int mine) {
        this.figure = figure;
        this.mine = mine;
      }

      @Override
      protected BufferedImage doInBackground() {
        return draw(figure, mine);
      }

      @Override
      protected void done() {
        try {
          take(get(), mine);
        } catch (ExecutionException | InterruptedException e) {
          take(null, mine); // another one has been asked for, or there is no memory for it
        }
      }
    }

    private BufferedImage draw(Figure figure, int mine) {
      Progress untilAnother =
          new Progress() {
            @Override
            public void report(double part, String message) {}

            @Override
            public boolean isCancelled() {
              return turn.get() != mine;
            }
          };
      return PictureFile.preview(scene, figure, WIDTH, untilAnother);
    }

    private void take(BufferedImage drawn, int mine) {
      if (turn.get() == mine) {
        image = drawn;
        repaint();
      }
    }

    @Override
    protected void paintComponent(Graphics g) {
      super.paintComponent(g);
      if (image != null) {
        double part = Math.min(1, (double) getHeight() / image.getHeight());
        int width = (int) Math.round(part * image.getWidth());
        int height = (int) Math.round(part * image.getHeight());
        g.drawImage(image, (getWidth() - width) / 2, 0, width, height, null);
      }
    }
  }
}
