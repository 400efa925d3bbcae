package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
import dct.io.format.Columns;
import dct.io.format.SeveralShapes;
import dct.io.format.Touch;
import dct.io.text.BadInputException;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.problem.verify.Verdict.Outcome;
import dct.problem.verify.Verifier;
import dct.testing.ForeignDataTest;
import dct.testing.SharedData;
import dct.testing.TriangulationAssert;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** Polygons with holes of other programs' tests: triangulated by every method, or refused. */
class RegionDataTest {
  private static final int CLASS = 4;
  private static final int WKT = 5;
  private static final String ONLY_HAIR =
      ", or give --touching hair, since the region hangs together there";

  @ForeignDataTest
  void everyRegionIsTriangulatedByEveryMethod() throws IOException {
    List<String[]> rows = rows("disjoint");
    assertThat(rows).hasSizeGreaterThan(100);
    for (String[] row : rows) {
      triangulate(row[0] + " " + row[1], read(Touch.KEPT, row).instance(Progress.NONE));
    }
  }

  private static void triangulate(String what, Instance instance) {
    assertThat(instance).as(what).isInstanceOf(Instance.OfRegion.class);
    for (Method method : Method.of(Domain.REGION)) {
      Solution made = Solution.of(instance, method, Progress.NONE);
      check(what + " " + method, made);
      check(what + " " + method + ", flipped", made.flipped(Progress.NONE));
    }
  }

  /** In none of them a ring cuts the region in two, as the standards of geodata ask for. */
  @ForeignDataTest
  void everyRegionWhoseRingsTouchIsParted() throws IOException {
    List<String[]> rows = rows("touching");
    assertThat(rows).hasSize(47);
    for (String[] row : rows) {
      String what = row[0] + " " + row[1];
      PointDocument read = read(Touch.KEPT, row);
      assertThat(fault(read)).as(what).endsWith(ONLY_HAIR);
      assertThat(fault(read(Touch.SPLIT, row))).as(what).isEqualTo(fault(read));
      PointDocument parted = read(Touch.PARTED, row);
      assertThat(parted.points().size()).isEqualTo(read.points().size());
      triangulate(what, parted.instance(Progress.NONE));
    }
  }

  /** What other programs call invalid, for what it offers: does that, and is triangulated. */
  @ForeignDataTest
  void whatIsOfferedForInvalidRegionsMendsThem() throws IOException {
    int split = 0;
    int parted = 0;
    for (String[] row : rows("invalid")) {
      String what = row[0] + " " + row[1];
      String fault = fault(read(Touch.KEPT, row));
      if (fault.contains("--touching split")) {
        triangulate(what, readFirst(Touch.SPLIT, row).instance(Progress.NONE));
        split++;
      }
      if (fault.contains("--touching hair")) {
        triangulate(what, readFirst(Touch.PARTED, row).instance(Progress.NONE));
        parted++;
      }
    }
    assertThat(List.of(split, parted)).containsExactly(13, 15);
  }

  private static PointDocument readFirst(Touch touch, String... row) throws IOException {
    try {
      return read(touch, row);
    } catch (SeveralShapes several) {
      return read(choice(touch, OptionalInt.of(1)), row);
    }
  }

  private static String fault(PointDocument read) {
    return catchThrowableOfType(BadInputException.class, () -> read.instance(Progress.NONE))
        .fault();
  }

  private static void check(String what, Solution made) {
    TriangulationAssert.assertThat(made.triangulation())
        .as(what)
        .isTriangulationOf(((Instance.OfRegion) made.instance()).region());
    assertThat(
            Verifier.verify(ResultJson.claims(made), Optional.of(made.instance()), Progress.NONE)
                .outcome())
        .as(what)
        .isEqualTo(Outcome.TRUE);
  }

  @ForeignDataTest
  void ringsThatTouchOrCrossAreRefusedWithAPlace() throws IOException {
    for (String kind : List.of("touching", "invalid")) {
      List<String[]> rows = rows(kind);
      assertThat(rows).hasSizeGreaterThan(5);
      for (String[] row : rows) {
        BadInputException fault =
            catchThrowableOfType(
                BadInputException.class, () -> read(Touch.KEPT, row).instance(Progress.NONE));
        assertThat(fault).as("%s %s %s", kind, row[0], row[1]).isNotNull();
        assertThat(fault.getMessage()).matches("in:\\d+: .*\\bv?\\d.*; .*");
      }
    }
  }

  private static PointDocument read(Touch touch, String... row) throws IOException {
    return read(choice(touch, OptionalInt.empty()), row);
  }

  private static Choice choice(Touch touch, OptionalInt pick) {
    return new Choice(
        Optional.of(Domain.REGION), Domain.REGION, pick, Columns.TOLD_BY_CONTENT, touch);
  }

  private static PointDocument read(Choice choice, String... row) throws IOException {
    byte[] bytes = row[WKT].getBytes(StandardCharsets.UTF_8);
    return PointFile.read("in", new ByteArrayInputStream(bytes), choice);
  }

  private static List<String[]> rows(String kind) {
    return SharedData.sharedTable("regions.tsv").stream()
        .filter(row -> row[CLASS].equals(kind))
        .toList();
  }
}
