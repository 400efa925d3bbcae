package dct.ui.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.ui.command.CommandMenu.Plan;
import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.NoSuchElementException;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;

class CommandRegistryTest {
  private final CommandRegistry commands = new CommandRegistry();
  private int runs;

  @Test
  void aCommandRunsOnlyWhileItIsEnabled() {
    boolean[] enabled = {false};
    Command command =
        commands.add("Flip", "F", "Flips", () -> runs++).enabledWhen(() -> enabled[0]);
    command.perform();
    assertThat(runs).isZero();
    enabled[0] = true;
    commands.refresh();
    command.perform();
    assertThat(runs).isEqualTo(1);
  }

  @Test
  void oneNameAndOneKeyBelongToOneCommand() {
    commands.add("Zoom In", "ctrl PLUS", "Zooms", () -> {}).alsoOn("ctrl EQUALS");
    assertThatThrownBy(() -> commands.add("Zoom In", "", "Zooms", () -> {}))
        .hasMessageContaining("two commands Zoom In");
    assertThatThrownBy(() -> commands.add("Other", "ctrl EQUALS", "Zooms", () -> {}))
        .hasMessageContaining("Other and Zoom In have one key");
    assertThatThrownBy(() -> commands.get("None")).isInstanceOf(NoSuchElementException.class);
  }

  @Test
  void aMenuHasTheItemsOfItsPlanEachWithALetterOfItsOwn() {
    commands.add("Save", "", "Saves", () -> {});
    commands.add("Save As…", "", "Saves elsewhere", () -> {});
    commands.add("Select All", "", "Selects", () -> {}).selectedWhen(() -> true);
    commands.addSubmenu("Samples", menu -> menu.add(new JMenuItem("First")));
    Plan plan = Plan.of("File", "Save", "Save As…", CommandMenu.LINE, "Select All", "Samples");
    JMenuBar bar = CommandMenu.bar(List.of(plan), commands);
    JMenu menu = bar.getMenu(0);
    List<String> names = new ArrayList<>();
    List<Integer> letters = new ArrayList<>();
    for (Component item : menu.getMenuComponents()) {
      if (item instanceof JMenuItem button) {
        names.add(button.getText());
        letters.add(button.getMnemonic());
      }
    }
    assertThat(names).containsExactly("Save", "Save As…", "Select All", "Samples");
    assertThat(letters).doesNotHaveDuplicates().doesNotContain(0);
    assertThat(menu.getItem(3)).isInstanceOf(JCheckBoxMenuItem.class);
    assertThat(menu.getItem(3).isSelected()).isTrue();
    assertThat(((JMenu) menu.getItem(4)).getItem(0).getText()).isEqualTo("First");
  }

  @Test
  void menusShowTheFirstKeyAndAllKeysAreKnown() {
    Command command = commands.add("Redo", "ctrl shift Z", "Again", () -> {}).alsoOn("ctrl Y");
    assertThat(command.keyText()).isEqualTo("Ctrl+Shift+Z");
    assertThat(command.keys())
        .containsExactly(KeyStroke.getKeyStroke("ctrl shift Z"), KeyStroke.getKeyStroke("ctrl Y"));
  }

  @Test
  void itemsMakeWaySoThatEachHasALetter() {
    commands.add("None", "", "Nothing", () -> {});
    commands.add("One", "", "One", () -> {});
    commands.add("Neon", "", "Neon", () -> {});
    commands.add("Ox", "", "Ox", () -> {});
    Plan plan = Plan.of("File", "Ox", "One", "Neon", "None");
    JMenu menu = CommandMenu.bar(List.of(plan), commands).getMenu(0);
    List<Integer> letters = new ArrayList<>();
    for (int i = 0; i < menu.getItemCount(); i++) {
      letters.add(menu.getItem(i).getMnemonic());
    }
    assertThat(letters).doesNotHaveDuplicates().doesNotContain(0);
  }
}
