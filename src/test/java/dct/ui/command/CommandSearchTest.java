package dct.ui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class CommandSearchTest {
  private static final List<Command> COMMANDS =
      List.of(
          command("Clear Canvas", "Removes all vertices"),
          command("Most Even Vertices", "Finds the triangulation with the most even vertices"),
          command("Most Odd Vertices", "Finds the triangulation with the most odd vertices")
              .enabledWhen(() -> false),
          command("Monotone Polygon Triangulation", "Cuts the polygon into monotone pieces"),
          command("Open", "Opens a polygon or sites"),
          command("Export Picture", "Writes what is seen: .png, .svg"),
          command("Zoom In", "Shows less, larger"));

  private static Command command(String name, String description) {
    return new Command(name, "", description, () -> {});
  }

  private static List<String> find(String typed) {
    return CommandSearch.find(typed, COMMANDS).stream().map(Command::id).toList();
  }

  @Test
  void withoutAWordEveryCommandIsFoundTheEnabledOnesFirst() {
    assertThat(find(" ")).hasSize(COMMANDS.size()).endsWith("Most Odd Vertices");
  }

  @Test
  void theBeginningOfANameComesFirst() {
    assertThat(find("open")).first().isEqualTo("Open");
    assertThat(find("Mo"))
        .startsWith("Most Even Vertices", "Monotone Polygon Triangulation", "Most Odd Vertices");
  }

  @Test
  void wordsMayBeShortenedAndLeftOut() {
    assertThat(find("mo od")).first().isEqualTo("Most Odd Vertices");
    assertThat(find("triang")).first().isEqualTo("Monotone Polygon Triangulation");
  }

  @Test
  void firstLettersAndLettersInOrderFind() {
    assertThat(find("mev")).first().isEqualTo("Most Even Vertices");
    assertThat(find("exppic")).containsExactly("Export Picture");
  }

  @Test
  void whatItDoesFindsToo() {
    assertThat(find(".svg")).containsExactly("Export Picture");
    assertThat(find("no such thing")).isEmpty();
  }
}
