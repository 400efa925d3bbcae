package dct.experiment.study;

import dct.core.Progress;
import dct.core.geometry.Rings;
import dct.experiment.generate.RegionShape;
import dct.problem.Instance;
import dct.render.chart.Chart;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The experiment on polygons carried to regions with holes, annuli above all: the even vertices of
 * three triangulations, each also after Scan-Flip, and of the best one found, against the numbers
 * of vertices and of holes, and of rings whose length 3 does not divide.
 *
 * <p>An annulus has one hole; of the other shapes set s has 1 + (s − 1) mod 4 of them, so that
 * {@code dct generate region} makes each row's region again.
 */
public final class AnnuliStudy implements Study {
  /** The sizes unless others are asked for. */
  public static final List<Integer> SIZES = List.of(50, 100, 200);

  /** The number of regions of each shape and size unless another is asked for. */
  public static final int SETS = 40;

  /** The most holes of a region. */
  static final int MOST_HOLES = 4;

  static final String HOLES = "holes";
  static final String INDIVISIBLE = "rings_not_divisible_by_3";
  private static final int THREE = 3;

  private final StudyPlan plan;

  /** The study of these regions. */
  public AnnuliStudy(StudyPlan plan) {
    this.plan = plan;
  }

  @Override
  public String name() {
    return "annuli";
  }

  @Override
  public List<Trial> trials() {
    return plan.trials();
  }

  @Override
  public List<String> counts() {
    List<String> counts = new ArrayList<>(List.of(HOLES, INDIVISIBLE));
    counts.addAll(PolygonsColumns.ofMethods());
    return counts;
  }

  @Override
  public List<String> steps() {
    return OutlineRun.steps();
  }

  @Override
  public double cost(Trial trial) {
    return (double) trial.n() * trial.n(); // the proofs outweigh the rest
  }

  @Override
  public StudyRow run(Trial trial, Progress progress) {
    Laps laps = new Laps();
    Instance.OfRegion instance = laps.time("generate", () -> instance(trial, progress));
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put(HOLES, instance.region().holes());
    counts.put(INDIVISIBLE, indivisible(instance.region().rings()));
    OutlineRun.count(instance, counts, laps, progress);
    return new StudyRow(trial, counts, laps.millis());
  }

  private static Instance.OfRegion instance(Trial trial, Progress progress) {
    RegionShape shape = RegionShape.of(trial.shape()).orElseThrow();
    int holes = shape == RegionShape.ANNULUS ? 1 : 1 + (trial.set() - 1) % MOST_HOLES;
    return Instance.of(trial.shape(), shape.generate(trial.n(), holes, trial.seed(), progress));
  }

  private static int indivisible(Rings rings) {
    int count = 0;
    for (int r = 0; r < rings.count(); r++) {
      count += rings.size(r) % THREE == 0 ? 0 : 1;
    }
    return count;
  }

  @Override
  public List<Table> tables(List<StudyRow> rows) {
    return AnnuliTables.of(rows);
  }

  @Override
  public List<String> chartWords() {
    return AnnuliTables.CHARTS;
  }

  @Override
  public List<Chart> charts(List<StudyRow> rows) {
    return AnnuliTables.charts(rows);
  }

  @Override
  public List<StudyPicture> pictures(Trial trial, Progress progress) {
    return OutlineRun.pictures(instance(trial, progress), progress);
  }
}
