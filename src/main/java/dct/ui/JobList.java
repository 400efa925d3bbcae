package dct.ui;

import dct.ui.job.Jobs;
import dct.ui.job.Jobs.Task;
import java.awt.Component;
import java.awt.Insets;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/** The button that says how many jobs wait, and the list of all jobs that it opens. */
final class JobList extends JButton {
  private static final long serialVersionUID = 1L;

  private final transient Jobs jobs;

  /** A button for these jobs; it is hidden while none waits. */
  JobList(Jobs jobs) {
    this.jobs = jobs;
    setName("jobs");
    setMargin(new Insets(1, 8, 1, 8));
    addActionListener(e -> open(this));
    refresh();
  }

  /** Shows how many jobs wait now. */
  void refresh() {
    List<String> waiting =
        jobs.tasks().stream().filter(task -> !task.hasBegun()).map(Task::what).toList();
    setVisible(!waiting.isEmpty());
    setText(waiting.size() + " waiting…");
    String names = String.join(", ", waiting);
    setToolTipText(names.isEmpty() ? null : "Waiting: " + names);
  }

  /** Whether anything goes on. */
  boolean hasJobs() {
    return !jobs.tasks().isEmpty();
  }

  /** Opens the list of all jobs over a component; an item cancels its job. */
  void open(Component over) {
    JPopupMenu list = new JPopupMenu("Background work");
    list.setName("jobList");
    for (Task task : jobs.tasks()) {
      list.add(item(task));
    }
    list.show(over, 0, -list.getPreferredSize().height);
  }

  private static JMenuItem item(Task task) {
    boolean fixed = task.isWrite(); // what is to be written is written
    String state = task.hasBegun() ? "running" : "waiting";
    JMenuItem item =
        new JMenuItem(
            String.format(Locale.ROOT, fixed ? "%s (%s)" : "Cancel %s (%s)", task.what(), state));
    item.setName("job " + task.what());
    item.setEnabled(!fixed);
    item.addActionListener(e -> task.cancel());
    return item;
  }
}
