package dct;

import dct.cli.CommandLineProgram;
import dct.cli.Console;
import dct.cli.FileArguments;
import dct.ui.Launcher;
import java.awt.AWTError;
import java.awt.HeadlessException;
import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * Starts the program: the window without arguments or with the names of files, the command line
 * with anything else.
 */
public final class Main {
  private static final int OUTPUT_BUFFER = 1 << 16;

  private Main() {}

  /** Does what the arguments ask for. */
  public static void main(String[] args) {
    Optional<List<Path>> files = FileArguments.of(args);
    if (files.isPresent()) {
      Window.open(files.get());
    } else {
      System.setProperty("java.awt.headless", "true"); // drawing needs no display
      Console console = console();
      // In a thread that runs at the end of the program, System.exit would wait for ever.
      Thread.setDefaultUncaughtExceptionHandler(
          (thread, e) -> Runtime.getRuntime().halt(CommandLineProgram.failed(console, e)));
      System.exit(CommandLineProgram.run(console, args));
    }
  }

  /** The process' own streams; System.out would swallow errors of writing. */
  private static Console console() {
    return new Console(
        new FileInputStream(FileDescriptor.in),
        new BufferedOutputStream(new FileOutputStream(FileDescriptor.out), OUTPUT_BUFFER),
        errors(),
        isTerminal());
  }

  /** From JDK 22 on there is a console also where there is no terminal, and it says so. */
  @SuppressWarnings("SystemConsoleNull") // on older ones it is null without a terminal
  private static boolean isTerminal() {
    java.io.Console console = System.console();
    try {
      return console != null
          && (boolean) java.io.Console.class.getMethod("isTerminal").invoke(console);
    } catch (ReflectiveOperationException e) {
      return true;
    }
  }

  private static PrintStream errors() {
    return new PrintStream(new FileOutputStream(FileDescriptor.err), true, StandardCharsets.UTF_8);
  }

  /** A class of its own, so that the command line starts without AWT. */
  private static final class Window {
    private Window() {}

    static void open(List<Path> files) {
      try {
        Launcher.open(files);
      } catch (HeadlessException | AWTError | LinkageError e) { // depends on what is missing
        errors()
            .println("dct: there is no display for the window; use the command line, dct --help");
        System.exit(CommandLineProgram.FAILED);
      }
    }
  }
}
