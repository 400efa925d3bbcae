package dct.cli;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import dct.core.Progress;
import dct.core.geometry.Region;
import dct.core.triangulate.Domain;
import dct.experiment.generate.Area;
import dct.experiment.generate.CannotGenerateException;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RegionShape;
import dct.experiment.generate.SiteShape;
import dct.io.PointDocument;
import dct.render.Figure;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** {@code dct generate}: seeded random input. */
final class GenerateCommand extends Verb {
  private static final long DEFAULT_SEED = 1;
  private static final Pattern AREA = Pattern.compile("(\\d{1,9})x(\\d{1,9})");

  private final PositionalParamSpec what =
      parameter("points|polygon|region", "What to make: points, polygon or region.");
  private final OptionSpec n = requiredOption("-n", "N", Integer.class, "How many vertices.");
  private final OptionSpec shape =
      option(
          "--shape",
          "S",
          Stream.of(SiteShape.words(), PolygonShape.words(), RegionShape.words())
              .flatMap(List::stream)
              .distinct()
              .toList(),
          "One of those above; " + defaults() + " by default.");
  private final OptionSpec seed =
      option(
          "--seed", "N", Long.class, "Which of the random ones, any whole number; 1 by default.");
  private final OptionSpec holes =
      option("--holes", "K", Integer.class, "Of a region: how many holes; 1 by default.");
  private final OptionSpec area =
      option(
          "--area",
          "WxH",
          String.class,
          "Where they lie: 0 ≤ x < W and 0 ≤ y < H. By default 1000x700, both sides doubled until"
              + " so many have ample room.");
  private final OptionSpec real =
      flag("--real", "Real coordinates, instead of whole numbers only.");
  private final OptionSpec output =
      outputs(
          false,
          "Where to: "
              + Output.endings()
              + "; - is text on standard output, which is the default."
              + " May repeat.");

  private final PictureParameters picture = new PictureParameters(this);

  private final OptionSpec json =
      flag("--json", "Print what was made as one JSON object; needs an -o that is a file.");

  GenerateCommand(Console console) {
    super(console, description());
    examples(
        "dct generate points -n 500 --shape clusters --seed 7 -o mine_pointbased.txt",
        "dct generate polygon -n 100 | dct triangulate - --optimize odd",
        "dct generate region -n 200 --holes 4 --shape holes -o plate_region.txt");
  }

  private static String defaults() {
    return SiteShape.UNIFORM.word()
        + ", "
        + PolygonShape.TWO_OPT.word()
        + " or "
        + RegionShape.ANNULUS.word();
  }

  private static String[] description() {
    List<String> lines = new ArrayList<>();
    lines.add("Makes random points, all different, the vertices of a random simple polygon, or");
    lines.add("a random region with holes.");
    lines.add("The same options make the same on every machine.");
    lines.add("");
    lines.add("Shapes of points:");
    for (SiteShape each : SiteShape.values()) {
      lines.add(line(each.word(), each.description()));
    }
    lines.add("Shapes of polygons:");
    for (PolygonShape each : PolygonShape.values()) {
      lines.add(line(each.word(), each.description()));
    }
    lines.add("Shapes of regions:");
    for (RegionShape each : RegionShape.values()) {
      lines.add(line(each.word(), each.description()));
    }
    lines.add("");
    return lines.toArray(String[]::new);
  }

  private static String line(String word, String description) {
    return String.format(Locale.ROOT, "  %-20s%s", word, description);
  }

  @Override
  public Integer call() throws IOException {
    List<Output> outputs = outputsOf(output);
    Figure figure = picture.figure(false);
    if (isSet(json) && (outputs.isEmpty() || outputs.contains(Output.STANDARD))) {
      throw new UsageException("--json and the points both want standard output, use -o FILE");
    }
    try (Interruption interruption = new Interruption()) {
      PointDocument document = document(progress(interruption, true));
      checkNames(outputs, document.declared().orElseThrow());
      for (Output file : outputs.isEmpty() ? List.of(Output.STANDARD) : outputs) {
        PointOutput.write(document, file, figure, console());
      }
      if (isSet(json)) {
        console().print(json(document, outputs).toString());
      }
      return interruption.status();
    }
  }

  private JsonObject json(PointDocument document, List<Output> outputs) {
    JsonObject object = new JsonObject();
    object.addProperty("kind", document.declared().orElseThrow().word());
    object.addProperty("shape", shapeWord());
    object.addProperty("seed", seed());
    object.addProperty("vertices", document.points().size());
    JsonArray files = new JsonArray();
    outputs.forEach(output -> files.add(output.name()));
    object.add("outputs", files);
    return object;
  }

  private String shapeWord() {
    String kind = what.getValue();
    String usual =
        switch (kind) {
          case "points" -> SiteShape.UNIFORM.word();
          case "region" -> RegionShape.ANNULUS.word();
          default -> PolygonShape.TWO_OPT.word();
        };
    String wished = shape.getValue();
    return Objects.requireNonNullElse(wished, usual);
  }

  private PointDocument document(Progress progress) {
    String word = what.getValue();
    try {
      return switch (word) {
        case "points" -> points(progress);
        case "polygon" -> polygon(progress);
        case "region" -> region(progress);
        default ->
            throw UsageException.unknown("the kind", word, List.of("points", "polygon", "region"));
      };
    } catch (CannotGenerateException e) {
      throw new UsageException(e.getMessage());
    }
  }

  private PointDocument points(Progress progress) {
    String word = shapeWord();
    SiteShape wished = SiteShape.of(word).orElseThrow(() -> unknown(word, SiteShape.words()));
    int count = n.getValue();
    return PointDocument.of(
        STANDARD_STREAM,
        Domain.SITES,
        wished.generate(count, area(wished.areaFor(count)), seed(), progress));
  }

  private PointDocument polygon(Progress progress) {
    String word = shapeWord();
    PolygonShape wished =
        PolygonShape.of(word).orElseThrow(() -> unknown(word, PolygonShape.words()));
    int count = n.getValue();
    return PointDocument.of(
        STANDARD_STREAM,
        Domain.POLYGON,
        wished.generate(count, area(wished.areaFor(count)), seed(), progress).points());
  }

  private PointDocument region(Progress progress) {
    if (isSet(area) || isSet(real)) {
      throw new UsageException("--area and --real are not for regions, leave them out");
    }
    String word = shapeWord();
    RegionShape wished = RegionShape.of(word).orElseThrow(() -> unknown(word, RegionShape.words()));
    Integer count = holes.getValue();
    Region region =
        wished.generate(n.getValue(), Objects.requireNonNullElse(count, 1), seed(), progress);
    return PointDocument.of(STANDARD_STREAM, region.rings());
  }

  private static UsageException unknown(String word, List<String> words) {
    return UsageException.unknown("--shape", word, words);
  }

  private long seed() {
    Long wished = seed.getValue();
    return Objects.requireNonNullElse(wished, DEFAULT_SEED);
  }

  private Area area(Area ample) {
    String wished = area.getValue();
    Area area = wished == null ? ample : parsed(wished);
    return isSet(real) ? area.real() : area;
  }

  private static Area parsed(String wished) {
    Matcher sides = AREA.matcher(wished);
    if (!sides.matches()) {
      throw new UsageException(
          "--area " + wished + " is not a width and a height such as 1000x700");
    }
    return new Area(Integer.parseInt(sides.group(1)), Integer.parseInt(sides.group(2)), true);
  }
}
