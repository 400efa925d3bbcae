package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.triangulate.Domain;
import dct.io.text.BadInputException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FileNamesTest {

  @ParameterizedTest
  @CsvSource({
    "comb, POLYGON, comb_polygonbased.txt",
    "comb, SITES, comb_pointbased.txt",
    "a.b/comb, POLYGON, a.b/comb_polygonbased.txt",
    "comb_polygonbased, POLYGON, comb_polygonbased.txt",
    "comb_polygonbased.txt, POLYGON, comb_polygonbased.txt",
    "comb.txt, POLYGON, comb.txt",
    "comb.dat, SITES, comb.dat",
    "fig3.1, POLYGON, fig3.1_polygonbased.txt",
    "comb_pointbased.txt, POLYGON, comb_polygonbased.txt",
    "comb_polygonbased, SITES, comb_pointbased.txt",
    ".hidden, SITES, .hidden_pointbased.txt",
    "Kamm_ä, SITES, Kamm_ä_pointbased.txt",
  })
  void adds_to_a_typed_name_what_is_missing(String typed, Domain domain, String saved) {
    assertThat(FileNames.forSaving(Path.of(typed), domain)).isEqualTo(Path.of(saved));
  }

  @ParameterizedTest
  @CsvSource({
    "x_polygonbased.txt, POLYGON",
    "x_polygonbased, POLYGON",
    "X_PolygonBased.TXT, POLYGON",
    "x_pointbased.txt, SITES",
    "x_pointbased.json, SITES",
    "x_polygonbased_pointbased, SITES",
    "polygonbased.txt,",
    "x_polygonbased2.txt,",
    "x_pointbased/y.txt,",
    "x.txt,",
  })
  void a_name_says_what_the_file_holds(String name, Domain domain) {
    assertThat(FileNames.domain(Path.of(name)).orElse(null)).isEqualTo(domain);
  }

  @ParameterizedTest
  @CsvSource({
    "comb_polygonbased.txt, comb_polygonbased.txt",
    "comb_polygonbased, comb_polygonbased.txt",
    "comb, comb_polygonbased.txt",
    "star, star.txt",
    "plain, plain",
    "folder, folder.txt",
    "nothing, nothing",
  })
  void opens_names_with_and_without_extension(String typed, String opened, @TempDir Path folder)
      throws IOException {
    Files.createDirectory(folder.resolve("folder"));
    for (String name : new String[] {"comb_polygonbased", "star", "star_pointbased", "folder"}) {
      Files.createFile(folder.resolve(name + ".txt"));
    }
    Files.createFile(folder.resolve("plain"));
    Files.createFile(folder.resolve("plain.txt"));
    assertThat(FileNames.forOpening(folder.resolve(typed))).isEqualTo(folder.resolve(opened));
  }

  @Test
  void asks_which_when_a_name_leads_to_both(@TempDir Path folder) throws IOException {
    Files.createFile(folder.resolve("x_polygonbased.txt"));
    Files.createFile(folder.resolve("x_pointbased.txt"));
    Path typed = folder.resolve("x");
    assertThatThrownBy(() -> FileNames.forOpening(typed))
        .isInstanceOf(BadInputException.class)
        .hasMessage(typed + ": there is both x_polygonbased.txt and x_pointbased.txt; say which");
  }

  @Test
  void a_name_of_the_other_kind_is_contradicted_with_the_right_one() {
    assertThat(FileNames.contradiction(Path.of("a/x_pointbased.txt"), Domain.POLYGON))
        .contains(
            "a/x_pointbased.txt would be read as points, but this is polygon; name it"
                + " a/x_polygonbased.txt");
    assertThat(FileNames.contradiction(Path.of("x_pointbased.txt"), Domain.SITES)).isEmpty();
    assertThat(FileNames.contradiction(Path.of("x.txt"), Domain.SITES)).isEmpty();
  }
}
