package dct.ui.dialog;

import dct.problem.Solution;
import dct.ui.session.UserFolder;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import javax.swing.SwingUtilities;

/**
 * Faults of the program itself: the user reads one sentence, the details go to a file in the user's
 * own folder. Of the file there are at most two generations of {@link #MOST_BYTES} and one fault.
 */
public final class FaultLog implements Thread.UncaughtExceptionHandler {
  static final long MOST_BYTES = 1 << 18;

  private final Path file;
  private final Set<String> told = new HashSet<>(); // places of faults that were shown already

  /** A log in this folder, which need not be there yet. */
  FaultLog(Path folder) {
    file = folder.resolve("faults.log");
  }

  /** The log of the user who runs the program. */
  public static FaultLog ofUser() {
    return new FaultLog(
        folder(System.getProperty("os.name"), System.getenv(), System.getProperty("user.home")));
  }

  /** Where logs belong on a system of this name. */
  static Path folder(String system, Map<String, String> environment, String home) {
    return UserFolder.of(system, environment, home, "Library/Logs");
  }

  /** Keeps a fault; returns what to tell the user. */
  synchronized String keep(Throwable fault) {
    String sentence = "This should not have happened: " + fault + ".";
    try {
      Files.createDirectories(file.getParent());
      if (Files.exists(file) && Files.size(file) > MOST_BYTES) {
        Files.move(file, file.resolveSibling("faults.1.log"), StandardCopyOption.REPLACE_EXISTING);
      }
      Files.writeString(file, text(fault), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      return sentence + " Please report it; the details are in " + file + ".";
    } catch (IOException e) {
      return sentence + " Please report it.";
    }
  }

  private static String text(Throwable fault) {
    StringWriter text = new StringWriter();
    PrintWriter out = new PrintWriter(text);
    out.println(
        Instant.now() + ", version " + Solution.programVersion() + ", Java " + Runtime.version());
    fault.printStackTrace(out);
    out.flush();
    return text.toString();
  }

  /** Keeps what no part of the program has caught, and shows it once for each place. */
  @Override
  public void uncaughtException(Thread thread, Throwable fault) {
    String sentence = keep(fault);
    if (isNew(fault)) {
      SwingUtilities.invokeLater(() -> Ask.sorry(null, "Fault", sentence));
    }
  }

  /** A painter that fails does so at every repaint, and a dialog that is closed calls for one. */
  private synchronized boolean isNew(Throwable fault) {
    StackTraceElement[] trace = fault.getStackTrace();
    return told.add(fault.getClass() + (trace.length == 0 ? "" : " at " + trace[0]));
  }
}
