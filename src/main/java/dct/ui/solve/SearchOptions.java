package dct.ui.solve;

import dct.core.Decimals;
import dct.core.degree.SearchLimits;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Ask;
import dct.ui.dialog.Form;
import java.awt.Component;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JTextField;

/**
 * Triangulate ▸ Search Options…: how long and how hard Most Even, Most Odd and Wished Parities
 * search in this window.
 */
public final class SearchOptions extends Form {
  private static final long serialVersionUID = 1L;
  private static final String TITLE = "Search Options";

  private final JTextField seconds = new JTextField(12);
  private final JTextField seed = new JTextField(12);
  private final JTextField effort = new JTextField(12);
  private SearchLimits limits = SearchLimits.DEFAULT;

  /**
   * The usual options.
   *
   * @param copy takes the limits for which the call of a search is to be copied
   */
  public SearchOptions(Consumer<SearchLimits> copy) {
    seconds.putClientProperty("JTextField.placeholderText", "none");
    ask("Time limit in seconds:", 't', "seconds", seconds, "Empty for none; Esc ends a search too");
    ask("Seed:", 's', "seed", seed, "Of the random choices; the same gives the same result");
    ask("Effort:", 'e', "effort", effort, "1 is usual; 2 takes about twice as long");
    offerCopy(
        () -> {
          try {
            copy.accept(typed());
          } catch (IllegalArgumentException e) {
            Ask.sorry(this, TITLE, e.getMessage());
          }
        });
    write();
  }

  @Override
  protected JTextField first() {
    return seconds;
  }

  /** What searches are given. */
  public SearchLimits limits() {
    return limits;
  }

  /** Offers the command that asks for other options. */
  public void offer(CommandRegistry commands, Component parent) {
    commands.add(
        TITLE + "…",
        "",
        "Time limit, seed and effort of the searches in this window",
        () -> ask(parent));
  }

  /** Asks for other options until they can be, or Cancel is chosen. */
  private void ask(Component parent) {
    while (show(parent, TITLE)) {
      try {
        limits = typed();
        return;
      } catch (IllegalArgumentException e) {
        Ask.sorry(parent, TITLE, e.getMessage());
      }
    }
    write();
  }

  private void write() {
    seconds.setText(Double.isFinite(limits.seconds()) ? Decimals.format(limits.seconds()) : "");
    seed.setText(Long.toString(limits.seed()));
    effort.setText(Decimals.format(limits.effort()));
  }

  private SearchLimits typed() {
    String limit = seconds.getText().strip();
    double most = limit.isEmpty() ? Double.POSITIVE_INFINITY : number(limit, "time limit", 0);
    long chosen = whole(seed, Long.MIN_VALUE, Long.MAX_VALUE, "seed");
    return new SearchLimits(chosen, number(effort.getText().strip(), "effort", 0.01), most);
  }

  private static double number(String typed, String what, double least) {
    double value = Decimals.parse(typed);
    if (Double.isFinite(value) && value >= least) {
      return value;
    }
    throw new IllegalArgumentException(
        String.format(
            Locale.ROOT,
            "“%s” is no %s; type a number such as 2.5, %s or more.",
            typed,
            what,
            Decimals.format(least)));
  }
}
