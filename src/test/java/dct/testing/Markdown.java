package dct.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The code blocks of a page in Markdown. */
public final class Markdown {
  private static final String PROMPT = "$ ";

  /**
   * A command after a prompt, and what stands below it.
   *
   * @param command the command, without its prompt
   * @param output the lines up to the next prompt or the end of the block
   */
  public record Shell(String command, String output) {}

  private final List<List<String>> blocks = new ArrayList<>();

  private Markdown(List<String> lines) {
    boolean code = false;
    for (String line : lines) {
      if (line.startsWith("```")) {
        code = !code;
        if (code) {
          blocks.add(new ArrayList<>());
        }
      } else if (code) {
        blocks.get(blocks.size() - 1).add(line);
      }
    }
  }

  /** The page in this file. */
  public static Markdown of(Path file) throws IOException {
    return new Markdown(Files.readAllLines(file));
  }

  /** The lines of all code blocks. */
  public List<String> codeLines() {
    return blocks.stream().flatMap(List::stream).toList();
  }

  /** The commands after prompts, each with its output. */
  public List<Shell> examples() {
    List<Shell> examples = new ArrayList<>();
    for (List<String> block : blocks) {
      for (int start = 0; start < block.size(); start++) {
        if (block.get(start).startsWith(PROMPT)) {
          examples.add(example(block, start));
        }
      }
    }
    return examples;
  }

  private static Shell example(List<String> block, int start) {
    StringBuilder output = new StringBuilder();
    for (String line : block.subList(start + 1, block.size())) {
      if (line.startsWith(PROMPT)) {
        break;
      }
      output.append(line).append('\n');
    }
    return new Shell(block.get(start).substring(PROMPT.length()), output.toString());
  }
}
