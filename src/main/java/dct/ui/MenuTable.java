package dct.ui;

import static dct.ui.command.CommandMenu.LINE;

import dct.ui.command.CommandMenu.Plan;
import java.util.List;

/** Which menu holds what. */
final class MenuTable {
  private static final Plan VIEW =
      Plan.of(
          "View",
          "Zoom In",
          "Zoom Out",
          "Fit",
          "Actual Size",
          LINE,
          "Vertex Numbers",
          "Vertex Degrees",
          "Y Axis Up",
          LINE,
          "Dark Look");

  /** The menus of the main window. */
  static final List<Plan> MAIN =
      List.of(
          Plan.of(
              "File", "New", "Open", "Open Sample", "Save", LINE, "Export Picture", LINE, "Exit"),
          Plan.of(
              "Edit",
              "Undo",
              "Redo",
              LINE,
              "Draw Vertex",
              "Delete Vertex",
              "Edit Vertex",
              "Split Vertex",
              "Wish Parity",
              LINE,
              "Clear Canvas"),
          Plan.of(
              "Triangulate",
              "Polygon Based",
              "Point Sites Based",
              LINE,
              "Convex Polygon Even Triangulation",
              "Convex Polygon Odd Triangulation",
              "Monotone Polygon Triangulation",
              "Ear Clipping Triangulation",
              "Delaunay",
              "None",
              LINE,
              "Perform Flip",
              "Most Even Vertices",
              "Most Odd Vertices",
              "Wished Parities…",
              LINE,
              "Random Sites",
              "Random Polygon…"),
          Plan.of("Study", "Point Sites…", "Polygons…"),
          VIEW,
          Plan.of("Help", "Commands and Keys", "About"));

  /** The menus of a frame that shows a result. */
  static final List<Plan> RESULT = List.of(Plan.of("File", "Export Picture", LINE, "Close"), VIEW);

  private MenuTable() {}
}
