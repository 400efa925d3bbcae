package dct.cli;

import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import java.io.IOException;
import java.util.Locale;
import picocli.CommandLine.Model.OptionSpec;

/** {@code dct check}: whether an input can be triangulated. */
final class CheckCommand extends Verb {
  private final InputParameters input = new InputParameters(this);
  private final OptionSpec quiet = flag("--quiet", "Print nothing; the exit status tells.");

  CheckCommand(Console console) {
    super(console, "Is it a simple polygon, or usable sites? Says what is wrong, and where.");
  }

  @Override
  boolean isSilent() {
    return isSet(quiet);
  }

  @Override
  public Integer call() throws IOException {
    Shape shape = Shape.of(input.read());
    if (!isSet(quiet)) {
      String found = shape.polygon() != null ? found(shape.polygon()) : found(shape.sites());
      console().print(input.name() + ": " + found);
    }
    return CommandLineProgram.DONE;
  }

  private static String found(SimplePolygon polygon) {
    return String.format(
        Locale.ROOT,
        "a simple polygon with %d vertices, %s",
        polygon.size(),
        polygon.isClockwise() ? "clockwise" : "counter-clockwise");
  }

  private static String found(Sites sites) {
    return sites.size() + " usable sites" + Summary.merged(sites.merged());
  }
}
