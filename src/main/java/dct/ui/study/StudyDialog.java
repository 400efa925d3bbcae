package dct.ui.study;

import dct.experiment.study.Study;
import dct.experiment.study.StudyExport;
import dct.experiment.study.StudyRow;
import dct.io.CannotWriteException;
import dct.io.FileEnding;
import dct.ui.command.CloseKeys;
import dct.ui.job.Jobs;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;

/**
 * The dialog of a study: what it tries, a table that fills while it runs, and a chart below it.
 * Cancel keeps the rows that are there; Start goes on from them. Closing it cancels and keeps, too.
 */
public final class StudyDialog extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final int MARGIN = 10;
  private static final int STEPS = 1000; // of the progress bar
  private static final Dimension TABLE = new Dimension(940, 190);

  private final transient StudyKind kind;
  private final transient StudyHost host;
  private final transient Jobs pictures = new Jobs();
  private final transient StudyRunner runner;
  private final StudyOptions options;
  private final RowsModel rows = new RowsModel();
  private final ChartPanel chart = new ChartPanel();
  private final JComboBox<String> charts = new JComboBox<>();
  private final JButton start = button("Start", "Runs the study, or goes on with it");
  private final JButton cancel = button("Cancel", "Ends the run and keeps the rows");
  private final JButton export =
      button("Export", "Writes rows, tables or the chart: " + StudyExport.endings());
  private final JProgressBar progress = new JProgressBar(0, STEPS);
  private transient Study study; // of the rows shown; null before the first run

  /** A dialog that is not visible yet. */
  public StudyDialog(JFrame owner, StudyKind kind, StudyHost host) {
    super(owner, "Study · " + kind.title(), false);
    this.kind = kind;
    this.host = host;
    options = new StudyOptions(kind);
    runner = new StudyRunner(new Watcher());
    pictures.setListener(new PictureFailures());
    setName("study");
    layOut();
    listen();
    showState();
    setDefaultCloseOperation(HIDE_ON_CLOSE);
    pack();
    setLocationRelativeTo(owner);
  }

  private static JButton button(String name, String description) {
    JButton button = new JButton(name);
    button.setName(name);
    button.setToolTipText(description);
    return button;
  }

  private void layOut() {
    JPanel content = new JPanel(new BorderLayout(MARGIN, MARGIN));
    content.setBorder(BorderFactory.createEmptyBorder(MARGIN, MARGIN, MARGIN, MARGIN));
    content.add(options, BorderLayout.NORTH);
    JScrollPane table =
        new JScrollPane(new RowsTable(rows, this::openPictures, progress::setString));
    JSplitPane split = new JSplitPane(JSplitPane.VERTICAL_SPLIT, table, chartSide());
    split.setResizeWeight(0.4);
    table.setPreferredSize(TABLE);
    content.add(split, BorderLayout.CENTER);
    content.add(bottom(), BorderLayout.SOUTH);
    setContentPane(content);
  }

  private JComponent chartSide() {
    charts.setName("Charts");
    charts.setToolTipText("Which chart is shown and exported");
    JLabel label = new JLabel("Chart:");
    label.setLabelFor(charts);
    JPanel choice = new JPanel(new FlowLayout(FlowLayout.LEADING));
    choice.add(label);
    choice.add(charts);
    JPanel side = new JPanel(new BorderLayout());
    side.add(choice, BorderLayout.NORTH);
    side.add(chart, BorderLayout.CENTER);
    return side;
  }

  private JComponent bottom() {
    progress.setName("progress");
    progress.getAccessibleContext().setAccessibleName("Progress of the study");
    progress.setStringPainted(true);
    JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, MARGIN, 0));
    buttons.add(start);
    buttons.add(cancel);
    buttons.add(export);
    JPanel bottom = new JPanel(new BorderLayout(MARGIN, 0));
    bottom.add(progress, BorderLayout.CENTER);
    bottom.add(buttons, BorderLayout.EAST);
    return bottom;
  }

  private void listen() {
    start.addActionListener(e -> begin());
    cancel.addActionListener(e -> runner.cancel());
    export.addActionListener(e -> export());
    charts.addActionListener(e -> showChart());
    getRootPane().setDefaultButton(start);
    CloseKeys.close(this);
    addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent e) {
            runner.cancel();
          }
        });
  }

  private void begin() {
    Study wished;
    try {
      wished = kind.study(options.plan());
    } catch (IllegalArgumentException e) {
      host.sorry(this, getTitle(), e.getMessage());
      return;
    }
    study = wished;
    rows.show(study, runner.start(study));
    offerCharts();
    showState();
  }

  private void offerCharts() {
    if (charts.getItemCount() == 0) {
      study.chartWords().forEach(charts::addItem);
    }
  }

  private void showChart() {
    if (study != null && charts.getSelectedItem() instanceof String word) {
      chart.show(results().chart(word));
    }
  }

  private StudyExport results() {
    return new StudyExport(study, rows.rows(), false);
  }

  private void showState() {
    boolean running = runner.isRunning();
    options.setOpen(!running);
    start.setEnabled(!running);
    cancel.setEnabled(running);
    export.setEnabled(!running && study != null && rows.getRowCount() > 0);
    if (!running) {
      progress.setString(study == null ? "" : rows.getRowCount() + " rows");
    }
  }

  private void export() {
    String word = (String) charts.getSelectedItem();
    Optional<Path> file = host.askFile(this, study.name() + FileEnding.CSV.dotted());
    if (file.isPresent()) {
      StudyExport results = results();
      pictures.write("Export", progress -> write(results, file.get(), word), written -> {});
    }
  }

  private static Path write(StudyExport results, Path file, String chart) {
    try {
      results.write(file, chart);
      return file;
    } catch (CannotWriteException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void openPictures(StudyRow row) {
    Study of = study;
    String name = row.trial().shape() + " " + row.trial().n() + ", seed " + row.trial().seed();
    pictures.submit(name, p -> of.pictures(row.trial(), p), made -> host.show(this, name, made));
  }

  /** Whether nothing runs and nothing is to be opened. */
  public boolean isIdle() {
    return !runner.isRunning() && pictures.isIdle();
  }

  /** Ends what runs, and closes. */
  @Override
  public void dispose() {
    runner.shutDown();
    pictures.shutDown();
    super.dispose();
  }

  /** Shows what the run does; on the event thread. */
  private final class Watcher implements StudyRunner.Watcher {
    @Override
    public void rows(List<StudyRow> more) {
      rows.add(more);
      showChart();
    }

    @Override
    public void progress(double fraction, String words) {
      progress.setValue((int) (STEPS * fraction));
      progress.setString(words);
    }

    @Override
    public void ended(List<StudyRow> inOrder) {
      rows.show(study, inOrder);
      showChart();
      showState();
    }

    @Override
    public void failed(Throwable cause) {
      showState();
      host.failed(StudyDialog.this, getTitle(), cause);
    }
  }

  /** Says why a row could not be opened. */
  private final class PictureFailures implements Jobs.Listener {
    @Override
    public void running(String what, double fraction) {}

    @Override
    public void idle() {}

    @Override
    public void failed(String what, Throwable cause) {
      host.failed(StudyDialog.this, what, cause);
    }
  }
}
