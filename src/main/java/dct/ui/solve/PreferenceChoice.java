package dct.ui.solve;

import dct.core.degree.Preference;
import dct.core.triangulate.Triangulation;
import dct.ui.command.CommandRegistry;
import dct.ui.session.Settings;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.ButtonGroup;
import javax.swing.JMenu;
import javax.swing.JRadioButtonMenuItem;

/**
 * Triangulate ▸ Prefer: what the searches for the most even, odd or wished vertices prefer among
 * equally good triangulations. It is remembered.
 */
public final class PreferenceChoice {
  /** The name of the menu within the menu. */
  public static final String TITLE = "Prefer";

  private static final String SETTING = "prefer";

  private final Settings settings;
  private Choice chosen;

  private enum Choice {
    ANGLE("Largest Smallest Angle", "angle"),
    LENGTH("Least Total Length", "length"),
    KEPT("Most Edges Kept", "kept"),
    NONE("Nothing", "none");

    private final String title;
    private final String word;

    Choice(String title, String word) {
      this.title = title;
      this.word = word;
    }
  }

  /** The choice that these settings remember. */
  public PreferenceChoice(Settings settings) {
    this.settings = settings;
    String word = settings.get(SETTING).orElse("");
    chosen =
        Arrays.stream(Choice.values())
            .filter(choice -> choice.word.equals(word))
            .findFirst()
            .orElse(Choice.ANGLE);
  }

  /** Offers the menu. */
  public void offer(CommandRegistry commands) {
    commands.addSubmenu(TITLE, this::fill);
  }

  private void fill(JMenu menu) {
    ButtonGroup group = new ButtonGroup();
    for (Choice choice : Choice.values()) {
      JRadioButtonMenuItem item = new JRadioButtonMenuItem(choice.title, choice == chosen);
      item.setName(TITLE + " " + choice.title);
      item.addActionListener(e -> choose(choice));
      group.add(item);
      menu.add(item);
    }
  }

  private void choose(Choice choice) {
    chosen = choice;
    settings.put(SETTING, choice.word);
  }

  /** What is compared, or nothing. */
  public Optional<Preference.Kind> kind() {
    return Preference.Kind.of(chosen.word);
  }

  /** What a search that begins now prefers, if anything, from what it begins with. */
  Function<Triangulation, Optional<Preference>> now() {
    return switch (chosen) {
      case ANGLE -> before -> Optional.of(Preference.ANGLE);
      case LENGTH -> before -> Optional.of(Preference.LENGTH);
      case KEPT -> before -> Optional.of(Preference.keeping(before));
      case NONE -> before -> Optional.empty();
    };
  }
}
