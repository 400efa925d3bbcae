package dct.ui.menu;

import static dct.ui.command.CommandMenu.LINE;

import dct.ui.command.CommandMenu.Plan;
import java.util.List;
import java.util.stream.Stream;

/** Which menu holds what. */
public final class MenuTable {
  private static final Plan RESULT_FILE =
      Plan.of("File", "Save", "Save As", LINE, "Export Picture", "Export Data", LINE, "Close");
  private static final Plan PICTURE_FILE = Plan.of("File", "Export Picture", LINE, "Close");
  private static final String COPY_PICTURE = "Copy Picture";

  private static final List<String> LOOK =
      List.of(
          "Zoom In",
          "Zoom Out",
          "Fit",
          "Actual Size",
          LINE,
          "Vertex Numbers",
          "Vertex Degrees",
          "Legend",
          "Show Bound",
          "Y Axis Up",
          LINE,
          "Dark Look",
          LINE,
          "Results in This Window",
          "Arrange Views by Room",
          "Views Side by Side",
          "Views Stacked",
          "Views as Tabs",
          "Move View Left",
          "Move View Right",
          "Results to Front",
          LINE,
          "Link Views",
          LINE,
          "Compare Results…",
          "Table of Results");

  /** The tool bar of the main window. */
  public static final List<String> TOOLS =
      List.of(
          "New",
          "Open",
          "Save",
          LINE,
          "Undo",
          "Redo",
          LINE,
          "Perform Flip",
          "Most Even Vertices",
          "Most Odd Vertices",
          "Wish Parity",
          LINE,
          "Zoom In",
          "Zoom Out",
          "Fit",
          LINE,
          "Vertex Numbers",
          "Legend");

  private static final Plan VIEW = view("Drawing to Front", LINE, "Flips", LINE);

  private static final Plan REPLAY =
      Plan.of(
          "Replay",
          "First Flip",
          "Previous Flip",
          "Play Flips",
          "Next Flip",
          "Last Flip",
          LINE,
          "Go On from Here",
          LINE,
          "Save Flips…",
          "Load Flips…",
          "Copy Flips",
          "Apply Copied Flips");

  /** The menu View: first this, then what every canvas has. */
  private static Plan view(String... first) {
    return new Plan("View", Stream.concat(Stream.of(first), LOOK.stream()).toList());
  }

  /** The menus of the main window. */
  public static final List<Plan> MAIN =
      List.of(
          Plan.of(
              "File",
              "New",
              "New Window",
              "Open",
              "Open Recent",
              "Open Sample",
              "Save",
              "Save As",
              LINE,
              "Export Picture",
              "Export Data",
              LINE,
              "Close Window",
              "Exit"),
          Plan.of(
              "Edit",
              "Undo",
              "Redo",
              LINE,
              "Cut",
              "Copy",
              "Copy as WKT",
              "Copy as GeoJSON",
              "Copy for Ipe",
              COPY_PICTURE,
              "Paste",
              "Duplicate",
              "Delete Selection",
              "Select All",
              LINE,
              "Draw Vertex",
              "Delete Vertex",
              "Edit Vertex",
              "Split Vertex",
              "New Hole",
              "Inner Site",
              "Fix Edge",
              "Wish Parity",
              "Flip Edge",
              LINE,
              "Go to Crossing",
              "Untangle",
              "Split Ring…",
              "Part by a Hair",
              "Use as Sites",
              LINE,
              "Clear Canvas",
              LINE,
              "Copy as Command Line"),
          Plan.of(
              "Triangulate",
              "Polygon Based",
              "Point Sites Based",
              LINE,
              "Convex Polygon Even Triangulation",
              "Convex Polygon Odd Triangulation",
              "Monotone Polygon Triangulation",
              "Ear Clipping Triangulation",
              "Constrained Delaunay Triangulation",
              "Convex Partition",
              "Monotone Partition",
              "Delaunay",
              "None",
              LINE,
              "Perform Flip",
              "Most Even Vertices",
              "Most Odd Vertices",
              "Wished Parities…",
              "Prefer",
              "Search Options…",
              "Background Work",
              LINE,
              "Random Sites",
              "Random Polygon…",
              "Random Region…"),
          Plan.of("Study", "Point Sites…", "Polygons…", "Regions with Holes…"),
          view("Live Triangulation", "Live Method", LINE, "Flips", "Tool Bar", LINE),
          Plan.of(
              "Snap",
              "Snap to Vertices",
              "Snap to Edges",
              "Snap to Grid",
              "Snap to Angles",
              LINE,
              "Snap Settings…"),
          REPLAY,
          Plan.of(
              "Help",
              "Why?",
              "Verify Result",
              "Check Input",
              LINE,
              "Commands and Keys",
              "Find Command…",
              LINE,
              "About"));

  /** The menus of a frame that shows a result. */
  public static final List<Plan> RESULT =
      List.of(
          RESULT_FILE,
          Plan.of("Edit", "Undo", "Redo", LINE, COPY_PICTURE),
          VIEW,
          REPLAY,
          Plan.of("Help", "Why?", "Verify Result", LINE, "Commands and Keys", "Find Command…"));

  /** The menus of a frame that shows a picture. */
  public static final List<Plan> PICTURE =
      List.of(
          PICTURE_FILE,
          Plan.of("Edit", COPY_PICTURE),
          view("Drawing to Front", LINE),
          Plan.of("Help", "Commands and Keys", "Find Command…"));

  private MenuTable() {}
}
