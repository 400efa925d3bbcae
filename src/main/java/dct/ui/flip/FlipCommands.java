package dct.ui.flip;

import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import java.util.function.BooleanSupplier;

/** The commands of the flips of a view, and the panel that shows them. */
public final class FlipCommands {
  private final FlipDesk desk;
  private final BooleanSupplier suits;
  private final FlipShow show;
  private final FlipPanel panel;
  private boolean on; // the panel is wanted

  private FlipCommands(
      FlipDesk desk, CommandRegistry registry, Lists lists, BooleanSupplier suits) {
    this.desk = desk;
    this.suits = suits;
    show = new FlipShow(desk);
    offer(registry, lists);
    panel = new FlipPanel(desk, show, registry);
  }

  /** What can be done with lists of flips. */
  public interface Lists {
    /** Asks for a file and writes the flips to it. */
    void save();

    /** Asks for a file and carries out the flips that it lists. */
    void load();

    /** Takes the flips to the clipboard. */
    void copy();

    /** Carries out the flips in the clipboard. */
    void apply();
  }

  /**
   * Offers the commands of a view.
   *
   * @param canvas where the view is drawn; flips that are played are marked there
   * @param suits whether the view is one of a triangulation now
   */
  public static FlipCommands offer(
      CommandRegistry registry,
      FlipDesk desk,
      Lists lists,
      CanvasPanel canvas,
      BooleanSupplier suits) {
    canvas.addOverlay(pen -> FlipMark.paint(desk.replay(), canvas.viewport(), pen));
    return new FlipCommands(desk, registry, lists, suits);
  }

  private void offer(CommandRegistry registry, Lists lists) {
    registry
        .add("Flips", "ctrl shift L", "Lists what was flipped, and plays it", this::toggle)
        .selectedWhen(() -> on);
    step(
        registry,
        "First Flip",
        "ctrl HOME",
        "Shows the state before all flips",
        () -> show.goTo(0));
    step(registry, "Previous Flip", "ctrl LEFT", "Shows one flip less", () -> show.goBy(-1));
    step(registry, "Play Flips", "ctrl P", "Plays the flips, or stops", show::playOrStop);
    step(registry, "Next Flip", "ctrl RIGHT", "Shows one flip more", () -> show.goBy(1));
    step(
        registry,
        "Last Flip",
        "ctrl END",
        "Shows the state after all flips",
        () -> show.goTo(desk.replay().size()));
    registry
        .add(
            "Go On from Here",
            "ctrl ENTER",
            "Makes the state shown the present one",
            desk::goOnFromHere)
        .enabledWhen(() -> isOn() && !desk.replay().isAtEnd());
    step(registry, "Save Flips…", "", "Writes the list of flips to a file", lists::save);
    registry
        .add("Load Flips…", "", "Carries out the flips that a file lists", lists::load)
        .enabledWhen(this::isOn);
    step(registry, "Copy Flips", "", "Takes the list of flips to the clipboard", lists::copy);
    registry
        .add("Apply Copied Flips", "", "Carries out the flips in the clipboard", lists::apply)
        .enabledWhen(this::isOn);
  }

  private void step(
      CommandRegistry registry, String name, String key, String description, Runnable run) {
    registry.add(name, key, description, run).enabledWhen(() -> isOn() && desk.replay().size() > 0);
  }

  private boolean isOn() {
    return suits.getAsBoolean() && desk.shown().isPresent();
  }

  /** The list of the flips and their player. */
  public FlipPanel panel() {
    return panel;
  }

  /** Brings everything up to date. */
  public void refresh() {
    desk.refresh();
    panel.setShown(on && suits.getAsBoolean());
  }

  /** Whether the panel is wanted. */
  public boolean isWanted() {
    return on;
  }

  /** Shows the panel, or hides it. */
  public void setWanted(boolean wanted) {
    on = wanted;
    refresh();
  }

  private void toggle() {
    setWanted(!on);
  }
}
