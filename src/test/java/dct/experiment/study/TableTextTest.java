package dct.experiment.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

class TableTextTest {
  private static final Table TABLE =
      new Table(
          "Shares in %",
          1,
          List.of("File", "n"),
          List.of(List.of("a_b|c.txt", "12"), List.of("d", "5.00 ± 1.00")),
          List.of("Read it & weep."));
  private static final Table EMPTY = new Table("None", 0, List.of("n"), List.of(), List.of());

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
            \\footnotesize
            \\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%
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

  /** Eleven columns of ten letters and a long head; the last two heads belong together. */
  private static Table wide(int rows) {
    List<String> columns = new ArrayList<>(List.of("Shape of it"));
    List<String> row = new ArrayList<>(List.of("comb"));
    for (int c = 1; c <= 10; c++) {
      columns.add(c < 10 ? "Column " + c : "column " + c);
      row.add("0123456789");
    }
    return new Table("Wide", 1, columns, Collections.nCopies(rows, row), List.of());
  }

  @Test
  void what_is_too_wide_for_a_page_is_cut_between_groups_of_columns() {
    String text = LatexText.of(List.of(wide(3)));
    assertThat(text)
        .contains("\\caption{Wide, part 1 of 2.}", "\\caption{Wide, part 2 of 2.}")
        .doesNotContain("part 3");
    assertThat(text.lines().filter(line -> line.startsWith("\\begin{tabular}")))
        .containsExactly("\\begin{tabular}{lrrrrrr}", "\\begin{tabular}{lrrrr}");
    assertThat(text.lines().filter(line -> line.contains("stack")))
        .allMatch(line -> line.startsWith("\\shortstack[l]{Shape\\\\of\\\\it} & "))
        .hasSize(2);
  }

  @Test
  void columns_that_belong_together_stay_together() {
    Table table = wide(1);
    List<String> heads = new ArrayList<>(table.columns());
    heads.set(7, "column 7");
    String text = LatexText.of(List.of(new Table("Wide", 1, heads, table.rows(), table.notes())));
    assertThat(text.lines().filter(line -> line.startsWith("\\begin{tabular}")))
        .containsExactly("\\begin{tabular}{lrrrrr}", "\\begin{tabular}{lrrrrr}");
  }

  @Test
  void what_is_too_long_for_a_page_is_cut_between_rows() {
    Table table =
        new Table("Long", 1, List.of("a"), Collections.nCopies(100, List.of("7")), List.of());
    String text = LatexText.of(List.of(table));
    assertThat(text).contains("part 3 of 3").doesNotContain("part 4");
    assertThat(text.lines().filter("7 \\\\"::equals)).hasSize(100);
  }

  @Test
  void rows_that_are_not_whole_are_refused() {
    assertThatThrownBy(() -> new Table("x", 1, List.of("a", "b"), List.of(List.of("1")), List.of()))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
