package dct.ui.command;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;

/**
 * Finds commands by what a person types: the beginning of the name, the beginnings of its words
 * ("mo ev"), their first letters ("mev"), a part of it, its letters in order, or a part of the
 * description; in this order, and what is enabled first.
 */
public final class CommandSearch {

  private CommandSearch() {}

  private record Found(Command command, int rank) {}

  /** The commands that match, the best first; all of them if nothing was typed. */
  public static List<Command> find(String typed, List<Command> commands) {
    String wanted = typed.strip().toLowerCase(Locale.ROOT);
    List<Found> found = new ArrayList<>();
    for (Command command : commands) {
      rank(wanted, command).ifPresent(rank -> found.add(new Found(command, rank)));
    }
    found.sort(
        Comparator.comparingInt(Found::rank).thenComparing(f -> !f.command.isEnabled())); // stable
    return found.stream().map(Found::command).toList();
  }

  private static OptionalInt rank(String wanted, Command command) {
    String name = command.name().toLowerCase(Locale.ROOT);
    if (name.startsWith(wanted)) {
      return OptionalInt.of(0);
    }
    if (beginsWords(wanted, name)) {
      return OptionalInt.of(1);
    }
    if (initials(name).contains(wanted)) {
      return OptionalInt.of(2);
    }
    if (name.contains(wanted)) {
      return OptionalInt.of(3);
    }
    if (holdsInOrder(name, wanted)) {
      return OptionalInt.of(4);
    }
    boolean described = command.description().toLowerCase(Locale.ROOT).contains(wanted);
    return described ? OptionalInt.of(5) : OptionalInt.empty();
  }

  /** Whether each word wanted begins a word of the name, in this order. */
  private static boolean beginsWords(String wanted, String name) {
    String[] words = words(name);
    int next = 0;
    for (String part : words(wanted)) {
      while (next < words.length && !words[next].startsWith(part)) {
        next++;
      }
      if (next == words.length) {
        return false;
      }
      next++;
    }
    return true;
  }

  private static String[] words(String text) {
    return text.split("[^\\p{L}\\p{N}]+", -1);
  }

  private static String initials(String name) {
    StringBuilder initials = new StringBuilder();
    for (String word : words(name)) {
      initials.append(word, 0, Math.min(1, word.length()));
    }
    return initials.toString();
  }

  private static boolean holdsInOrder(String name, String wanted) {
    int from = 0;
    for (int i = 0; i < wanted.length(); i++) {
      from = name.indexOf(wanted.charAt(i), from) + 1;
      if (from == 0) {
        return false;
      }
    }
    return true;
  }
}
