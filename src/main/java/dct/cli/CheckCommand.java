package dct.cli;

import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import java.io.IOException;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code dct check}: whether an input can be triangulated. */
@Command(
    name = "check",
    description = "Is it a simple polygon, or usable sites? Says what is wrong, and where.")
final class CheckCommand implements Callable<Integer> {
  private final Console console;

  @Mixin private InputOptions input;

  @Option(names = "--quiet", description = "Print nothing; the exit status tells.")
  private boolean quiet;

  CheckCommand(Console console) {
    this.console = console;
  }

  @Override
  public Integer call() throws IOException {
    Shape shape = Shape.of(input.read(console));
    if (!quiet) {
      String found = shape.polygon() != null ? found(shape.polygon()) : found(shape.sites());
      console.print(input.name() + ": " + found);
    }
    return CommandLineProgram.DONE;
  }

  private static String found(SimplePolygon polygon) {
    return "a simple polygon with %d vertices, %s"
        .formatted(polygon.size(), polygon.isClockwise() ? "clockwise" : "counter-clockwise");
  }

  private static String found(Sites sites) {
    return sites.size() + " usable sites" + Summary.merged(sites.merged());
  }
}
