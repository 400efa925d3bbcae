package dct.ui;

import dct.core.Decimals;
import dct.core.triangulate.Domain;
import dct.ui.canvas.CanvasPanel;
import dct.ui.canvas.ToolMouse;
import dct.ui.command.CommandMenu;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Failures;
import dct.ui.dialog.Placement;
import dct.ui.document.Editor;
import dct.ui.file.FileCommands;
import dct.ui.file.WindowHost;
import dct.ui.help.CheckWork;
import dct.ui.help.HelpCommands;
import dct.ui.icon.ProgramIcon;
import dct.ui.job.Jobs;
import dct.ui.menu.CommandWindow;
import dct.ui.menu.MenuTable;
import dct.ui.menu.ToolBar;
import dct.ui.session.Orphan;
import dct.ui.session.Session;
import dct.ui.shell.CallCopy;
import dct.ui.tool.Spot;
import dct.ui.workbench.Workbench;
import java.awt.BorderLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;

/**
 * The thesis's window: menu bar, canvas, east panel; and a status line. It puts its parts together
 * and knows what each of them is for: drawing, files and results.
 */
public final class MainWindow extends JFrame implements CommandWindow {
  private static final long serialVersionUID = 1L;
  private static final String PROGRAM = "Degree Constrained Triangulation";

  private final CanvasPanel canvas = new CanvasPanel();
  private final transient CommandRegistry commands = new CommandRegistry();
  private final transient Workbench workbench;
  private final transient WindowDrawing drawing;
  private final transient WindowFiles files;
  private final transient WindowResults results;
  private final transient WindowMemory memory;
  private final StatusBar status;
  private final EastPanel east;
  private final ToolBar tools;

  /** A window that is not visible yet, with no application chosen. */
  MainWindow(Session session, WindowHost host) {
    super(PROGRAM);
    setName("main");
    workbench = new Workbench(canvas::viewport, this::say);
    status = new StatusBar(workbench.jobs());
    drawing = new WindowDrawing(this, workbench, canvas);
    files = new WindowFiles(this, workbench, session, host, drawing, this::closeForGood);
    results = new WindowResults(this, workbench, canvas, files.work());
    memory = new WindowMemory(this, workbench, canvas, results.frames(), session.settings());
    offerCommands(session, host);
    commands.bindKeys(getRootPane());
    east = new EastPanel(workbench, commands);
    drawing.invite(new Invitation(commands, files.work()::openSample));
    tools = new ToolBar(MenuTable.TOOLS, commands);
    offerToolBar();
    commands.refresh();
    setJMenuBar(CommandMenu.bar(MenuTable.MAIN, commands));
    setIconImages(ProgramIcon.images());
    layOut();
    listen();
    memory.restore();
    refresh();
  }

  private void offerCommands(Session session, WindowHost host) {
    CallCopy calls = new CallCopy(this, workbench);
    drawing.offer(commands, calls, session.settings());
    FileCommands.offer(commands, files.work(), canvas, session.recent());
    commands.add("New Window", "ctrl shift N", "Opens another, empty window", host::openEmpty);
    commands.add("Close Window", "ctrl W", "Closes this window", this::close);
    commands.add("Exit", "ctrl Q", "Closes the application", () -> host.exit(this));
    results.offer(commands, calls, session.settings());
    CheckWork checks = new CheckWork(this, workbench, drawing.crossings()::goTo);
    HelpCommands.offer(commands, this, workbench, checks, calls);
    status.offer(commands);
    commands.add(
        "Give Up",
        "ESCAPE",
        "Closes a menu, puts a dragged vertex back, stops what goes on, or leaves the drawing",
        drawing::giveUp);
  }

  private void offerToolBar() {
    commands
        .add(
            "Tool Bar",
            "",
            "Shows or hides the icons below the menus",
            () -> tools.setVisible(!tools.isVisible()))
        .selectedWhen(tools::isVisible);
  }

  private void layOut() {
    add(tools, BorderLayout.NORTH);
    JPanel centre = new JPanel(new BorderLayout());
    centre.add(files.changed().bar(), BorderLayout.NORTH);
    centre.add(results.area(), BorderLayout.CENTER);
    JPanel below = new JPanel(new BorderLayout());
    below.add(results.flipPanel(), BorderLayout.CENTER);
    below.add(status, BorderLayout.SOUTH);
    centre.add(below, BorderLayout.SOUTH);
    add(centre, BorderLayout.CENTER);
    add(east, BorderLayout.EAST);
  }

