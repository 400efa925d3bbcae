package dct.core.degree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import dct.core.Progress;
import dct.core.geometry.Sites;
import dct.core.triangulate.Delaunay;
import dct.core.triangulate.Triangulation;
import dct.experiment.generate.RandomSites;
import java.lang.System.Logger.Level;
import java.util.Locale;
import org.junit.jupiter.api.Test;

/** The experiment of the thesis's Table 4.4, repeated on seeded sites of its sizes and range. */
class Table44Test {
  private static final System.Logger LOG = System.getLogger("dct.table");

  @Test
  void theSharesOfEvenVerticesAreThoseOfTheThesis() {
    StringBuilder table = new StringBuilder("set points odd→odd even→even increase\n");
    double before = 0;
    double after = 0;
    for (int set = 1; set <= 5; set++) {
      for (int n = 50; n <= 500; n += 50) {
        Sites sites = Sites.of(RandomSites.uniform(n, 1000L * set + n), Progress.NONE);
        assertThat(sites.size()).isEqualTo(n);
        Triangulation delaunay = Delaunay.triangulate(sites, Progress.NONE);
        FlipResult result = ScanFlip.run(delaunay, Progress.NONE);
        DegreeCount was = DegreeCount.of(delaunay);
        DegreeCount is = DegreeCount.of(result.after());
        table.append(row(set, n, was, is));
        before += (double) was.even() / n / 50;
        after += (double) is.even() / n / 50;
      }
    }
    table.append(String.format(Locale.ROOT, "mean share even %.4f → %.4f", before, after));
    LOG.log(Level.INFO, table.toString());
    assertThat(before).as("%s", table).isCloseTo(0.49, within(0.02));
    assertThat(after).as("%s", table).isCloseTo(0.785, within(0.015));
  }

  private static String row(int set, int n, DegreeCount was, DegreeCount is) {
    double increase = 100.0 * (is.even() - was.even()) / was.even();
    return String.format(
        Locale.ROOT,
        "%d %d %d→%d %d→%d %.2f %%%n",
        set,
        n,
        was.odd(),
        is.odd(),
        was.even(),
        is.even(),
        increase);
  }
}
