package dct.cli;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RegionShape;
import dct.experiment.generate.SiteShape;
import dct.experiment.study.AnnuliStudy;
import dct.experiment.study.PointsStudy;
import dct.experiment.study.PolygonsStudy;
import dct.experiment.study.SizeList;
import dct.experiment.study.Study;
import dct.experiment.study.StudyPlan;
import dct.experiment.study.ThesisTable;
import dct.io.PointFile;
import dct.io.format.Choice;
import dct.problem.Instance;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/** Which study, of what. */
final class StudyParameters {
  private static final long DEFAULT_SEED = 1;

  private final PositionalParamSpec what;
  private final PositionalParamSpec files;
  private final OptionSpec shapes;
  private final OptionSpec sizes;
  private final OptionSpec sets;
  private final OptionSpec seed;

  /** Declares them. */
  StudyParameters(Verb verb) {
    what =
        verb.parameter("points|polygons|annuli", "What is studied; annuli are regions with holes.");
    files = verb.parameters("FILE", "Polygons that are studied, too.");
    shapes =
        verb.option(
            "--shapes",
            "S,…",
            String.class,
            "Which random ones, by the words of dct generate; for points uniform by default, for"
                + " polygons and annuli all; none leaves only the files.");
    sizes =
        verb.option(
            "--sizes",
            "N,…",
            String.class,
            "The numbers of vertices, as 50,100,200 or 50-500:50, which is the default for points;"
                + " for polygons 10,20,50,100,200,500,1000, for annuli 50,100,200.");
    sets =
        verb.option(
            "--sets",
            "N",
            Integer.class,
            "How many of each shape and size; 5 by default for points, 100 for polygons, 40 for annuli.");
    seed =
        verb.option(
            "--seed", "N", Long.class, "From which all others follow, any whole number; 1.");
  }

  /**
   * The study that was asked for.
   *
   * @throws UsageException if there is none such
   * @throws dct.io.BadInputException if a file is no polygon
   */
  Study study() throws IOException {
    String word = what.getValue();
    return switch (word) {
      case "points" -> points();
      case "polygons" -> polygons();
      case "annuli" -> annuli();
      default ->
          throw UsageException.unknown("the study", word, List.of("points", "polygons", "annuli"));
    };
  }

  private Study annuli() {
    if (!fileNames().isEmpty()) {
      throw new UsageException("the study of annuli takes no files, leave them out");
    }
    List<String> known = RegionShape.words();
    return new AnnuliStudy(
        plan(known, known, AnnuliStudy.SIZES, PolygonShape.MOST, AnnuliStudy.SETS));
  }

  private Study points() {
    if (!fileNames().isEmpty()) {
      throw new UsageException("the study of points takes no files, leave them out");
    }
    List<String> known = SiteShape.words();
    List<String> usual = List.of(ThesisTable.SHAPE);
    return new PointsStudy(
        plan(known, usual, ThesisTable.sizes(), SiteShape.MOST, ThesisTable.SETS));
  }

  private Study polygons() throws IOException {
    List<String> known = PolygonShape.words();
    StudyPlan plan = plan(known, known, PolygonsStudy.SIZES, PolygonShape.MOST, PolygonsStudy.SETS);
    return new PolygonsStudy(plan, polygonFiles());
  }

  private StudyPlan plan(
      List<String> known, List<String> usual, List<Integer> usualSizes, int most, int usualSets) {
    String sizeList = sizes.getValue();
    Long asked = seed.getValue();
    return new StudyPlan(
        chosenShapes(known, usual),
        sizeList == null ? usualSizes : sizes(sizeList, most),
        chosenSets(usualSets),
        Objects.requireNonNullElse(asked, DEFAULT_SEED));
  }

  private static List<Integer> sizes(String text, int most) {
    try {
      return SizeList.parse(text, most);
    } catch (IllegalArgumentException e) {
      throw new UsageException("--sizes " + e.getMessage());
    }
  }

  private int chosenSets(int usual) {
    Integer asked = sets.getValue();
    int number = Objects.requireNonNullElse(asked, usual);
    if (number < 1) {
      throw new UsageException("--sets " + number + " is none, use 1 or more");
    }
    return number;
  }

  private List<String> chosenShapes(List<String> known, List<String> usual) {
    String asked = shapes.getValue();
    if (asked == null) {
      return usual;
    }
    if (asked.equals("none") && !fileNames().isEmpty()) {
      return List.of();
    }
    Set<String> chosen = new LinkedHashSet<>();
    for (String word : asked.split(",", -1)) {
      if (!known.contains(word)) {
        throw UsageException.unknown("--shapes", word, known);
      }
      chosen.add(word);
    }
    return List.copyOf(chosen);
  }

  private List<String> fileNames() {
    List<String> names = files.getValue();
    return Objects.requireNonNullElse(names, List.of());
  }

  private Map<String, Instance.OfPolygon> polygonFiles() {
    Map<String, Instance.OfPolygon> polygons = new LinkedHashMap<>();
    for (String name : fileNames()) {
      polygons.put(
          name,
          (Instance.OfPolygon)
              PointFile.read(
                      InputParameters.path(name), Choice.NONE.as(Domain.POLYGON), Progress.NONE)
                  .instance(Progress.NONE));
    }
    return polygons;
  }
}
