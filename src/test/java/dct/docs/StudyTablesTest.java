package dct.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Rows of the tables of docs/study.md and README, computed again. */
class StudyTablesTest {
  @TempDir Path folder;

  private static Page study() throws IOException {
    return Page.read(Path.of("docs", "study.md"));
  }

  @Test
  void theTableOfSites() throws IOException {
    String table =
        StudyTables.sites(StudyTables.rows(folder.resolve("p.csv"), "points", "--sets", "50"));
    assertThat(study().part("sites")).isEqualTo(table);
  }

  @Test
  void shapesThatAreQuickToMake() throws IOException {
    List<StudyTables.Row> rows =
        StudyTables.rows(
            folder.resolve("p.csv"), "polygons", "--shapes", "convex,spiral", "--sizes", "1000");
    assertContains(study().part("shapes"), StudyTables.shapes(rows, true), 4);
    assertContains(
        Page.read(Path.of("README.md")).part("shapes"), StudyTables.shapes(rows, false), 4);
  }

  @Test
  void smallPolygons() throws IOException {
    String shapes = String.join(",", StudyTables.RANDOM_LOOKING);
    List<StudyTables.Row> rows =
        StudyTables.rows(
            folder.resolve("p.csv"), "polygons", "--shapes", shapes, "--sizes", "10,20");
    assertContains(study().part("sizes"), StudyTables.sizes(rows), 4);
  }

  /** Each of so many lines, heads included, stands in the page's table. */
  private static void assertContains(String table, String lines, int count) {
    assertThat(lines.lines().toList()).hasSize(count);
    assertThat(table.lines().toList()).containsAll(lines.lines().toList());
  }
}
