package dct.ui.dialog;

import dct.core.geometry.Defect;
import dct.core.geometry.InvalidGeometryException;
import dct.experiment.generate.CannotGenerateException;
import dct.io.text.BadInputException;
import java.awt.Component;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;

/** Says in one sentence why a job failed. */
public final class Failures {
  private final Component parent;
  private final List<Remedy> remedies;

  /**
   * What can be done about a polygon that is not simple.
   *
   * @param name what a button says
   * @param suits whether it is of use against a defect
   * @param action what it does about it
   */
  public record Remedy(String name, Predicate<Defect> suits, Consumer<Defect> action) {}

  /**
   * Failures shown over a window.
   *
   * @param remedies are offered where a polygon is not simple
   */
  public Failures(Component parent, List<Remedy> remedies) {
    this.parent = parent;
    this.remedies = List.copyOf(remedies);
  }

  /** Shows one dialog. */
  public void show(String what, Throwable cause) {
    if (cause instanceof InvalidGeometryException e) {
      show(what, e.defect());
    } else if (cause instanceof BadInputException e) {
      Ask.sorry(parent, what, sentence(e));
    } else if (cause instanceof CannotGenerateException e) {
      Ask.sorry(parent, what, "Nothing was changed: " + e.getMessage() + ".");
    } else if (cause instanceof UncheckedIOException e) {
      Ask.sorry(parent, what, e.getCause().getMessage());
    } else if (cause instanceof OutOfMemoryError) {
      Ask.sorry(parent, what, "There is not enough memory; give Java more with -Xmx.");
    } else {
      Ask.sorry(parent, what, FaultLog.ofUser().keep(cause));
    }
  }

  private void show(String what, Defect defect) {
    boolean hasPlace =
        defect.kind() != Defect.Kind.TOO_FEW && defect.kind() != Defect.Kind.COLLINEAR;
    String sentence = "The polygon is not simple: " + defect.message() + ".";
    if (!hasPlace) {
      Ask.sorry(parent, what, "There is no polygon to triangulate: " + defect.message() + ".");
    } else {
      List<Remedy> useful = remedies.stream().filter(r -> r.suits().test(defect)).toList();
      String[] names = useful.stream().map(Remedy::name).toArray(String[]::new);
      Ask.offer(parent, what, sentence, names)
          .ifPresent(chosen -> useful.get(chosen).action().accept(defect));
    }
  }

  /** The file's own name, the line, the fault and its cure. */
  private static String sentence(BadInputException e) {
    Path name = Path.of(e.file()).getFileName();
    String file = name == null ? e.file() : name.toString();
    return file + (e.line() > 0 ? ", line " + e.line() : "") + ": " + e.fault() + ".";
  }
}
