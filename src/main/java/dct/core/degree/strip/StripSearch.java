package dct.core.degree.strip;

import static java.util.Comparator.comparingInt;

import dct.core.Progress;
import dct.core.SeededRandom;
import dct.core.degree.Optimum;
import dct.core.degree.region.SearchMesh;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Solves strips of a {@link SearchMesh} anew by beam search, one after the other, for sites in
 * regular patterns and on long straight sides of the hull, where plain descent stops early.
 *
 * <p>The axis of a strip runs by an unmet vertex, or near one, in one of four directions; its
 * length and width are random, from a few triangles to the whole side of the hull. What the beam
 * finds is taken if it has no more unmet vertices than the strip had; so those wander from strip to
 * strip until some meet and vanish, and their number never grows. A few strips are solved side by
 * side; of those that have a vertex in common only one is taken, the one that gained most. Neither
 * threads nor time make a difference to the result.
 */
public final class StripSearch {
  private static final int AT_ONCE = 4;
  private static final int WIDTH = 100; // of the beam
  private static final int TRIES = 5; // to cut a strip
  private static final int AWAY = 4; // fewer steps than this from an unmet vertex
  private static final int SHORTEST = 4; // edges of an axis
  private static final int LONGEST = 300;
  private static final int LAYERS = 100; // at most on each side of the axis
  // Vertices of strips that have not helped: so many for each vertex of the mesh.
  private static final int PATIENCE = 3000;
  private static final int LEAST_PATIENCE = 300_000;
  private static final int MOST_PATIENCE = 1_500_000;

  private final SearchMesh mesh;
  private final Progress progress;
  private final long seed;
  private final List<Attempt> attempts;
  private int[] open; // the unmet vertices
  private int rounds;

  /** A search over all of a mesh. */
  public StripSearch(SearchMesh mesh, Progress progress, long seed) {
    this.mesh = mesh;
    this.progress = progress;
    this.seed = seed;
    attempts = Stream.generate(Attempt::new).limit(AT_ONCE).toList();
    collect();
  }

  private void collect() {
    open = IntStream.range(0, mesh.size()).filter(mesh::isUnmet).toArray();
  }

  /**
   * Searches until no more than {@code enough} are unmet, or as much work on end has not helped as
   * the effort allows. Asked again, it goes on where it stopped.
   */
  public void run(int enough, double effort) {
    double patience = effort * patience();
    int idle = 0; // vertices solved since it last helped
    while (open.length > enough && idle < patience && !progress.isCancelled()) {
      int before = open.length;
      round(rounds++);
      idle = open.length < before ? 0 : idle + attempts.stream().mapToInt(Attempt::size).sum();
      progress.report(0.85 + 0.15 * Math.min(1, idle / patience), Optimum.soFar(open.length));
    }
  }

  private int patience() {
    int patience = (int) Math.max(LEAST_PATIENCE, (long) mesh.size() * PATIENCE);
    return Math.min(MOST_PATIENCE, patience);
  }

  private void round(int round) {
    IntStream.range(0, AT_ONCE)
        .parallel()
        .forEach(i -> attempts.get(i).solve(open, SeededRandom.of(seed, round, i)));
    List<Attempt> taken = new ArrayList<>();
    for (Attempt attempt : bestFirst()) {
      if (attempt.isSolved() && taken.stream().noneMatch(attempt::overlaps)) {
        attempt.take();
        taken.add(attempt);
      }
    }
    collect();
  }

  private List<Attempt> bestFirst() {
    return attempts.stream().sorted(comparingInt(Attempt::gain).reversed()).toList();
  }

  /** One strip, cut and solved while the mesh stays as it is. */
  private final class Attempt {
    private final Strip strip = new Strip(mesh);
    private int[] moves = {};
    private int gain;

    void solve(int[] centres, SeededRandom random) {
      cut(centres, random);
      SweepBeam beam = new SweepBeam(strip, WIDTH, random);
      moves = beam.search(strip.unmet(), progress);
      gain = strip.unmet() - beam.unmet();
    }

    /** Cuts a strip, if possible with two or more unmet vertices, which could meet. */
    private void cut(int[] centres, SeededRandom random) {
      int tries = TRIES;
      do {
        strip.cut(near(centres[random.nextInt(centres.length)], random), shape(random), random);
        tries--;
      } while (tries > 0 && strip.unmet() < 2);
    }

    private int near(int v, SeededRandom random) {
      int u = v;
      for (int r = random.nextInt(AWAY); r > 0; r--) {
        u = mesh.corner[SearchMesh.next(mesh.halfEdgeAt(u, random))];
      }
      return u;
    }

    private Strip.Shape shape(SeededRandom random) {
      int turn = random.nextInt(StripOrder.TURNS);
      int length = logUniform(SHORTEST, LONGEST, random);
      int left = random.nextInt(length + 1);
      int down = logUniform(1, LAYERS, random);
      int up = logUniform(1, LAYERS, random);
      return new Strip.Shape(turn, left, length - left, down, up);
    }

    /** Every order of magnitude as often as the others. */
    private int logUniform(int least, int most, SeededRandom random) {
      return (int) (least * StrictMath.pow((double) most / least, random.nextDouble()));
    }

    int size() {
      return strip.size();
    }

    boolean isSolved() {
      return moves.length > 0;
    }

    int gain() {
      return gain;
    }

    boolean overlaps(Attempt that) {
      return Arrays.stream(strip.vertices()).anyMatch(that.strip::contains);
    }

    void take() {
      strip.fill(moves);
    }
  }
}
