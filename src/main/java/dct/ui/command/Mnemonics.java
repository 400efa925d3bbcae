package dct.ui.command;

import java.awt.Component;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javax.swing.JMenu;
import javax.swing.JMenuItem;

/**
 * Underlined letters for the items of a menu. An item gets the first letter of a word of its name
 * if it can; where too few letters are left, items before it make way (augmenting paths), so that
 * as many as possible have one of their own. In a menu of more items than their names have letters,
 * the others share a letter: it goes from one to the next.
 */
final class Mnemonics {
  private final Map<Character, JMenuItem> taken = new HashMap<>();

  private Mnemonics() {}

  /** Gives each item of a menu a letter. */
  static void give(JMenu menu) {
    List<JMenuItem> items = new ArrayList<>();
    for (Component item : menu.getMenuComponents()) {
      if (item instanceof JMenuItem button) {
        items.add(button);
      }
    }
    give(items);
  }

  /** Gives each of these items, which may be menus, a letter. */
  static void give(List<? extends JMenuItem> items) {
    Mnemonics letters = new Mnemonics();
    for (JMenuItem item : items) {
      if (!letters.place(item, new HashSet<>())) {
        item.setMnemonic(letters(item.getText()).get(0));
      }
    }
    letters.taken.forEach((letter, item) -> item.setMnemonic(letter));
  }

  /** Finds a letter for an item, moving others where that helps. */
  private boolean place(JMenuItem item, Set<Character> tried) {
    List<Character> letters = letters(item.getText());
    for (char letter : letters) {
      if (!taken.containsKey(letter)) {
        taken.put(letter, item);
        return true;
      }
    }
    for (char letter : letters) {
      if (tried.add(letter) && place(taken.get(letter), tried)) {
        taken.put(letter, item);
        return true;
      }
    }
    return false;
  }

  /** The letters and digits of a name, those that begin a word first. */
  private static List<Character> letters(String name) {
    List<Character> initials = new ArrayList<>();
    List<Character> others = new ArrayList<>();
    String small = name.toLowerCase(Locale.ROOT);
    for (int i = 0; i < small.length(); i++) {
      char c = small.charAt(i);
      boolean plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
      if (plain) {
        (i == 0 || small.charAt(i - 1) == ' ' ? initials : others).add(c);
      }
    }
    initials.addAll(others);
    return initials;
  }
}
