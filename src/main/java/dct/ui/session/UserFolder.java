package dct.ui.session;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/** Where a program keeps what is its own and not the user's documents. */
public final class UserFolder {
  /** The system property that names another folder. */
  public static final String PROPERTY = "dct.state";

  private UserFolder() {}

  /** The folder of the user who runs the program; it need not be there yet. */
  public static Path ofUser() {
    String other = System.getProperty(PROPERTY, "");
    return other.isEmpty()
        ? of(
            System.getProperty("os.name"),
            System.getenv(),
            System.getProperty("user.home"),
            "Library/Application Support")
        : Path.of(other);
  }

  /**
   * The folder on a system of this name.
   *
   * @param onMac where in the user's home it is on a Mac, which has several such places
   */
  public static Path of(String system, Map<String, String> environment, String home, String onMac) {
    String lower = system.toLowerCase(Locale.ROOT);
    if (lower.startsWith("windows")) {
      return Path.of(environment.getOrDefault("LOCALAPPDATA", home), "dct");
    }
    if (lower.startsWith("mac")) {
      return Path.of(home, onMac, "dct");
    }
    return Path.of(environment.getOrDefault("XDG_STATE_HOME", home + "/.local/state"), "dct");
  }
}
