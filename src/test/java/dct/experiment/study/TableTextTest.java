package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;

class TableTextTest {
  private static final Table TABLE =
      new Table(
          "Shares in %",
          List.of("File", "n"),
          List.of(List.of("a_b|c.txt", "12"), List.of("d", "5.00 ± 1.00")),
          List.of("Read it & weep."));
  private static final Table EMPTY = new Table("None", List.of("n"), List.of(), List.of());

  @Test
  void markdown_is_padded_and_escaped() {
    assertThat(MarkdownText.of(List.of(EMPTY, TABLE)))
        .isEqualTo(
            """
            ### Shares in %

            | File       |           n |
            | ---------- | ----------: |
            | a_b\\|c.txt |          12 |
            | d          | 5.00 ± 1.00 |

            Read it & weep.
            """);
  }

  @Test
  void latex_is_escaped() {
    assertThat(LatexText.of(List.of(TABLE, EMPTY)))
        .isEqualTo(
            """
            % needs \\usepackage{booktabs,graphicx}
            \\begin{table}
            \\centering
            \\caption{Shares in \\%. Read it \\& weep.}
            \\resizebox{\\textwidth}{!}{%
            \\begin{tabular}{lr}
            \\toprule
            File & n \\\\
            \\midrule
            a\\_b|c.txt & 12 \\\\
            d & 5.00 $\\pm$ 1.00 \\\\
            \\bottomrule
            \\end{tabular}}
            \\end{table}
            """);
  }

  @Test
  void rows_that_are_not_whole_are_refused() {
    assertThatThrownBy(() -> new Table("x", List.of("a", "b"), List.of(List.of("1")), List.of()))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
