package dct.core.degree.region;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.Preference;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.VisibilityGraph;
import java.util.stream.IntStream;

/**
 * The {@link PreferredTable} of a polygon of any size, over the pairs of vertices that see each
 * other. Takes the same steps as {@link ParityTable}; memory 64 bytes a pair beside the 8 of the
 * graph.
 */
public final class PreferredPolygonTable extends PreferredTable {
  private final VisibilityGraph graph;
  private final int mostApexes;

  private PreferredPolygonTable(
      SimplePolygon polygon,
      ParityGoal.Wish[] wishes,
      VisibilityGraph graph,
      Preference preference) {
    super(ParityTable.costs(wishes), SecondCost.of(preference, polygon), graph.pairs());
    this.graph = graph;
    mostApexes =
        IntStream.range(0, graph.vertices())
            .map(i -> graph.firstUp(i + 1) - graph.firstUp(i))
            .max()
            .orElse(0);
  }

  /**
   * Fills the table.
   *
   * @param wishes by position
   * @throws java.util.concurrent.CancellationException if cancelled
   */
  public static PreferredPolygonTable fill(
      SimplePolygon polygon,
      ParityGoal.Wish[] wishes,
      VisibilityGraph graph,
      Preference preference,
      Progress progress) {
    PreferredPolygonTable table = new PreferredPolygonTable(polygon, wishes, graph, preference);
    PairBlocks.fill(graph, table::filler, progress);
    return table;
  }

  private PairBlocks.Filler filler() {
    Apexes apexes = new Apexes(mostApexes);
    return (i, j, pair) -> {
      int slot = graph.slotAfter(j, i);
      if (j == i + 1) {
        storeSide(j, 4 * (slot - 1), 4 * pair);
      } else {
        find(apexes, graph.firstUp(i), pair, slot, graph.firstDown(j + 1));
        apexes.storeBest(i, j, 4 * (slot - 1), 4 * pair);
      }
    };
  }

  /** Merges two sorted lists, without a branch that cannot be foretold. */
  private void find(Apexes apexes, int upStart, int upEnd, int slotStart, int slotEnd) {
    int up = upStart;
    int slot = slotStart;
    int count = 0;
    while (up < upEnd && slot < slotEnd) {
      int k = graph.high(up);
      int other = graph.low(slot);
      apexes.apex[count] = k;
      apexes.left[count] = 4 * up;
      apexes.right[count] = 4 * slot;
      count += k == other ? 1 : 0;
      up += k <= other ? 1 : 0;
      slot += other <= k ? 1 : 0;
    }
    apexes.count = count;
  }

  @Override
  int size() {
    return graph.vertices();
  }

  @Override
  int at(int i, int j) {
    return 4 * (graph.slotAfter(j, i) - 1);
  }

  @Override
  int apexAfter(int k, int i, int j) {
    return graph.commonAfter(k, i, j);
  }
}
