package dct.ui.session;

import java.nio.file.Path;

/**
 * What the windows of a program share beyond its run.
 *
 * @param settings what is set
 * @param recent the files that were used last
 * @param journals of the drawings that are not saved
 * @param lane where small work with files is done
 */
public record Session(Settings settings, RecentFiles recent, Journals journals, Lane lane) {

  /** The session of the user who runs the program. */
  public static Session ofUser() {
    return in(UserFolder.ofUser());
  }

  /** A session that lives in this folder, which need not be there yet. */
  public static Session in(Path folder) {
    Lane lane = new Lane();
    Settings settings = new Settings(folder.resolve("settings.properties"), lane);
    return new Session(
        settings,
        new RecentFiles(settings),
        new Journals(folder.resolve("dct.journal"), lane),
        lane);
  }
}
