package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.io.format.Choice;
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

/** Polygons with holes of other programs' tests: triangulated by every method, or refused. */
class RegionDataTest {
  private static final int CLASS = 4;
  private static final int WKT = 5;

  @ForeignDataTest
  void everyRegionIsTriangulatedByEveryMethod() throws IOException {
    List<String[]> rows = rows("disjoint");
    assertThat(rows).hasSizeGreaterThan(100);
    for (String[] row : rows) {
      String what = row[0] + " " + row[1];
      Instance instance = read(row).instance(Progress.NONE);
      assertThat(instance).as(what).isInstanceOf(Instance.OfRegion.class);
      for (Method method : Method.of(Domain.REGION)) {
        Solution made = Solution.of(instance, method, Progress.NONE);
        check(what + " " + method, made);
        check(what + " " + method + ", flipped", made.flipped(Progress.NONE));
      }
    }
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
            catchThrowableOfType(BadInputException.class, () -> read(row).instance(Progress.NONE));
        assertThat(fault).as("%s %s %s", kind, row[0], row[1]).isNotNull();
        assertThat(fault.getMessage()).matches("in:\\d+: .*\\bv?\\d.*; .*");
      }
    }
  }

  private static PointDocument read(String... row) throws IOException {
    byte[] bytes = row[WKT].getBytes(StandardCharsets.UTF_8);
    return PointFile.read("in", new ByteArrayInputStream(bytes), Choice.NONE.as(Domain.REGION));
  }

  private static List<String[]> rows(String kind) {
    return SharedData.sharedTable("regions.tsv").stream()
        .filter(row -> row[CLASS].equals(kind))
        .toList();
  }
}
