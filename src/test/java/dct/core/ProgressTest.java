package dct.core;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.degree.Aqt;
import dct.core.degree.OddFan;
import dct.core.degree.PartitioningAqt;
import dct.core.degree.ScanFlip;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.geometry.Sites;
import dct.core.triangulate.ConstrainedDelaunay;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.EarClipping;
import dct.core.triangulate.HertelMehlhorn;
import dct.core.triangulate.MonotonePartition;
import dct.core.triangulate.MonotoneTriangulation;
import dct.core.triangulate.Triangulation;
import dct.core.triangulate.VisibilityGraph;
import dct.testing.RandomPolygons;
import dct.testing.RandomSets;
import java.util.List;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every long computation says where it is, and stops when it is asked to. */
class ProgressTest {
  private static final int MANY = 100_000;
  private static final int FEW = 3_000; // for what is quadratic

  /** A long computation and its name. */
  record Computation(String name, int size, Function<Progress, Object> run) {
    @Override
    public String toString() {
      return name;
    }
  }

  static List<Computation> reporting() {
    SimplePolygon comb = polygon(RandomPolygons.comb(MANY, new Random(1)));
    Sites sites = sites(MANY);
    return List.of(
        new Computation("ear clipping", MANY, p -> EarClipping.triangulate(comb, p)),
        new Computation("monotone partition", MANY, p -> MonotonePartition.partition(comb, p)),
        new Computation("monotone", MANY, p -> MonotoneTriangulation.triangulate(comb, p)),
        new Computation("convex-even", MANY, p -> PartitioningAqt.triangulate(comb, p)),
        new Computation("convex-odd", MANY, p -> OddFan.triangulate(comb, p)),
        new Computation("simple polygon", MANY, p -> SimplePolygon.of(comb.points(), p)),
        new Computation("delaunay", MANY, p -> Delaunay.triangulate(sites, p)),
        new Computation(
            "constrained", MANY, p -> ConstrainedDelaunay.triangulate(Region.of(comb), p)));
  }

  /** Each in two sizes, one after the other. */
  static List<List<Computation>> asking() {
    List<Computation> few = computations(MANY / 4, FEW / 4);
    List<Computation> many = computations(MANY, FEW);
    return IntStream.range(0, few.size()).mapToObj(i -> List.of(few.get(i), many.get(i))).toList();
  }

  private static List<Computation> computations(int n, int small) {
    SimplePolygon comb = polygon(RandomPolygons.comb(n, new Random(1)));
    SimplePolygon star = polygon(RandomPolygons.starShaped(small, new Random(1)));
    SimplePolygon convex = polygon(onParabola(n));
    Sites sites = sites(n);
    Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
    Triangulation monotone = MonotoneTriangulation.triangulate(comb, Progress.NONE);
    Triangulation ofStar = EarClipping.triangulate(star, Progress.NONE);
    return List.of(
        new Computation("sites", n, p -> Sites.of(sites.points(), p).size()),
        new Computation("simple polygon", n, p -> SimplePolygon.of(comb.points(), p).size()),
        new Computation("ear clipping", n, p -> edges(EarClipping.triangulate(comb, p))),
        new Computation("partition", n, p -> MonotonePartition.partition(comb, p).pieces()),
        new Computation("monotone", n, p -> edges(MonotoneTriangulation.triangulate(convex, p))),
        new Computation("merging", n, p -> HertelMehlhorn.partition(comb, monotone, p).pieces()),
        new Computation("one even piece", n, p -> edges(Aqt.triangulate(convex, p))),
        new Computation("convex-even", n, p -> edges(PartitioningAqt.triangulate(comb, p))),
        new Computation("convex-odd", n, p -> edges(OddFan.triangulate(convex, p))),
        new Computation("flips of a polygon", n, p -> edges(ScanFlip.run(monotone, p).after())),
        new Computation("flips of sites", n, p -> edges(ScanFlip.run(delaunay, p).after())),
        new Computation("delaunay", n, p -> edges(Delaunay.triangulate(sites, p))),
        new Computation(
            "visibility", small, p -> VisibilityGraph.of(star, ofStar, Long.MAX_VALUE, p).pairs()),
        new Computation("chords", small, p -> MonotonePartition.chords(star, p)));
  }

