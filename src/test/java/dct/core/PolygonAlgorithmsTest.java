package dct.core;

import static org.assertj.core.api.Assertions.assertThat;

import dct.core.geometry.Points;
import dct.testing.ForeignDataTest;
import dct.testing.RandomPolygons;
import dct.testing.RandomPolygons.Family;
import dct.testing.SharedData;
import dct.testing.Transforms;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every algorithm for polygons on polygons of many kinds. */
class PolygonAlgorithmsTest {
  private static final int SMALL = 250; // polygons of a family with few vertices
  private static final int MIDDLE = 8; // and with some more

  static List<Family> families() {
    return RandomPolygons.families();
  }

  @ParameterizedTest
  @MethodSource("families")
  void manySmallPolygons(Family family) {
    for (int seed = 0; seed < SMALL; seed++) {
      int n = 3 + seed % 22;
      check(family, n, seed);
    }
  }

  @ParameterizedTest
  @MethodSource("families")
  void someLargerPolygons(Family family) {
    for (int seed = 0; seed < MIDDLE; seed++) {
      check(family, 40 + 20 * seed, seed);
    }
  }

  @ParameterizedTest
  @MethodSource("families")
  void allImagesAndScales(Family family) {
    for (int seed = 1000; seed < 1006; seed++) {
      Points p = family.make(12 + seed % 7, seed);
      String what = family + ", seed " + seed + ", ";
      for (Transforms.Named image : Transforms.all(p)) {
        PolygonChecks.checkAll(image.points(), what + image);
      }
      if (!family.name().startsWith("wide range")) {
        for (Transforms.Named image : Transforms.scales(p)) {
          PolygonChecks.checkAll(image.points(), what + image);
        }
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"x-monotone", "y-monotone", "cells", "maze", "comb", "spiral"})
  void thousandsOfVertices(String name) {
    for (Family family : families()) {
      if (family.name().equals(name)) {
        check(family, 20_000, 1);
      }
    }
  }

  private static void check(Family family, int n, int seed) {
    Points p = family.make(n, seed);
    PolygonChecks.checkAll(p, "%s, n %d, seed %d".formatted(family, n, seed));
  }

  @Test
  void everyTriangle() {
    PolygonChecks.checkAll(Points.ofPairs(0, 0, 1, 0, 0, 1), "counter-clockwise");
    PolygonChecks.checkAll(Points.ofPairs(0, 0, 0, 1, 1, 0), "clockwise");
    double least = Double.MIN_VALUE;
    PolygonChecks.checkAll(Points.ofPairs(0, 0, least, 0, 0, least), "of least size");
    double most = Double.MAX_VALUE;
    PolygonChecks.checkAll(Points.ofPairs(-most, -most, most, -most, 0, most), "of largest size");
  }

  @Test
  void onlyTheCornersOfATriangleAreNotStraight() {
    for (int a = 0; a < 4; a++) {
      for (int b = 0; b < 4; b++) {
        for (int c = 0; c < 4; c++) {
          Points p = triangleWithStraightVertices(a, b, c);
          for (Transforms.Named image : Transforms.all(p)) {
            PolygonChecks.checkAll(image.points(), a + " " + b + " " + c + ", " + image);
          }
        }
      }
    }
  }

  /** A right triangle with so many further vertices inside its three sides. */
  private static Points triangleWithStraightVertices(int a, int b, int c) {
    double[] pairs = new double[2 * (3 + a + b + c)];
    int k = 0;
    for (int i = 0; i <= a; i++) {
      pairs[k++] = 12.0 * i / (a + 1);
      pairs[k++] = 0;
    }
    for (int i = 0; i <= b; i++) {
      pairs[k++] = 12 - 12.0 * i / (b + 1);
      pairs[k++] = 12.0 * i / (b + 1);
    }
    for (int i = 0; i <= c; i++) {
      pairs[k++] = 0;
      pairs[k++] = 12 - 12.0 * i / (c + 1);
    }
    return Points.ofPairs(pairs);
  }

  /** Its lowest edge rises by so little that the slope is beyond the largest number. */
  @Test
  void anEdgeNextToLevel() {
    Points p =
        Points.ofPairs(0, 0, 100, 1e-310, 100, 100, 95, 20, 80, 18, 60, 17, 40, 45, 20, 46, 0, 50);
    for (Transforms.Named image : Transforms.all(p)) {
      PolygonChecks.checkAll(image.points(), image.name());
    }
  }

  @TestFactory
  List<DynamicTest> everySample() {
    List<Path> samples = SharedData.samples("polygonbased");
    assertThat(samples).hasSizeGreaterThanOrEqualTo(12);
    return samples.stream().map(PolygonAlgorithmsTest::onAllImages).toList();
  }

  private static DynamicTest onAllImages(Path file) {
    return DynamicTest.dynamicTest(
        file.getFileName().toString(),
        () -> {
          for (Transforms.Named image : Transforms.all(SharedData.read(file))) {
            PolygonChecks.checkAll(image.points(), file + ", " + image);
          }
        });
  }

  @ForeignDataTest
  void everySharedPolygon() {
    List<Path> files = SharedData.files("polygons");
    assertThat(files).hasSizeGreaterThan(60);
    for (Path file : files) {
      PolygonChecks.checkAll(SharedData.read(file), file.getFileName().toString());
    }
  }
}
