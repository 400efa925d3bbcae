package dct.core.degree.search;

import static java.util.Comparator.comparingInt;

import dct.core.degree.search.AnnealedSearch.Schedule;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.IntFunction;

/**
 * Annealed searches on copies of one mesh, side by side on the cores there are.
 *
 * <p>They differ in schedule, as sets of sites differ in what helps. After each epoch, a fixed
 * number of steps, they are compared; now and then those far behind go on from the best. Who is
 * best depends on counts alone, ties going to the first, so that threads make no difference.
 */
final class AnnealedTeam {
  private static final List<Schedule> SCHEDULES =
      List.of(
          new Schedule(48, 0.05, 0.003, 0, 100_000, 1, 1),
          new Schedule(20, 0.1, 0.002, 0.1, 20_000, 1, 0.7),
          new Schedule(14, 0.04, 0.015, 0.2, 30_000, 1, 1),
          new Schedule(28, 0.1, 0.003, 0.05, 100_000, 2, 0.8));
  private static final int EPOCH = 10_000; // steps between two comparisons
  private static final int EXCHANGE = 20; // epochs between two exchanges
  private static final int BEHIND = 4; // more unsatisfied vertices than the best
  private static final double MOST_EPOCHS = 300;
  private static final double EPOCHS_PER_SITE = 2;

  private final List<AnnealedSearch> team;
  private final SearchClock clock;
  private final int sites;
  private AnnealedSearch best;

  AnnealedTeam(SearchMesh mesh, SearchClock clock, IntFunction<SearchRandom> randoms) {
    AnnealedSearch[] searches = new AnnealedSearch[SCHEDULES.size()];
    for (int i = 0; i < searches.length; i++) {
      searches[i] = new AnnealedSearch(mesh, randoms.apply(i), clock, SCHEDULES.get(i));
    }
    team = Arrays.asList(searches);
    this.clock = clock;
    sites = mesh.size();
    best = team.get(0);
  }

  /** Searches until no more than {@code enough} are unsatisfied, or as long as effort says. */
  void run(int enough, double effort) {
    double epochs = effort * Math.min(MOST_EPOCHS, EPOCHS_PER_SITE * sites);
    for (int i = 1; i <= epochs && best.unsatisfied() > enough && !clock.isOver(); i++) {
      team.parallelStream().forEach(search -> search.run(enough, EPOCH));
      best = Collections.min(team, comparingInt(AnnealedSearch::unsatisfied));
      if (i % EXCHANGE == 0) {
        exchange();
      }
      clock.report(0.85 + 0.15 * i / epochs, best.unsatisfied());
    }
  }

  private void exchange() {
    for (AnnealedSearch search : team) {
      if (search.unsatisfied() > best.unsatisfied() + BEHIND) {
        search.restart(best.best());
      }
    }
  }

  /** The best mesh that any of them has seen. */
  SearchMesh best() {
    return best.best();
  }
}
