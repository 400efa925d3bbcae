package dct.cli;

import dct.experiment.generate.CannotGenerateException;
import dct.experiment.study.MarkdownText;
import dct.experiment.study.Study;
import dct.experiment.study.StudyExport;
import dct.experiment.study.StudyFile;
import dct.experiment.study.StudyRow;
import dct.experiment.study.StudyRun;
import dct.io.CannotWriteException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine.Model.OptionSpec;

/** {@code dct experiment}: a study, its rows, tables and charts. */
final class ExperimentCommand extends Verb {
  private static final int MOST_THREADS = 1024;

  private final StudyParameters study = new StudyParameters(this);
  private final OptionSpec threads =
      option(
          "--threads",
          "N",
          Integer.class,
          "How many trials run at the same time; as many as there are cores by default. The rows do"
              + " not depend on it.");
  private final OptionSpec times =
      flag(
          "--times",
          "Keep the time of each step, too; only without it the same command gives the same bytes.");
  private final StudyOutputs outputs = new StudyOutputs(this);
  private final OptionSpec quiet = flag("--quiet", "Print neither tables nor progress.");

  ExperimentCommand(Console console) {
    super(
        console,
        "Runs a study: many random sets of sites, polygons or regions, and how many of their"
            + " vertices become even.",
        "A file that ends in .csv keeps the rows as they come: after Ctrl+C, and with more sets or"
            + " sizes, the same command goes on from it and computes no row again. Each row has its"
            + " seed, with which dct generate makes the same input.");
    examples("dct experiment points --sizes 50-100:50 --sets 2 -o rows.csv -o table.md");
  }

  @Override
  public Integer call() throws IOException {
    Study chosen = study.study();
    int workers = workers();
    outputs.check(chosen);
    try (Interruption interruption = new Interruption()) {
      List<StudyRow> rows = rows(chosen, workers, interruption);
      outputs.write(new StudyExport(chosen, rows, isSet(times)));
      if (!isSet(quiet) && !outputs.printRows()) {
        outputs.print(MarkdownText.of(chosen.tables(rows)));
      }
      return ended(chosen, rows);
    }
  }

  /** The rows, kept in their file if there is one. */
  private List<StudyRow> rows(Study chosen, int workers, Interruption interruption)
      throws IOException {
    Optional<StudyFile> file = outputs.open(chosen, isSet(times));
    try {
      List<StudyRow> rows = rows(chosen, workers, file, interruption);
      if (file.isPresent()) {
        file.get().sort(chosen.trials());
      }
      return rows;
    } finally {
      if (file.isPresent()) {
        file.get().close();
      }
    }
  }

  private List<StudyRow> rows(
      Study chosen, int workers, Optional<StudyFile> file, Interruption interruption)
      throws IOException {
    boolean isTimed = isSet(times);
    TimeLeft progress = new TimeLeft(console().err(), !isSet(quiet), interruption);
    try {
      List<StudyRow> rows =
          StudyRun.run(
              chosen,
              file.map(StudyFile::rows).orElse(List.of()),
              workers,
              row -> keep(file, row),
              progress);
      return isTimed ? rows : rows.stream().map(StudyRow::withoutTimes).toList();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    } catch (CannotGenerateException e) {
      throw new UsageException(e.getMessage());
    }
  }

  private static void keep(Optional<StudyFile> file, StudyRow row) {
    file.ifPresent(
        f -> {
          try {
            f.add(row);
          } catch (CannotWriteException e) {
            throw new UncheckedIOException(e);
          }
        });
  }

  private int ended(Study chosen, List<StudyRow> rows) {
    int all = chosen.trials().size();
    if (rows.size() == all) {
      return CommandLineProgram.DONE;
    }
    console()
        .err()
        .println(
            String.format(
                Locale.ROOT,
                "dct experiment: stopped with %d of %d rows; %s",
                rows.size(),
                all,
                outputs.rowFile().isPresent()
                    ? "the same command goes on from there"
                    : "with -o FILE.csv the same command could go on from there"));
    return Interruption.STATUS;
  }

  private int workers() {
    Integer asked = threads.getValue();
    int workers = asked == null ? Runtime.getRuntime().availableProcessors() : asked;
    if (workers < 1 || workers > MOST_THREADS) {
      throw new UsageException("--threads " + workers + " is not from 1 to " + MOST_THREADS);
    }
    return workers;
  }
}
