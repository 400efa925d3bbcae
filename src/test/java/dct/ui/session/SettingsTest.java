package dct.ui.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SettingsTest {
  @TempDir Path folder;
  private final Lane lane = new Lane();

  private Path file() {
    return folder.resolve("not there yet").resolve("settings.properties");
  }

  private Settings settings() {
    return new Settings(file(), lane);
  }

  @Test
  void whatIsSetIsThereTheNextTime() throws Exception {
    Settings settings = settings();
    settings.put("a.word", " C:\\new\\test = #1\nü ");
    settings.put("a.number", -17);
    settings.put("a.decimal", 0.1);
    settings.put("endless", "NaN");
    settings.put("gone", true);
    settings.remove("gone");
    lane.await();
    Settings again = settings();
    assertThat(again.get("a.word")).contains(" C:\\new\\test = #1\nü ");
    assertThat(again.number("a.number")).hasValue(-17);
    assertThat(again.number("a.word")).isEmpty();
    assertThat(again.decimal("a.decimal")).hasValue(0.1);
    assertThat(again.decimal("endless")).isEmpty();
    assertThat(again.decimal("a.word")).isEmpty();
    assertThat(again.isOn("gone")).isFalse();
  }

  @Test
  void twoProgramsKeepEachOthersChanges() throws Exception {
    Settings one = settings();
    Settings other = settings();
    one.put("one", 1);
    other.put("other", 2);
    lane.await();
    assertThat(settings().number("one")).hasValue(1);
    assertThat(settings().number("other")).hasValue(2);
  }

  @Test
  void whatTwoProgramsChangeAtTheSameTimeIsKept() throws Exception {
    Lane second = new Lane();
    Settings one = settings();
    Settings other = new Settings(file(), second);
    for (int i = 0; i < 100; i++) {
      one.put("one." + i, i);
      other.put("other." + i, i);
    }
    lane.await();
    second.await();
    for (int i = 0; i < 100; i++) {
      assertThat(settings().number("one." + i)).hasValue(i);
      assertThat(settings().number("other." + i)).hasValue(i);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"a=\\u12", "\0\0\0", "=\n=\n", "window.x=many\nwindow.y"})
  void contentThatIsNoneIsIgnored(String content) throws Exception {
    Files.createDirectories(file().getParent());
    Files.writeString(file(), content);
    Settings settings = settings();
    assertThat(settings.number("window.x")).isEmpty();
    settings.put("window.x", 5);
    lane.await();
    assertThat(settings().number("window.x")).hasValue(5);
  }

  @Test
  void whereNothingCanBeWrittenNothingFails() throws Exception {
    Files.writeString(folder.resolve("not there yet"), "a file");
    Settings settings = settings();
    settings.put("x", 1);
    lane.await();
    assertThat(settings.number("x")).hasValue(1);
  }

  @Test
  void theFilesOfTwoProgramsAreAllRemembered() throws Exception {
    RecentFiles one = new RecentFiles(settings());
    RecentFiles other = new RecentFiles(settings());
    one.add(folder.resolve("a.txt"));
    one.add(folder.resolve("b.txt"));
    lane.await();
    other.add(folder.resolve("c.txt"));
    lane.await();
    one.add(folder.resolve("a.txt"));
    lane.await();
    assertThat(new RecentFiles(settings()).list())
        .containsExactly(folder.resolve("a.txt"), folder.resolve("c.txt"), folder.resolve("b.txt"));
  }

  @Test
  void theLatestTenFilesAreRememberedOnce() throws Exception {
    RecentFiles recent = new RecentFiles(settings());
    for (int i = 0; i < 12; i++) {
      recent.add(folder.resolve(i + ".txt"));
    }
    recent.add(folder.resolve("x").resolve("..").resolve("5.txt"));
    lane.await();
    List<Path> files = new RecentFiles(settings()).list();
    assertThat(files).hasSize(10).startsWith(folder.resolve("5.txt"), folder.resolve("11.txt"));
    recent.clear();
    lane.await();
    assertThat(new RecentFiles(settings()).list()).isEmpty();
  }
}
