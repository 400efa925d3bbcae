package dct.ui;

import dct.ui.command.CommandRegistry;
import dct.ui.job.Jobs;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.Timer;

/** The line under the canvas: what the next click does, and what is going on in the background. */
final class StatusBar extends JPanel {
  private static final long serialVersionUID = 1L;

  /** Work that is done sooner is not worth a flicker. */
  private static final int PATIENCE_MILLIS = 150;

  private static final int GAP = 12;

  private final JLabel message = new JLabel(" ");
  private final JLabel aside = new JLabel();
  private final JLabel snap = new JLabel();
  private final JLabel zoom = new JLabel();
  private final JLabel work = new JLabel();
  private final JProgressBar bar = new JProgressBar(0, 1000);
  private final JPanel running = new JPanel(new FlowLayout(FlowLayout.TRAILING, 8, 0));
  private final JobList list;
  private final Timer patience;
  private String hint = "";
  private transient Object state; // of the document when the message was shown
  private transient Object latest; // as it is now

  /** A status line that shows these jobs. */
  StatusBar(Jobs jobs) {
    super(new BorderLayout(GAP, 0));
    setBorder(BorderFactory.createEmptyBorder(5, GAP, 5, GAP));
    message.setName("status");
    message.getAccessibleContext().setAccessibleName("Status");
    zoom.setName("zoom");
    zoom.getAccessibleContext().setAccessibleDescription("Scale of the canvas");
    list = new JobList(jobs);
    JButton stop = new JButton("Cancel");
    stop.setName("cancelJob");
    stop.setToolTipText("Stops what is going on (Esc)");
    stop.setMargin(new java.awt.Insets(1, 8, 1, 8));
    stop.addActionListener(e -> jobs.cancelCurrent());
    bar.getAccessibleContext().setAccessibleName("Progress");
    running.add(work);
    running.add(bar);
    running.add(list);
    running.add(stop);
    Box right = Box.createHorizontalBox(); // all on one line with the message
    right.add(running);
    aside.setName("aside");
    aside.getAccessibleContext().setAccessibleDescription("What has no room on the canvas");
    snap.setName("snap");
    for (JLabel label : List.of(aside, snap, zoom)) {
      label.setBorder(BorderFactory.createEmptyBorder(0, GAP, 0, 0)); // none where it is hidden
      right.add(label);
    }
    add(message, BorderLayout.CENTER);
    add(right, BorderLayout.EAST);
    // The canvas above keeps its size when the progress comes and goes.
    setPreferredSize(new Dimension(0, getPreferredSize().height));
    setAside("");
    setSnap("");
    running.setVisible(false);
    patience = new Timer(PATIENCE_MILLIS, e -> running.setVisible(true));
    patience.setRepeats(false);
  }

  /**
   * Shows what the next click does. A message stays until there is something else to show: another
   * hint, or another state of the document.
   */
  void setHint(String text, Object document) {
    latest = document;
    if (!text.equals(hint) || latest != state) {
      hint = text;
      state = latest;
      show(text);
    }
  }

  /** Shows a text; a screen reader hears of it as the new description of the status. */
  private void show(String text) {
    message.setText(text);
    message.setToolTipText(text); // where it does not fit
    message.getAccessibleContext().setAccessibleDescription(text);
  }

  /** Shows a message about the document as it is. */
  void say(String text) {
    state = latest;
    show(text);
  }

  /** Shows what has no room on the canvas. */
  void setAside(String words) {
    show(aside, words);
  }

  /** Shows what places snap to. */
  void setSnap(String words) {
    show(snap, words);
  }

  /** Empty labels would leave gaps. */
  private static void show(JLabel label, String words) {
    label.setText(words);
    label.setVisible(!words.isEmpty());
  }

  /** Shows the scale of the canvas. */
  void setZoom(double scale) {
    double percent = scale * 100;
    zoom.setText(
        percent >= 1 && percent < 1e6
            ? String.format(Locale.ROOT, "%.0f %%", percent)
            : String.format(Locale.ROOT, "%.2g %%", percent));
  }

  /** Shows work in progress, once it has taken a while; the fraction is negative if unknown. */
  void running(String what, double fraction) {
    work.setText(what);
    bar.setIndeterminate(fraction < 0);
    bar.setValue((int) Math.round(1000 * fraction));
    boolean begins = fraction < 0; // patience is for each job, not for many short ones in a row
    if (!running.isVisible() && (begins || !patience.isRunning())) {
      patience.restart();
    }
  }

  /** Shows which jobs wait. */
  void listed() {
    list.refresh();
  }

  /** Offers the command that opens the list of the jobs. */
  void offer(CommandRegistry commands) {
    commands
        .add(
            "Background Work",
            "ctrl J",
            "Lists what goes on and what waits, each to be cancelled",
            () -> list.open(list.isShowing() ? list : message))
        .enabledWhen(list::hasJobs);
  }

  /** Shows that nothing is going on. */
  void idle() {
    patience.stop();
    running.setVisible(false);
    bar.setIndeterminate(false);
  }
}
