package dct.bench;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.experiment.generate.PolygonShape;
import dct.io.CannotWriteException;
import dct.io.PointFile;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** The program as a process of its own: its time from start to end, and the heap it needs. */
final class ProgramTable {
  private static final int RUNS = 9;
  private static final int[] HEAPS = {200, 250, 300, 350, 400, 500, 700, 1000}; // megabytes
  private static final int MANY = 1_000_000;

  private final PrintStream out;

  ProgramTable(PrintStream out) {
    this.out = out;
  }

  void run() throws IOException, CannotWriteException {
    Path folder = Files.createTempDirectory("dct");
    try {
      print(folder);
    } finally {
      try (Stream<Path> left = Files.walk(folder)) {
        left.map(Path::toFile).forEach(File::deleteOnExit); // the last one first
      }
    }
  }

  private void print(Path folder) throws CannotWriteException {
    Path ten = folder.resolve("ten_polygonbased.txt");
    PointFile.write(
        ten, Domain.POLYGON, PolygonShape.STAR_SHAPED.generate(10, 1).points(), Progress.NONE);
    Path many = folder.resolve("many_pointbased.txt");
    double[][] sites = SiteFamily.UNIFORM.make(MANY);
    PointFile.write(many, Domain.SITES, Points.of(sites[0], sites[1]), Progress.NONE);
    out.println("\n## The program as a process\n");
    out.println("| what | figure |");
    out.println("|---|---:|");
    out.printf("| `dct triangulate` on 10 vertices, median of %d | %.2f s |%n", RUNS, median(ten));
    out.printf("| `dct triangulate --flip` on %,d sites | %.2f s |%n", MANY, seconds(many, 2000));
    out.printf("| the least heap that suffices for it | %d MB |%n", leastHeap(many));
  }

  private static double median(Path file) {
    return Contest.median(IntStream.range(0, RUNS).mapToDouble(i -> seconds(file, 500)).toArray());
  }

  private static int leastHeap(Path file) {
    for (int heap : HEAPS) {
      if (!Double.isNaN(seconds(file, heap))) {
        return heap;
      }
    }
    throw new IllegalStateException("no heap suffices");
  }

  /** How long the whole process takes with so many megabytes; not a number if it fails. */
  private static double seconds(Path file, int heap) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-Xmx" + heap + "m");
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), "dct.Main"));
    command.addAll(List.of("triangulate", file.toString(), "--flip", "--json"));
    try {
      long start = System.nanoTime();
      Process process =
          new ProcessBuilder(command)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(new File(file + ".log"))
              .start();
      int status = process.waitFor();
      return status == 0 ? (System.nanoTime() - start) * 1e-9 : Double.NaN;
    } catch (IOException | InterruptedException e) {
      throw new IllegalStateException("the program cannot be started", e);
    }
  }
}
