package dct.cli;

import com.google.gson.JsonObject;
import dct.core.Progress;
import dct.io.text.BadInputException;
import dct.io.text.Shown;
import dct.problem.Instance;
import java.io.IOException;
import picocli.CommandLine.Model.OptionSpec;

/** {@code dct check}: whether an input can be triangulated. */
final class CheckCommand extends Verb {
  private final InputParameters input = new InputParameters(this);
  private final OptionSpec json =
      flag(
          "--json", "Print what was found as one JSON object, also where the input is not usable.");
  private final OptionSpec quiet = flag("--quiet", "Print nothing; the exit status tells.");

  CheckCommand(Console console) {
    super(
        console,
        "Is it a simple polygon, usable sites, or a region? Says what is wrong, and where.");
    examples("dct check samples/comb_polygonbased.txt --json");
  }

  @Override
  boolean isSilent() {
    return isSet(quiet);
  }

  @Override
  public Integer call() throws IOException {
    try {
      Instance instance = input.instance(Progress.NONE);
      if (isSet(json)) {
        console().print(json(instance).toString());
      } else if (!isSet(quiet)) {
        console().print(Shown.harmless(input.name()) + ": " + instance.description());
      }
      return CommandLineProgram.DONE;
    } catch (BadInputException e) {
      if (isSet(json)) {
        console().print(json(e).toString());
      }
      throw e;
    }
  }

  private JsonObject json(Instance instance) {
    JsonObject object = new JsonObject();
    object.addProperty("input", input.name());
    object.addProperty("usable", true);
    object.addProperty("kind", instance.domain().word());
    object.addProperty("vertices", instance.size());
    object.addProperty("merged", instance.merged());
    if (instance instanceof Instance.OfPolygon of) {
      object.addProperty("clockwise", of.polygon().isClockwise());
    }
    if (instance instanceof Instance.OfRegion of) {
      object.addProperty("holes", of.region().holes());
      object.addProperty("sites", of.region().sites());
      object.addProperty("fixed", of.region().rings().fixedCount());
    }
    return object;
  }

  private JsonObject json(BadInputException e) {
    JsonObject object = new JsonObject();
    object.addProperty("input", input.name());
    object.addProperty("usable", false);
    if (e.line() > 0) {
      object.addProperty("line", e.line());
    }
    object.addProperty("fault", e.fault());
    return object;
  }
}
