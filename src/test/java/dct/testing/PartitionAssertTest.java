package dct.testing;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.dcel.Dcel;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.SimplePolygon;
import dct.core.triangulate.MonotonePartition;
import dct.core.triangulate.Partition;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;

/** The assertion on partitions can fail. */
class PartitionAssertTest {

  private static SimplePolygon polygon(double... pairs) {
    return SimplePolygon.of(Points.ofPairs(pairs), Progress.NONE);
  }

  @Test
  void theAssertionRefusesWhatIsNoPartition() {
    SimplePolygon dart = polygon(0, 0, 4, 0, 1, 1, 0, 4);
    Dcel outside = Dcel.cycle(0, 1, 2, 3);
    outside.splitFace(2, 6); // v1–v3 lies outside
    refuses(
        () ->
            PartitionAssert.assertThat(new Partition(Region.of(dart), outside))
                .isPartitionOf(dart));
    Dcel inside = Dcel.cycle(0, 1, 2, 3);
    inside.splitFace(0, 4);
    PartitionAssert.assertThat(new Partition(Region.of(dart), inside))
        .isPartitionOf(dart)
        .hasStrictlyConvexPieces();
    Dcel clockwise = Dcel.cycle(0, 3, 2, 1);
    refuses(
        () ->
            PartitionAssert.assertThat(new Partition(Region.of(dart), clockwise))
                .isPartitionOf(dart));
    Partition whole = new Partition(Region.of(dart), Dcel.cycle(0, 1, 2, 3));
    refuses(() -> PartitionAssert.assertThat(whole).hasStrictlyConvexPieces());
  }

  @Test
  void theAssertionRefusesAPieceThatIsNotMonotone() {
    SimplePolygon w = polygon(0, 4, 1, 0, 2, 2, 3, 0, 4, 4);
    Partition whole = new Partition(Region.of(w), Dcel.cycle(0, 1, 2, 3, 4));
    PartitionAssert.assertThat(whole).isPartitionOf(w);
    SimplePolygon m = polygon(0, 0, 4, 0, 3, 4, 2, 2, 1, 4);
    Partition wholeM = new Partition(Region.of(m), Dcel.cycle(0, 1, 2, 3, 4));
    refuses(() -> PartitionAssert.assertThat(wholeM).hasMonotonePieces());
    PartitionAssert.assertThat(MonotonePartition.partition(m, Progress.NONE))
        .isPartitionOf(m)
        .hasMonotonePieces();
  }

  private static void refuses(ThrowingCallable check) {
    assertThatThrownBy(check).isInstanceOf(AssertionError.class);
  }
}
