package dct.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.geometry.Region;
import dct.core.geometry.Rings;
import dct.core.triangulate.Domain;
import dct.core.triangulate.EdgeKind;
import dct.io.format.CannotHold;
import dct.io.format.Choice;
import dct.io.format.Columns;
import dct.io.format.Drawing;
import dct.io.format.Touch;
import dct.io.text.BadInputException;
import dct.problem.Comparison;
import dct.problem.Instance;
import dct.problem.Method;
import dct.problem.Solution;
import dct.testing.RandomRegions;
import dct.testing.RandomSets;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Regions with holes, sites and fixed edges in files. A slash stands for a line break.
 *
 * <pre>
 * PointDocument read = PointFile.read(name, in, Choice.NONE.as(Domain.REGION));
 * Rings rings = read.rings().orElseThrow();
 * </pre>
 */
class RegionFileTest {
  private static final Choice AS_REGION = Choice.NONE.as(Domain.REGION);

  private static PointDocument read(String text, Choice choice) throws IOException {
    byte[] bytes = text.replace('/', '\n').getBytes(StandardCharsets.UTF_8);
    return PointFile.read("in", new ByteArrayInputStream(bytes), choice);
  }

  private static String fault(String text, Choice choice) {
    return catchThrowableOfType(
            BadInputException.class, () -> read(text, choice).instance(Progress.NONE))
        .getMessage();
  }

