package dct.core.degree.region;

/** The {@link PreferredTable} of a small polygon, used for one after the other. */
final class PreferredRegionTable extends PreferredTable {
  private final RegionChords chords;
  private final Apexes apexes;

  /**
   * A table for polygons of at most so many vertices.
   *
   * @param x where {@link #solve} finds their coordinates, counter-clockwise
   * @param costs where it finds their costs
   */
  PreferredRegionTable(
      SearchMesh mesh, double[] x, double[] y, int[] costs, SecondCost second, int most) {
    super(costs, second, RegionChords.count(most));
    chords = new RegionChords(mesh, x, y, most);
    apexes = new Apexes(most);
  }

  /** Fills the table for the first so many vertices. */
  void solve(int vertices) {
    chords.clear(vertices);
    for (int j = 1; j < vertices; j++) {
      int side = at(j - 1, j);
      storeSide(j, side, side);
      chords.mark(j - 1, j);
      for (int i = j - 2; i >= 0; i--) {
        find(i, j);
        if (apexes.count > 0 && apexes.storeBest(i, j, at(i, j), at(i, j))) {
          chords.mark(i, j);
        }
      }
    }
  }

  private void find(int i, int j) {
    int count = 0;
    for (long bits = chords.apexes(i, j); bits != 0; bits &= bits - 1) {
      int k = Long.numberOfTrailingZeros(bits);
      if (chords.isTriangle(i, k, j)) {
        apexes.apex[count] = k;
        apexes.left[count] = at(i, k);
        apexes.right[count] = at(k, j);
        count++;
      }
    }
    apexes.count = count;
  }

  @Override
  int size() {
    return chords.size();
  }

  @Override
  int at(int i, int j) {
    return chords.at(i, j);
  }

  @Override
  int apexAfter(int k, int i, int j) {
    return chords.apexAfter(k, i, j);
  }
}
