package dct.ui.help;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.Progress;
import dct.core.geometry.Defect;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.ui.document.Document;
import org.junit.jupiter.api.Test;

class CheckWorkTest {
  private static CheckWork.Report report(Domain domain, double... pairs) {
    return CheckWork.report(new Document(domain, Points.ofPairs(pairs)), Progress.NONE);
  }

  @Test
  void usablePointsAreDescribed() {
    CheckWork.Report polygon = report(Domain.POLYGON, 0, 0, 4, 0, 4, 4);
    assertThat(polygon.sentence())
        .isEqualTo(
            "This can be triangulated: a simple polygon with 3 vertices, counter-clockwise.");
    assertThat(polygon.defect()).isEmpty();
    assertThat(report(Domain.SITES, 0, 0, 4, 0, 4, 4, 0, 0).sentence())
        .contains("3 usable sites (1 duplicate merged)");
  }

  @Test
  void aCrossingHasItsPlaceAndTheNumberOfAll() {
    CheckWork.Report report = report(Domain.POLYGON, 0, 0, 4, 4, 4, 0, 0, 4);
    assertThat(report.defect()).map(Defect::kind).contains(Defect.Kind.CROSSING);
    assertThat(report.sentence()).startsWith("This cannot be triangulated: ");
    CheckWork.Report two = report(Domain.POLYGON, 0, 0, 10, 0, 10, 2, 4, -2, 0, 2);
    assertThat(two.sentence()).contains("2 such places are marked");
  }

  @Test
  void tooFewOrFlatPointsHaveNoPlace() {
    assertThat(report(Domain.SITES, 0, 0, 4, 0, 8, 0).defect()).isEmpty();
    assertThat(report(Domain.POLYGON, 0, 0, 4, 0).defect()).isEmpty();
  }
}