  /** Its rings and fixed edges by the numbers of their vertices. */
  private static String words(PointDocument document) {
    Rings rings = document.rings().orElseThrow();
    List<String> all = new ArrayList<>();
    for (int r = 0; r < rings.count(); r++) {
      all.add(Arrays.toString(rings.ring(r)));
    }
    return String.join(" ", all)
        + " of "
        + rings.points().size()
        + ", fixed "
        + Arrays.toString(rings.fixed());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "POLYGON ((0 0, 9 0, 9 9, 0 0), (4 1, 5 1, 5 2, 4 1)) | [0, 1, 2] [3, 4, 5] of 6",
        "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[9,0],[9,9],[0,0]],[[4,1],[5,1],[5,2],[4,1]]]}"
            + " | [0, 1, 2] [3, 4, 5] of 6",
        "0 0/9 0/9 9/HOLE/4 1/5 1/5 2/STEINER/7 1 | [0, 1, 2] [3, 4, 5] of 7",
        "0 0/9 0/9 9/hole/4 1/5 1/5 2/sites/7 1/8 1 | [0, 1, 2] [3, 4, 5] of 8",
        "4/0 0/9 0/9 9/0 0/4/4 1/5 1/5 2/4 1 | [0, 1, 2] [3, 4, 5] of 6",
        "4/4 1/5 1/5 2/4 1/4/0 0/9 0/9 9/0 0 | [3, 4, 5] [0, 1, 2] of 6",
        "0 0/9 0/9 9//4 1/5 1/5 2 | [0, 1, 2] [3, 4, 5] of 6",
        "0 0/9 0/9 9 | [0, 1, 2] of 3",
      })
  void formatsWithRingsHoldRegions(String text, String words) throws IOException {
    PointDocument read = read(text, AS_REGION);
    assertThat(words(read)).isEqualTo(words + ", fixed []");
    assertThat(read.domain()).isEqualTo(Domain.REGION);
    assertThat(read.instance(Progress.NONE)).isInstanceOf(Instance.OfRegion.class);
  }

  /** The outline with a fixed edge from vertex 1, a chain in it, a ring round a hole, a site. */
  @Test
  void trianglesSegmentsAreRingsRoundHolesAndFixedEdges() throws IOException {
    String nodes = "9 2 0 0/1 5 2/2 0 0/3 9 0/4 9 9/5 4 1/6 5 1/7 5 1.5/8 7 2/9 8 2/";
    String rings = "1 2 3 1/2 3 4 1/3 4 2 1/4 5 6 1/5 6 7 1/6 7 5 1/";
    assertThat(words(read(nodes + "6 1/" + rings + "1/1 4.7 1.1/", AS_REGION)))
        .isEqualTo("[1, 2, 3] [4, 5, 6] of 9, fixed []");
    assertThat(words(read(nodes + "8 1/" + rings + "7 8 9 0/8 3 8 0/1/1 4.7 1.1/", AS_REGION)))
        .isEqualTo("[1, 2, 3] [4, 5, 6] of 9, fixed [7, 8, 2, 7]");
    assertThat(words(read(nodes + "8 1/" + rings + "7 3 8 0/8 8 4 0/1/1 4.7 1.1/", AS_REGION)))
        .as("branches, so that the marks tell")
        .isEqualTo("[1, 2, 3] [4, 5, 6] of 9, fixed [2, 7, 7, 3]");
    assertThat(words(read(nodes + "6 0/" + rings + "0/", AS_REGION)))
        .as("a ring without a hole's point is fixed")
        .isEqualTo("[1, 2, 3] of 9, fixed [4, 5, 5, 6, 6, 4]");
  }

  /** A hole from vertex 1 to an edge; the segments of both end at the vertex, or at one each. */
  @Test
  void trianglesRingsThatShareAVertexAreRefusedAndThoseWithOneEachAreParted() throws IOException {
    String segments = "7 1/1 1 2 1/2 2 3 1/3 3 1 1/4 %d 4 1/5 4 5 1/6 5 %d 1/7 3 6 0/1/1 3 2/";
    String nodes = " 2 0 0/1 0 0/2 9 0/3 9 9/4 5 3/5 6 5/6 8 1/";
    String shared = "6" + nodes + segments.formatted(1, 1);
    for (Touch touch : Touch.values()) {
      assertThat(fault(shared, touching(touch, 0)))
          .isEqualTo(
              "in:2: 4 segments of rings end at this vertex, where rings touch; list it once for"
                  + " each ring, and give --touching split or --touching hair");
    }
    String apart = "7" + nodes + "7 0 0/" + segments.formatted(7, 7);
    assertThat(fault(apart, AS_REGION)).contains("give --touching hair, since");
    PointDocument parted = read(apart, touching(Touch.PARTED, 0));
    assertThat(words(parted)).isEqualTo("[0, 1, 2] [3, 6, 4] of 7, fixed [2, 5]");
    assertThat(parted.instance(Progress.NONE).size()).isEqualTo(7);
  }

  @Test
  void theOwnTextTellsThatItIsARegion() throws IOException {
    String text = "# kind: region/0 0/9 0/9 9/sites/7 1/8 2/fixed 3 4/fixed 0,3/";
    assertThat(words(read(text, Choice.NONE))).isEqualTo("[0, 1, 2] of 5, fixed [3, 4, 0, 3]");
    assertThat(read(text, Choice.NONE).isOwn()).isTrue();
    for (String told : List.of("# kind: region/0 0/9 0/9 9/", "0 0/9 0/9 9/fixed 0 1/")) {
      assertThat(words(read(told, Choice.NONE))).isEqualTo("[0, 1, 2] of 3, fixed []");
    }
    assertThat(read(text, Choice.NONE.as(Domain.SITES)).points().size()).isEqualTo(5);
  }

  @Test
  void repeatedVerticesAreLeftOutAndSaidAndFixedEdgesFollow() throws IOException {
    PointDocument read =
        read(
            "0 0/0 0/9 0/9 9/0 0/hole/4 1/5 1/5 2/4 1/sites/7 1/fixed 3 9/fixed 4 9/fixed 1 9",
            Choice.NONE);
    assertThat(words(read)).isEqualTo("[0, 1, 2] [3, 4, 5] of 7, fixed [2, 6, 0, 6]");
    assertThat(read.notes())
        .containsExactly(
            "The last vertices of 2 rings repeat the first and are left out",
            "1 vertex repeats the one before it and is left out");
    assertThat(read.line(6)).isEqualTo(12);
  }

  @Test
  void theRingThatHoldsTheOthersIsTheOuterOne() throws IOException {
    PointDocument read = read("4 1/5 1/5 2/hole/0 0/9 0/9 9/", Choice.NONE);
    assertThat(words(read)).isEqualTo("[3, 4, 5] [0, 1, 2] of 6, fixed []");
    assertThat(read.notes())
        .containsExactly("The ring at line 5 holds the others and is taken for the outer one");
  }

  @Test
  void ofSeveralPolygonsOneIsPicked() throws IOException {
    String text =
        "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 0), (4 1, 5 1, 5 2, 4 1)), ((0 20, 9 20, 9 29, 0 20)))";
    assertThat(words(read(text, AS_REGION.picking(1))))
        .isEqualTo("[0, 1, 2] [3, 4, 5] of 6, fixed []");
    assertThat(words(read(text, AS_REGION.picking(2)))).isEqualTo("[0, 1, 2] of 3, fixed []");
    assertThat(fault(text, AS_REGION)).isEqualTo("in: WKT with 2 shapes; choose one by --pick N");
    assertThat(fault(text, AS_REGION.picking(3)))
        .isEqualTo("in: there are only 2 regions, none with the number 3; pick one from 1 to 2");
    assertThat(fault(text, Choice.NONE))
        .isEqualTo(
            "in: WKT with 3 shapes; choose one by --pick N, read rings with their holes by"
                + " --as region, or read all as sites by --as points");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "0 0/9 0/9 9/hole/4 1/5 1/5 -2 | in:",
        "0 0/9 0/9 9/hole/4 0/5 1/5 2 | in:5: vertex v3 touches edge v0–v1 at (4, 0); move it off",
        "0 0/9 0/9 9/sites/20 20 | in:5: site v3 lies outside of the region, (20, 20)",
        "0 0/9 0/9 9/hole/20 20/21 20/21 21 | in:7: vertex v5 of a hole lies outside",
        "0 0/9 0/9 9/hole/4 1/5 1 | in:5: the hole at vertex v3 has fewer than three vertices",
        "0 0/9 0/9 9/sites/4 1/4 1 | in:6: vertices v3 and v4 are both at (4, 1); remove one",
        "0 0/9 0/9 9/fixed 0 3 | in:4: there is no vertex v3; number them from 0 to 2",
        "0 0/9 0/9 9/fixed 2 2 | in:4: the edge joins v2 with itself; name two vertices",
        "0 0/9 0/9 9/0 9/4 1/fixed 0 | in:6: \"fixed\" stands without the numbers of two vertices",
        "# kind: region/sites/4 1 | in: it holds no rings that are apart, as a region has them",
      })
  void faultsAreNamedWithTheirPlace(String text, String sentence) {
    String fault = fault(text, Choice.NONE);
    assertThat(fault).matches("in(:\\d+)?: .*; .*");
    assertThat(fault).startsWith(sentence);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "a hole that meets itself| (2 2, 4 3, 6 2, 6 4, 4 3, 2 4)"
            + "| , or give --touching hair, since the region hangs together there",
        "holes that meet| (2 2, 4 3, 2 4), (4 3, 6 2, 6 4)"
            + "| , or give --touching hair, since the region hangs together there",
        "a hole from side to side| (0 5, 5 4, 9 5, 5 6)"
            + "| , or give --touching split or --touching hair",
        "a hole along a side| (0 2, 2 2, 2 4, 0 4)| , or give --touching split or --touching hair",
        "a hole along a spike| (0 2, 0 9, 9 9, 9 7, 2 7)| , or give --touching split",
        "a hole on a hole| (2 2, 4 2, 3 4), (2 2, 3 4, 4 2)| ''",
        "a hole outside| (9 9, 10 9, 10 10)| ''",
      })
  void whatCanBeDoneAboutRingsThatTouchIsSaid(String name, String holes, String offer)
      throws IOException {
    String text = "POLYGON ((0 0, 9 0, 9 9, 0 9)," + holes + ")";
    assertThat(fault(text, AS_REGION)).as(name).endsWith(offer);
    assertThat(offer.isEmpty()).isNotEqualTo(fault(text, AS_REGION).contains("--touching"));
    for (String word : List.of("split", "hair")) {
      Touch touch = word.equals("split") ? Touch.SPLIT : Touch.PARTED;
      boolean isOffered = offer.contains("--touching " + word);
      Throwable refused =
          catchThrowable(() -> read(text, touching(touch, 1)).instance(Progress.NONE));
      assertThat(refused == null).as("%s %s", name, word).isEqualTo(isOffered);
    }
  }

  private static Choice touching(Touch touch, int pick) {
    OptionalInt number = pick == 0 ? OptionalInt.empty() : OptionalInt.of(pick);
    return new Choice(
        Optional.of(Domain.REGION), Domain.POLYGON, number, Columns.TOLD_BY_CONTENT, touch);
  }

  /** A hole from side to side, with a site and a fixed edge below it and a site above it. */
  @Test
  void aRegionFallsApartIntoRegionsToChooseFrom() throws IOException {
    String text = "0 0/9 0/9 9/0 9/hole/0 5/5 4/9 5/5 6/sites/2 1/2 8/fixed 8 5/";
    String json =
        "{\"kind\":\"region\",\"points\":[[0,0],[9,0],[9,9],[0,9],[0,5],[5,4],[9,5],[5,6],[2,1],"
            + "[2,8]],\"rings\":[[0,1,2,3],[4,5,6,7]],\"fixed\":[[8,5]]}";
    for (String file : List.of(text, json)) {
      assertThat(fault(file, touching(Touch.SPLIT, 0)))
          .contains(" with 2 shapes; choose one by --pick N");
      PointDocument below = read(file, touching(Touch.SPLIT, 1));
      assertThat(words(below)).isEqualTo("[0, 1, 4, 3, 2] of 6, fixed [5, 3]");
      assertThat(below.notes()).containsExactly("Rings touch, and the region is split into 2");
      PointDocument above = read(file, touching(Touch.SPLIT, 2));
      assertThat(above.instance(Progress.NONE).size()).isEqualTo(6);
      PointDocument parted = read(file, touching(Touch.PARTED, 0));
      assertThat(words(parted)).isEqualTo("[0, 1, 2, 3] [4, 5, 6, 7] of 10, fixed [8, 5]");
      assertThat(parted.instance(Progress.NONE)).isInstanceOf(Instance.OfRegion.class);
      assertThat(parted.notes()).containsExactly("Vertices where rings meet are moved a hair");
    }
    assertThat(read(text, touching(Touch.SPLIT, 2)).line(2)).isEqualTo(6);
  }

  @Test
  void whatTouchesNothingStaysWhatItIs() throws IOException {
    String text = "# kind: region/0 0/9 0/9 9/hole/4 1/5 1/5 2/sites/7 1/fixed 4 6/";
    PointDocument plain = read(text, AS_REGION);
    for (Touch touch : List.of(Touch.SPLIT, Touch.PARTED)) {
      PointDocument same = read(text, touching(touch, 0));
      assertThat(same.rings()).isEqualTo(plain.rings());
      assertThat(same.notes()).isEmpty();
      assertThat(same.isOwn()).isTrue();
    }
  }

  @Test
  void polygonsOfJsonAreTakenApartAndParted() throws IOException {
    String json = "{\"points\":[[0,0],[8,0],[8,8],[4,0],[0,8]]}";
    Choice polygon =
        new Choice(
            Optional.empty(),
            Domain.POLYGON,
            OptionalInt.of(2),
            Columns.TOLD_BY_CONTENT,
            Touch.SPLIT);
    assertThat(read(json, polygon).points()).isEqualTo(Points.ofPairs(0, 0, 4, 0, 0, 8));
    Choice hair =
        new Choice(
            Optional.empty(),
            Domain.POLYGON,
            OptionalInt.empty(),
            Columns.TOLD_BY_CONTENT,
            Touch.PARTED);
    assertThat(read(json, hair).instance(Progress.NONE).size()).isEqualTo(5);
  }

  // ---- writing

  private static PointDocument written(Rings rings, FileEnding ending) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    if (ending == FileEnding.TXT) {
      RegionText.write(out, rings, Progress.NONE);
    } else {
      DataFile.write(out, ending, Drawing.of("", rings), Progress.NONE);
    }
    return PointFile.read("in", new ByteArrayInputStream(out.toByteArray()), AS_REGION);
  }

  @Test
  void whatIsWrittenIsReadBack() throws IOException {
    int withSites = 0;
    for (int seed = 0; seed < 60; seed++) {
      RandomSets.Family family = RandomSets.families().get(seed % RandomSets.families().size());
      Region region = RandomRegions.region(family, 5 + seed, seed % 4, 2 * (seed % 5), seed);
      Rings rings = region.rings();
      boolean ringsAlone = rings.fixedCount() == 0 && region.sites() == 0;
      withSites += region.sites();
      assertSame(region, written(rings, FileEnding.TXT), "text", seed);
      assertSame(region, written(rings, FileEnding.POLY), ".poly", seed);
      for (FileEnding ending : List.of(FileEnding.WKT, FileEnding.GEOJSON)) {
        if (ringsAlone) {
          assertSame(region, written(rings, ending), ending.dotted(), seed);
        } else {
          assertThat(catchThrowableOfType(CannotHold.class, () -> written(rings, ending)))
              .hasMessageEndingWith(" inside a region; choose .txt, .json or .poly");
        }
      }
    }
    assertThat(withSites).isPositive();
  }

  /** Vertices may have other numbers: compares places. */
  private static void assertSame(Region region, PointDocument read, String format, int seed) {
    Region back = ((Instance.OfRegion) read.instance(Progress.NONE)).region();
    assertThat(sides(back)).as("%s, seed %d", format, seed).isEqualTo(sides(region));
    assertThat(back.size()).isEqualTo(region.size());
  }

  private static Set<String> sides(Region region) {
    Set<String> sides = new HashSet<>();
    for (int p = 0; p < region.positions(); p++) {
      sides.add(side(region.points(), region.vertex(p), region.vertex(region.after(p))));
    }
    Rings rings = region.rings();
    for (int j = 0; j < rings.fixedCount(); j++) {
      boolean isUp = region.points().yxLess(rings.fixedFrom(j), rings.fixedTo(j));
      int low = isUp ? rings.fixedFrom(j) : rings.fixedTo(j);
      int high = isUp ? rings.fixedTo(j) : rings.fixedFrom(j);
      sides.add("fixed " + side(region.points(), low, high));
    }
    return sides;
  }

  private static String side(Points points, int u, int v) {
    return points.x(u) + " " + points.y(u) + " " + points.x(v) + " " + points.y(v);
  }

  @Test
  void aResultIsAnInputAndKeepsItsTriangulation() throws IOException {
    PointDocument plate =
        read("0 0/9 0/9 9/0 9/hole/4 4/5 4/5 5/sites/2 1/3 1/fixed 7 8/", Choice.NONE);
    Solution made =
        Solution.of(plate.instance(Progress.NONE), Method.MONOTONE, Progress.NONE)
            .flipped(Progress.NONE);
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ResultJson.write(out, made, Optional.empty());
    String json = out.toString(StandardCharsets.UTF_8);
    assertThat(json)
        .contains("\"kind\": \"region\"", "\"boundary\": 7, \"ringSizes\": [4, 3]")
        .contains("\"rings\": [\n[0, 1, 2, 3],\n[4, 6, 5]], \"fixed\": [\n[7, 8]]")
        .contains("[7, 8, \"fixed\"]");
    PointDocument back =
        PointFile.read("in", new ByteArrayInputStream(out.toByteArray()), Choice.NONE);
    assertThat(words(back)).isEqualTo("[0, 1, 2, 3] [4, 6, 5] of 9, fixed [7, 8]");
    Solution restored = back.solution(Progress.NONE).orElseThrow();
    assertThat(Comparison.of(restored.triangulation(), made.triangulation()).isSame()).isTrue();
    assertThat(restored.triangulation().count(EdgeKind.FIXED)).isEqualTo(1);
    assertThat(back.verified(Progress.NONE)).isPresent();
  }

  @Test
  void theTrianglesOfAMeshWithAHoleAreKept() throws IOException {
    String frame = "OFF/6 6 0/2 2 0/4 2 0/2 4 0/0 0 0/9 0 0/0 9 0/";
    String text = frame + "3 3 4 1/3 3 1 0/3 4 5 2/3 4 2 1/3 5 3 0/3 5 0 2/";
    PointDocument read = read(text, AS_REGION);
    assertThat(words(read)).isEqualTo("[3, 4, 5] [0, 1, 2] of 6, fixed []");
    Solution solution = read.solution(Progress.NONE).orElseThrow();
    assertThat(solution.triangulation().triangleCount()).isEqualTo(6);
    String open = frame.replace("6 6 0", "6 5 0") + "3 3 4 1/3 3 1 0/3 4 5 2/3 4 2 1/3 5 3 0/";
    assertThat(fault(open, AS_REGION)).contains("no rings that are apart");
  }
}
