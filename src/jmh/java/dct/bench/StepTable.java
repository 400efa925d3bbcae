package dct.bench;

import dct.core.Progress;
import dct.core.degree.DegreeCount;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Points;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotonePartition;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.PolygonShape;
import dct.io.PointDocument;
import dct.io.PointFile;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;

/** Each step of ours against n, with the exponent of its growth fitted by least squares. */
final class StepTable {
  private static final int SMALLEST = 1000;
  private static final double SECONDS = 1.5; // for one step at one size
  private static final int MOST_ROUNDS = 200;

  private final PrintStream out;
  private final int largest;

  /** Prepares an input of n vertices or sites, untimed, and gives what is to be timed. */
  private record Step(String name, IntFunction<Runnable> prepared) {}

  StepTable(PrintStream out, int largest) {
    this.out = out;
    this.largest = largest;
  }

  void run() {
    out.println("\n## Growth\n");
    out.println(
        "Median wall time in milliseconds of each step alone, and the exponent b of the best fit"
            + " a·n^b. Sites are uniform, polygons star-shaped.\n");
    head();
    for (Step step : steps()) {
      row(step);
    }
  }

  private static List<Step> steps() {
    return List.of(
        new Step("reading text", StepTable::reading),
        new Step("writing text", StepTable::writing),
        new Step("merging equal sites", n -> () -> Sites.of(points(n), Progress.NONE)),
        new Step(
            "Delaunay",
            n -> {
              Sites sites = Sites.of(points(n), Progress.NONE);
              return () -> Delaunay.triangulate(sites, Progress.NONE);
            }),
        new Step("Scan-Flip of Delaunay", StepTable::flippingSites),
        new Step(
            "counting degrees",
            n -> {
              Triangulation t =
                  Delaunay.triangulate(Sites.of(points(n), Progress.NONE), Progress.NONE);
              return () -> DegreeCount.of(t);
            }),
        onPolygon(
            "simplicity check", polygon -> () -> SimplePolygon.of(polygon.points(), Progress.NONE)),
        onPolygon("monotone partition", p -> () -> MonotonePartition.partition(p, Progress.NONE)),
        onPolygon(
            "monotone triangulation, partition included",
            p -> () -> MonotoneTriangulation.triangulate(p, Progress.NONE)),
        onPolygon("ear clipping", p -> () -> EarClipping.triangulate(p, Progress.NONE)),
        onPolygon(
            "Hertel–Mehlhorn, from a triangulation",
            p -> {
              Triangulation t = MonotoneTriangulation.triangulate(p, Progress.NONE);
              return () -> HertelMehlhorn.partition(p, t, Progress.NONE);
            }),
        onPolygon(
            "Partitioning-AQT, all of it",
            p -> () -> PartitioningAqt.triangulate(p, Progress.NONE)),
        onPolygon(
            "Scan-Flip of monotone",
            p -> {
              Triangulation t = MonotoneTriangulation.triangulate(p, Progress.NONE);
              return () -> ScanFlip.run(t, Progress.NONE);
            }));
  }

  private static Step onPolygon(
      String name, java.util.function.Function<SimplePolygon, Runnable> prepared) {
    return new Step(name, n -> prepared.apply(PolygonShape.STAR_SHAPED.generate(n, 1)));
  }

  private static Points points(int n) {
    double[][] points = SiteFamily.UNIFORM.make(n);
    return Points.of(points[0], points[1]);
  }

  private static Runnable flippingSites(int n) {
    Triangulation t = Delaunay.triangulate(Sites.of(points(n), Progress.NONE), Progress.NONE);
    return () -> ScanFlip.run(t, Progress.NONE);
  }

  private static Runnable reading(int n) {
    byte[] text = text(n);
    return () -> {
      try {
        PointFile.read("benchmark", new ByteArrayInputStream(text));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    };
  }

  private static Runnable writing(int n) {
    PointDocument document = PointDocument.of("benchmark", Domain.SITES, points(n));
    return () -> write(document);
  }

  private static byte[] text(int n) {
    return write(PointDocument.of("benchmark", Domain.SITES, points(n)));
  }

  private static byte[] write(PointDocument document) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      PointFile.write(bytes, document);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  private void head() {
    StringBuilder head = new StringBuilder("| step |");
    StringBuilder rule = new StringBuilder("|---|");
    for (int n = SMALLEST; n <= largest; n *= 10) {
      head.append(" n = %,d |".formatted(n));
      rule.append("---:|");
    }
    out.println(head + " exponent |");
    out.println(rule + "---:|");
  }

  private void row(Step step) {
    StringBuilder row = new StringBuilder("| " + step.name() + " |");
    List<double[]> logs = new ArrayList<>();
    for (int n = SMALLEST; n <= largest; n *= 10) {
      double millis = millis(step.prepared().apply(n));
      logs.add(new double[] {Math.log(n), Math.log(millis)});
      row.append(' ').append(ComparisonTable.millis(millis)).append(" |");
    }
    out.println(row + " %.2f |".formatted(slope(logs)));
  }

  private static double millis(Runnable step) {
    long end = System.nanoTime() + (long) (SECONDS * 1e9);
    step.run();
    step.run();
    List<Double> times = new ArrayList<>();
    do {
      long start = System.nanoTime();
      step.run();
      times.add((System.nanoTime() - start) * 1e-6);
    } while (System.nanoTime() < end && times.size() < MOST_ROUNDS);
    return Contest.median(times.stream().mapToDouble(t -> t).toArray());
  }

  private static double slope(List<double[]> points) {
    double meanX = points.stream().mapToDouble(p -> p[0]).average().orElse(0);
    double meanY = points.stream().mapToDouble(p -> p[1]).average().orElse(0);
    double over = 0;
    double under = 0;
    for (double[] p : points) {
      over += (p[0] - meanX) * (p[1] - meanY);
      under += (p[0] - meanX) * (p[0] - meanX);
    }
    return over / under;
  }
}
