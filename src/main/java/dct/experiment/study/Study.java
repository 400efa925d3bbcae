package dct.experiment.study;

import dct.core.Progress;
import dct.render.chart.Chart;
import java.util.List;

/**
 * A study: what it tries, what it counts in each trial, and what it makes of the counts.
 *
 * <p>Implementations are immutable; trials run on several threads at once.
 */
public interface Study {

  /** The study's word on the command line. */
  String name();

  /** The trials, all different, in the order of the table. */
  List<Trial> trials();

  /** The names of the numbers that each row has. */
  List<String> counts();

  /** The names of the steps whose time each row has. */
  List<String> steps();

  /** About how much work a trial is, in any unit. */
  double cost(Trial trial);

  /**
   * Runs one trial.
   *
   * @throws java.util.concurrent.CancellationException if cancelled; there is no half a row
   */
  StudyRow run(Trial trial, Progress progress);

  /** Tables of these rows, the first being the study's own; some may have no rows. */
  List<Table> tables(List<StudyRow> rows);

  /** The words of the charts, the first being the one to show unless another is asked for. */
  List<String> chartWords();

  /** The charts of these rows, in the order of their words; some may have no values. */
  List<Chart> charts(List<StudyRow> rows);

  /**
   * Pictures of a trial, before and after, for somebody who wants to see what its row counts.
   *
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  List<StudyPicture> pictures(Trial trial, Progress progress);
}
