package dct.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import dct.core.Progress;
import dct.core.triangulate.Domain;
import dct.experiment.generate.RandomSites;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.testing.ProgramProcess;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What other programs make of our pictures: poppler, librsvg, Ipe and pdfTeX open them, and what
 * they show has its ink where our PNG has it. A program that is missing is a failure: {@code
 * .ci/run} installs them all.
 */
@Tag("consumers")
class FigureConsumersTest {
  private static final int ACROSS = 24; // cells that ink is compared in
  private static final String DOTS = "300";

  @TempDir static Path folder;
  private static int[] ink; // of our own PNG

  @BeforeAll
  static void write() throws IOException {
    Instance sites = Instance.of(Domain.SITES, "sites", RandomSites.uniform(40, 3), Progress.NONE);
    Solution solution =
        Solution.of(sites, Method.byDefault(Domain.SITES), Progress.NONE).flipped(Progress.NONE);
    Figure figure =
        Figure.DEFAULT.withLegend(true).withLabels(new Labels(true, false)).withTheme(Theme.PRINT);
    for (String ending : List.of("png", "pdf", "svg", "ipe", "tex")) {
      Path file = folder.resolve("a." + ending);
      PictureFile.write(Scene.of(solution), figure, "sites", file, Progress.NONE);
    }
    Figure whole =
        new Figure(figure.size(), 1, true, Labels.NONE, true, true, false, figure.theme(), true);
    Path tex = folder.resolve("whole.tex");
    PictureFile.write(Scene.of(solution), whole, "sites", tex, Progress.NONE);
    ink = ink(folder.resolve("a.png"));
  }

  private static String run(String... command) throws Exception {
    Process process =
        new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    String said = ProgramProcess.text(process.getInputStream());
    assertThat(process.waitFor()).as(said).isZero();
    return said;
  }

  /** How dark each cell of a picture is, row by row, 0 to 255. */
  private static int[] ink(Path file) throws IOException {
    BufferedImage image = ImageIO.read(new File(file.toString()));
    int down = Math.max(1, ACROSS * image.getHeight() / image.getWidth());
    BufferedImage small = new BufferedImage(ACROSS, down, BufferedImage.TYPE_BYTE_GRAY);
    Graphics2D graphics = small.createGraphics();
    graphics.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    graphics.drawImage(
        image.getScaledInstance(ACROSS, down, java.awt.Image.SCALE_AREA_AVERAGING), 0, 0, null);
    graphics.dispose();
    int[] cells = new int[ACROSS * down];
    for (int i = 0; i < cells.length; i++) {
      cells[i] = 255 - small.getRaster().getSample(i % ACROSS, i / ACROSS, 0);
    }
    return cells;
  }

  /** The picture is dark where ours is: its cells differ little, and less than those of others. */
  private static void assertLooksLikeOurs(Path file) throws IOException {
    int[] theirs = ink(file);
    assertThat(theirs).hasSameSizeAs(ink);
    long apart = 0;
    long mirrored = 0;
    for (int i = 0; i < ink.length; i++) {
      apart += Math.abs(ink[i] - theirs[i]);
      mirrored += Math.abs(ink[i] - theirs[theirs.length - 1 - i]);
    }
    assertThat(apart / (double) ink.length).as("%s", file).isLessThan(12);
    assertThat(3 * apart).as("%s, upside down: %d", file, mirrored).isLessThan(mirrored);
  }

  private static void assertPdfLooksLikeOurs(String name) throws Exception {
    run("pdftoppm", "-r", DOTS, "-png", "-singlefile", name + ".pdf", name + "-pdf");
    assertLooksLikeOurs(folder.resolve(name + "-pdf.png"));
  }

  @Test
  void poppler_finds_an_embedded_font_and_the_labels() throws Exception {
    String fonts = run("pdffonts", "a.pdf");
    assertThat(fonts).containsPattern("\\+LiberationSans +CID TrueType +Identity-H +yes yes yes");
    assertThat(run("pdftotext", "-layout", "a.pdf", "-").split("\\s+", -1))
        .contains("v0", "v39", "Even", "degree");
    assertThat(run("pdfinfo", "a.pdf")).contains("sites").containsPattern("Page size: +238\\.11 x");
    assertPdfLooksLikeOurs("a");
  }

  @Test
  void librsvg_draws_the_same() throws Exception {
    run("rsvg-convert", "--width", "992", "a.svg", "-o", "svg.png");
    assertLooksLikeOurs(folder.resolve("svg.png"));
  }

  @Test
  void ipe_opens_it_and_draws_the_same() throws Exception {
    run("ipetoipe", "-pdf", "a.ipe", "ipe.pdf");
    assertPdfLooksLikeOurs("ipe");
  }

  @Test
  void tex_reads_the_part_into_a_document() throws Exception {
    Files.writeString(
        folder.resolve("page.tex"),
        """
        \\documentclass{article}
        \\usepackage{tikz}
        \\pagestyle{empty}\\parindent0pt
        \\pdfpagewidth238.11bp \\pdfpageheight500bp
        \\hoffset-1in\\voffset-1in
        \\oddsidemargin0pt\\topmargin0pt\\headheight0pt\\headsep0pt\\topskip0pt
        \\begin{document}\\input{a.tex}\\typeout{OK}\\end{document}
        """);
    assertThat(run("pdflatex", "-interaction=nonstopmode", "-halt-on-error", "page.tex"))
        .contains("OK")
        .doesNotContain("Font Warning");
    assertThat(run("pdffonts", "page.pdf")).contains("CMR");
  }

  /** The class standalone is in a large package of TeX Live, which need not be there. */
  @Test
  void tex_compiles_the_document_of_its_own() throws Exception {
    Process found = new ProcessBuilder("kpsewhich", "standalone.cls").start();
    assumeThat(found.waitFor()).as("standalone.cls is installed").isZero();
    run("pdflatex", "-interaction=nonstopmode", "-halt-on-error", "whole.tex");
    assertThat(run("pdfinfo", "whole.pdf")).containsPattern("Page size: +238\\.11 x");
    assertThat(run("pdftotext", "-layout", "whole.pdf", "-")).contains("Even", "degree");
  }
}