  private static Points onParabola(int n) {
    double[] x = new double[n];
    double[] y = new double[n];
    for (int i = 0; i < n; i++) {
      x[i] = i;
      y[i] = (double) i * i;
    }
    return Points.of(x, y);
  }

  private static SimplePolygon polygon(Points points) {
    return SimplePolygon.of(points, Progress.NONE);
  }

  private static Sites sites(int n) {
    return RandomSets.families().get(0).make(n, 1);
  }

  /** The ends of every edge, in their order. */
  private static List<Integer> edges(Triangulation triangulation) {
    return IntStream.range(0, 2 * triangulation.edgeCount())
        .map(triangulation.dcel()::origin)
        .boxed()
        .toList();
  }

  @ParameterizedTest
  @MethodSource("reporting")
  void reportsFractionsAndSaysWhatItDoes(Computation computation) {
    Recorder recorder = new Recorder();
    assertThat(computation.run.apply(recorder)).isNotNull();
    assertThat(recorder.fractions).hasSizeGreaterThan(3).allMatch(f -> f >= 0 && f <= 1);
    assertThat(recorder.messages).allMatch(message -> !message.isBlank());
  }

  @ParameterizedTest
  @MethodSource("asking")
  void asksTheMoreOftenTheMoreThereIsToDo(List<Computation> fewAndMany) {
    Stopper few = new Stopper(Integer.MAX_VALUE);
    assertThat(fewAndMany.get(0).run.apply(few)).isNotNull();
    Stopper many = new Stopper(Integer.MAX_VALUE);
    assertThat(fewAndMany.get(1).run.apply(many)).isNotNull();
    assertThat(few.asked.get()).isPositive();
    if (fewAndMany.get(1).size == MANY || fewAndMany.get(1).name.equals("visibility")) {
      assertThat(many.asked.get()).isGreaterThan(few.asked.get());
      assertThat(many.asked.get()).isGreaterThan(fewAndMany.get(1).size / 50_000);
    }
  }

  /** Whichever question is answered with a wish to stop; and what was given is as it was. */
  @ParameterizedTest
  @MethodSource("asking")
  void stopsAtEveryQuestionAndLeavesNoDamage(List<Computation> fewAndMany) {
    Computation computation = fewAndMany.get(0);
    Stopper all = new Stopper(Integer.MAX_VALUE);
    Object result = computation.run.apply(all);
    int step = Math.max(1, all.asked.get() / 40);
    for (int allowed = 0; allowed < all.asked.get(); allowed += step) {
      Stopper stopper = new Stopper(allowed);
      assertThatThrownBy(() -> computation.run.apply(stopper))
          .as("after %d questions", allowed)
          .isInstanceOf(CancellationException.class);
    }
    assertThat(computation.run.apply(Progress.NONE)).isEqualTo(result);
  }

  /** Keeps what is reported; is called from several threads. */
  private static final class Recorder implements Progress {
    final Queue<Double> fractions = new ConcurrentLinkedQueue<>();
    final Queue<String> messages = new ConcurrentLinkedQueue<>();

    @Override
    public void report(double fraction, String message) {
      fractions.add(fraction);
      messages.add(message);
    }

    @Override
    public boolean isCancelled() {
      return false;
    }
  }

  /** Counts the questions, and cancels after a number of them; is called from several threads. */
  private static final class Stopper implements Progress {
    final AtomicInteger asked = new AtomicInteger();
    private final int allowed;

    Stopper(int allowed) {
      this.allowed = allowed;
    }

    @Override
    public void report(double fraction, String message) {}

    @Override
    public boolean isCancelled() {
      return asked.getAndIncrement() >= allowed;
    }
  }
}
