package dct.ui;

import dct.core.degree.ParityGoal;
import dct.core.triangulate.Domain;
import dct.problem.Method;
import dct.ui.command.Command;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.tool.Tool;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntFunction;

/** The commands of the main window that work on the documents. */
final class MainCommands {
  /** The methods that have a button, in the thesis's order. */
  private static final List<Method> BUTTONS =
      List.of(Method.CONVEX_EVEN, Method.CONVEX_ODD, Method.MONOTONE);

  private static final Map<Method, String> KEYS =
      Map.of(
          Method.CONVEX_EVEN, "shift E",
          Method.CONVEX_ODD, "shift O",
          Method.MONOTONE, "shift M",
          Method.EAR_CLIPPING, "shift C");

  private final Workbench workbench;
  private final PolygonResults polygons;
  private final SitesWork sites;
  private final List<Command> all = new ArrayList<>();
  private final Map<Domain, Command> applications = new EnumMap<>(Domain.class);
  private final Map<Tool, Command> tools = new LinkedHashMap<>();
  private final Map<Method, Command> methods = new EnumMap<>(Method.class);
  private final WishWork wishes;
  private final List<Command> goals = new ArrayList<>();
  private final Command undo;
  private final Command redo;
  private final Command clear;
  private final Command flip;
  private final Command random;
  private final Command randomPolygon;

  MainCommands(
      Workbench workbench,
      PolygonResults polygons,
      SitesWork sites,
      RandomPolygon randomPolygons,
      WishWork wishes) {
    this.workbench = workbench;
    this.polygons = polygons;
    this.sites = sites;
    this.wishes = wishes;
    undo = add("Undo", "ctrl Z", "Takes the last edit back", () -> onActive(Editor::undo));
    redo = add("Redo", "ctrl shift Z", "Does it again; also Ctrl+Y", () -> onActive(Editor::redo));
    clear = add("Clear Canvas", "ctrl DELETE", "Removes all vertices", this::clearCanvas);
    flip =
        add(
            "Perform Flip",
            "shift F",
            "Flips diagonals so that more vertices are even",
            this::flip);
    random = add("Random Sites", "shift R", "Puts n random sites on the canvas", sites::random);
    randomPolygon =
        add(
            "Random Polygon…",
            "ctrl R",
            "Puts a random polygon of a shape to choose on the canvas",
            randomPolygons::ask);
    addApplications();
    addTools();
    addMethods();
    addGoals();
    addConditions();
  }

  private void addApplications() {
    applications.put(
        Domain.POLYGON,
        add(
            "Polygon Based",
            "ctrl 1",
            "Draw a polygon and triangulate it",
            () -> workbench.choose(Domain.POLYGON)));
    applications.put(
        Domain.SITES,
        add(
            "Point Sites Based",
            "ctrl 2",
            "Draw sites and see their Delaunay triangulation",
            () -> workbench.choose(Domain.SITES)));
  }

  private void addTools() {
    Map<String, String> descriptions =
        Map.of(
            "Draw Vertex", "A click adds a vertex",
            "Delete Vertex", "A click removes a vertex",
            "Edit Vertex", "A drag moves a vertex",
            "Split Vertex", "A click splits the closest edge by a new vertex",
            "Wish Parity", "A click changes the parity wished of a vertex: even, odd, any");
    for (Tool tool : workbench.tools()) {
      String key = KeyEvent.getKeyText(tool.key());
      tools.put(
          tool,
          add(tool.name(), key, descriptions.get(tool.name()), () -> workbench.choose(tool))
              .enabledWhen(() -> workbench.domain().isPresent()));
    }
  }

  private void addMethods() {
    for (Method method : Method.of(Domain.POLYGON)) {
      methods.put(
          method,
          add(
                  method.title(),
                  KEYS.get(method),
                  method.description(),
                  () -> polygons.triangulate(method))
              .enabledWhen(() -> isChosen(Domain.POLYGON)));
    }
  }

  private void addGoals() {
    for (MostVertices most : MostVertices.values()) {
      goals.add(
          add(
                  most.title(),
                  most.key(),
                  most.description(),
                  () -> optimize(most.title(), most::goal))
              .enabledWhen(() -> workbench.domain().isPresent()));
    }
    goals.add(
        add(
                "Wished Parities…",
                "ctrl shift W",
                "Finds the triangulation that grants the most wishes",
                () -> wishes.ask(this::optimize))
            .enabledWhen(() -> workbench.domain().isPresent()));
  }

  private void addConditions() {
    undo.enabledWhen(() -> workbench.active().flatMap(e -> e.history().undoLabel()).isPresent())
        .named(() -> "Undo" + label(workbench.active().flatMap(e -> e.history().undoLabel())));
    redo.enabledWhen(() -> workbench.active().flatMap(e -> e.history().redoLabel()).isPresent())
        .named(() -> "Redo" + label(workbench.active().flatMap(e -> e.history().redoLabel())));
    clear.enabledWhen(() -> workbench.domain().isPresent());
    flip.enabledWhen(() -> workbench.domain().isPresent());
    random.enabledWhen(() -> isChosen(Domain.SITES));
    randomPolygon.enabledWhen(() -> isChosen(Domain.POLYGON));
  }

  private static String label(java.util.Optional<String> edit) {
    return edit.map(name -> " " + name).orElse("");
  }

  private Command add(String name, String key, String description, Runnable run) {
    Command command = new Command(name, key, description, run);
    all.add(command);
    return command;
  }

  private boolean isChosen(Domain domain) {
    return workbench.domain().filter(domain::equals).isPresent();
  }

  private void onActive(java.util.function.Consumer<Editor> action) {
    workbench.active().ifPresent(action);
  }

  private void clearCanvas() {
    onActive(
        editor -> {
          if (editor.document().size() > 0) {
            editor.perform(
                Edit.replace(clear.name(), editor.document(), dct.core.geometry.Points.ofPairs()));
          }
          workbench.chooseDraw();
        });
  }

  private void flip() {
    if (isChosen(Domain.POLYGON)) {
      polygons.flip();
    } else {
      sites.flip();
    }
  }

  private void optimize(String what, IntFunction<ParityGoal> goal) {
    if (isChosen(Domain.POLYGON)) {
      polygons.optimize(what, goal);
    } else {
      sites.optimize(what, goal);
    }
  }

  /** The commands that find the best triangulation for a goal. */
  List<Command> goals() {
    return goals;
  }

  Map<Domain, Command> applications() {
    return applications;
  }

  Map<Tool, Command> tools() {
    return tools;
  }

  Command undo() {
    return undo;
  }

  Command redo() {
    return redo;
  }

  Command clear() {
    return clear;
  }

  Command randomPolygon() {
    return randomPolygon;
  }

  /** The buttons of each application, from top to bottom. */
  Map<Domain, List<Command>> buttons() {
    List<Command> ofPolygons = new ArrayList<>();
    ofPolygons.add(clear);
    BUTTONS.forEach(method -> ofPolygons.add(methods.get(method)));
    ofPolygons.add(flip);
    return Map.of(
        Domain.POLYGON, List.copyOf(ofPolygons), Domain.SITES, List.of(clear, flip, random));
  }

  /** The methods for polygons, those of the thesis's buttons first. */
  List<Command> methods() {
    Set<Command> ordered = new LinkedHashSet<>();
    BUTTONS.forEach(method -> ordered.add(methods.get(method)));
    ordered.addAll(methods.values());
    return List.copyOf(ordered);
  }

  /** Brings names and enablement up to date. */
  void refresh() {
    all.forEach(Command::refresh);
  }
}
