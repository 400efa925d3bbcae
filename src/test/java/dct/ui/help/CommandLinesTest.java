package dct.ui.help;

import static org.assertj.core.api.Assertions.assertThat;

import dct.ui.command.CommandMenu.Plan;
import dct.ui.command.CommandRegistry;
import java.util.List;
import org.junit.jupiter.api.Test;

class CommandLinesTest {
  private static List<CommandLines> lines() {
    CommandRegistry commands = new CommandRegistry();
    commands.add("Give Up", "ESCAPE", "Stops what goes on", () -> {});
    commands.add("Redo", "ctrl shift Z", "Does it again", () -> {}).alsoOn("ctrl Y");
    commands.add("Open", "ctrl O", "Opens a file", () -> {});
    commands.addSubmenu("Open Sample", menu -> {});
    return CommandLines.of(
        List.of(Plan.of("File", "Open", "Open Sample"), Plan.of("Edit", "-", "Redo")), commands);
  }

  @Test
  void theMenusComeInTheirOrderThenTheKeysOfNoMenu() {
    assertThat(lines())
        .containsExactly(
            new CommandLines("File", "Open", "Ctrl+O", "Opens a file"),
            new CommandLines("File", "Open Sample", "", "A menu of its own"),
            new CommandLines("Edit", "Redo", "Ctrl+Shift+Z or Ctrl+Y", "Does it again"),
            new CommandLines("Keys", "Give Up", "Escape", "Stops what goes on"));
  }

  @Test
  void aSearchKeepsTheLinesThatHoldEachWord() {
    CommandLinesModel model = new CommandLinesModel(lines());
    assertThat(model.getRowCount()).isEqualTo(4);
    assertThat(model.beginsGroup(0)).isTrue();
    assertThat(model.beginsGroup(1)).isFalse();
    model.search("ctrl+ FILE");
    assertThat(model.getRowCount()).isEqualTo(1);
    assertThat(model.getValueAt(0, 1)).isEqualTo("Open");
    model.search("again y");
    assertThat(model.getValueAt(0, 1)).isEqualTo("Redo");
    model.search("nothing");
    assertThat(model.getRowCount()).isZero();
  }
}