  private void listen() {
    setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
    addWindowListener(new WindowEvents());
    new ToolMouse(canvas, workbench::tool, workbench, this::mouseAt);
    canvas.setAside(status::setAside);
    canvas.addViewListener(() -> status.setZoom(canvas.viewport().scale()));
    workbench.addListener(this::refresh);
    workbench.flips().addListener(this::refresh);
    workbench.jobs().setListener(new JobListener());
  }

  private final class WindowEvents extends WindowAdapter {
    @Override
    public void windowOpened(WindowEvent e) {
      Placement.settle(MainWindow.this, canvas);
    }

    @Override
    public void windowClosing(WindowEvent e) {
      exit();
    }

    @Override
    public void windowActivated(WindowEvent e) {
      files.changed().look();
    }

    @Override
    public void windowClosed(WindowEvent e) {
      files.changed().end(); // however it was closed: the system has few watches
    }

    @Override
    public void windowDeactivated(WindowEvent e) {
      memory.remember();
    }
  }

  private final class JobListener implements Jobs.Listener {
    @Override
    public void running(String what, double fraction) {
      status.running(what, fraction);
    }

    @Override
    public void idle() {
      status.idle();
      SwingUtilities.invokeLater(files.forFile()::ended); // what was read is shown before
    }

    @Override
    public void listed() {
      status.listed();
      commands.refresh();
    }

    @Override
    public void failed(String what, Throwable cause) {
      // A dialog waits for its answer; the queue must not wait with it.
      Failures failures = new Failures(MainWindow.this, drawing.crossings().remedies());
      files.forFile().failed(() -> failures.show(what, cause));
    }
  }

  private void mouseAt(Spot spot) {
    canvas.setCorner("x " + Decimals.format(spot.x()) + "   y " + Decimals.format(spot.y()));
    showHint();
  }

  private void showHint() {
    status.setHint(drawing.hint(), workbench.active().map(Editor::document).orElse(null));
  }

  /** Shows a message in the status line. */
  void say(String message) {
    status.say(message);
  }

  /** Shows the state of the workbench. */
  private void refresh() {
    results.refresh();
    drawing.refresh();
    status.setSnap(workbench.snap().words());
    commands.refresh();
    east.refresh();
    showHint();
    setTitle(title());
    results.follow();
    files.changed().refresh();
  }

  private String title() {
    return workbench
        .active()
        .map(e -> (e.history().isUnsaved() ? "*" : "") + e.name() + " – " + PROGRAM)
        .orElse(PROGRAM);
  }

  /** Opens a file, as File ▸ Open does. */
  public void open(Path file) {
    files.work().open(file);
  }

  /** Opens a file, and closes this window if nothing comes of it and it is not the last. */
  void openOrClose(Path file) {
    files.openOrClose(file);
  }

  /** Whether this application of the window has nothing in it that would have to give way. */
  boolean isFree(Domain domain) {
    return files.isFree(domain);
  }

  /** Shows a drawing that was not saved when the program was killed; it still is not. */
  void recover(Orphan orphan) {
    files.recover(orphan);
  }

  /** Asks, and closes this window and its results, once what is being saved is in its file. */
  void exit() {
    files.closing().begin();
  }

  /** Whether closing would lose anything or end what goes on. */
  boolean hasSomethingToLose() {
    return files.closing().hasSomethingToLose();
  }

  /** Asks as before closing this window, and does something then, unless the answer is Cancel. */
  void agree(Runnable then) {
    files.closing().agree(then);
  }

  /** Closes this window and its results; asks nothing. */
  void closeForGood() {
    memory.remember();
    files.end();
    results.dispose();
    workbench.jobs().shutDown();
    dispose();
  }

  /** Closes the window as its close button does, which asks first. */
  private void close() {
    dispatchEvent(new WindowEvent(this, WindowEvent.WINDOW_CLOSING));
  }

  @Override
  public CommandRegistry commands() {
    return commands;
  }

  /** The canvas. */
  public CanvasPanel canvas() {
    return canvas;
  }

  /** The state of the window. */
  public Workbench workbench() {
    return workbench;
  }
}
