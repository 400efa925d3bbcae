package dct.ui;

import dct.core.triangulate.Domain;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.Command;
import dct.ui.command.CommandMenu;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;

/** The menu bar of the main window. */
final class MainMenu {
  private final JFrame window;
  private final CanvasPanel canvas;
  private final FileWork files;
  private final MainCommands commands;
  private final JMenuBar bar = new JMenuBar();
  private final List<CommandMenu> menus;

  MainMenu(
      JFrame window, CanvasPanel canvas, FileWork files, MainCommands commands, StudyWork studies) {
    this.window = window;
    this.canvas = canvas;
    this.files = files;
    this.commands = commands;
    menus = List.of(file(), edit(), triangulate(), studies.menu(), ViewMenu.of(canvas), help());
    menus.forEach(bar::add);
  }

  JMenuBar bar() {
    return bar;
  }

  /** Every command of every menu. */
  List<Command> commands() {
    return menus.stream().flatMap(menu -> menu.commands().stream()).toList();
  }

  private CommandMenu file() {
    return new CommandMenu("File")
        .with(command("New", "ctrl N", "Begins an empty document", files::startAnew))
        .with(command("Open", "ctrl O", "Opens a polygon or sites", files::open))
        .with(samples())
        .with(command("Save", "ctrl S", "Saves under a new name or replaces a file", files::save))
        .line()
        .with(
            command(
                "Export Picture",
                "ctrl E",
                "Writes what is seen to a picture: " + FileEnding.list(Content.PICTURE),
                () -> files.exportPicture(canvas)))
        .line()
        .with(command("Exit", "ctrl Q", "Closes the application", this::close));
  }

  /** Closes the window as its close button does, which asks first. */
  private void close() {
    window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING));
  }

  private static Command command(String name, String key, String description, Runnable run) {
    return new Command(name, key, description, run);
  }

  private JMenu samples() {
    JMenu menu = new JMenu("Open Sample");
    menu.setName("Open Sample");
    menu.setMnemonic('p');
    addSamples(menu, Domain.POLYGON);
    menu.addSeparator();
    addSamples(menu, Domain.SITES);
    return menu;
  }

  private void addSamples(JMenu menu, Domain domain) {
    for (String name : Samples.names(domain)) {
      JMenuItem item = new JMenuItem(Samples.title(name));
      item.setName(name);
      item.addActionListener(e -> files.openSample(name));
      menu.add(item);
    }
  }

  private CommandMenu edit() {
    CommandMenu menu = new CommandMenu("Edit").with(commands.undo()).with(commands.redo()).line();
    commands.tools().values().forEach(menu::with);
    return menu.line().with(commands.clear());
  }

  private CommandMenu triangulate() {
    CommandMenu menu = new CommandMenu("Triangulate");
    commands.applications().values().forEach(menu::with);
    Consumer<Command> add =
        command -> {
          if (!menu.commands().contains(command) && command != commands.clear()) {
            menu.with(command);
          }
        };
    menu.line();
    commands.methods().forEach(add);
    commands.buttons().get(Domain.POLYGON).forEach(add);
    commands.buttons().get(Domain.SITES).forEach(add);
    menu.with(commands.randomPolygon());
    menu.line();
    commands.goals().forEach(menu::with);
    return menu;
  }

  private CommandMenu help() {
    return new CommandMenu("Help")
        .with(
            command(
                "Commands and Keys",
                "F1",
                "Lists everything that can be done",
                () -> CommandList.show(window, commands())))
        .with(command("About", "", "Says what this program is", this::about));
  }

  private void about() {
    Ask.tell(
        window,
        "About",
        "Degree Constrained Triangulation: triangulations of polygons and point sites with as many"
            + " vertices of even degree as possible, after R. Gyawali's thesis of that name (UNLV,"
            + " 2012).");
  }
}
