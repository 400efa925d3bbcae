package dct.ui.command;

import java.awt.Component;
import java.util.HashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.swing.JMenu;
import javax.swing.JMenuItem;

/** Underlined letters for the items of a menu, each letter once. */
final class Mnemonics {

  private Mnemonics() {}

  /** Gives each item that has none the first letter of a word of its name that is free. */
  static void give(JMenu menu) {
    Set<Character> taken = new HashSet<>();
    for (Component item : menu.getMenuComponents()) {
      if (item instanceof JMenuItem button) {
        choose(button.getText(), taken).ifPresent(button::setMnemonic);
      }
    }
  }

  /** The first letters of words come before those within words. */
  private static Optional<Character> choose(String name, Set<Character> taken) {
    String letters = initials(name) + name;
    for (char c : letters.toLowerCase(Locale.ROOT).toCharArray()) {
      boolean plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
      if (plain && taken.add(c)) {
        return Optional.of(c);
      }
    }
    return Optional.empty();
  }

  private static String initials(String name) {
    StringBuilder initials = new StringBuilder();
    for (int i = 0; i < name.length(); i++) {
      if (i == 0 || name.charAt(i - 1) == ' ') {
        initials.append(name.charAt(i));
      }
    }
    return initials.toString();
  }
}
