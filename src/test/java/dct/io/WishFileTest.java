package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import dct.core.Progress;
import dct.core.degree.ParityGoal;
import dct.core.degree.ParityGoal.Wish;
import dct.io.text.BadInputException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WishFileTest {
  @TempDir Path folder;

  @Test
  void whatIsWrittenIsRead() throws Exception {
    Path file = folder.resolve("wishes.txt");
    for (long seed = 0; seed < 30; seed++) {
      ParityGoal goal = random(seed);
      WishFile.write(file, goal, Progress.NONE);
      assertThat(WishFile.read(file, goal.size(), Progress.NONE))
          .as("seed %d", seed)
          .isEqualTo(goal);
    }
  }

  private static ParityGoal random(long seed) {
    Random random = new Random(seed);
    Wish[] wishes = new Wish[random.nextInt(20)];
    for (int v = 0; v < wishes.length; v++) {
      wishes[v] = List.of(Wish.values()).get(random.nextInt(3));
    }
    return ParityGoal.of(wishes);
  }

  @Test
  void onlyWhatIsNotEvenIsWritten() throws Exception {
    Path file = folder.resolve("wishes.txt");
    WishFile.write(file, ParityGoal.of(Wish.EVEN, Wish.ODD, Wish.EVEN, Wish.ANY), Progress.NONE);
    assertThat(Files.readString(file)).isEqualTo("1 odd\n3 any\n");
  }

  @Test
  void aLineThatIsNoWishIsNamed() throws Exception {
    Path file = folder.resolve("wishes.txt");
    Files.writeString(file, "1 odd\n2 strange\n");
    assertThatThrownBy(() -> WishFile.read(file, 5, Progress.NONE))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(":2: this is no wish for a vertex");
  }
}
