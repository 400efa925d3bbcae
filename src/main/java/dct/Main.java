package dct;

import dct.cli.CommandLineProgram;
import dct.cli.Console;
import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** Starts the program: the window without arguments, the command line with them. */
public final class Main {

  private Main() {}

  /** Does what the arguments ask for. */
  public static void main(String[] args) {
    System.setProperty("java.awt.headless", "true");
    System.exit(CommandLineProgram.run(console(), args));
  }

  /** The process' own streams; System.out would swallow errors of writing. */
  private static Console console() {
    PrintStream err =
        new PrintStream(new FileOutputStream(FileDescriptor.err), true, StandardCharsets.UTF_8);
    return new Console(
        new FileInputStream(FileDescriptor.in),
        new BufferedOutputStream(new FileOutputStream(FileDescriptor.out), 1 << 16),
        err);
  }
}
