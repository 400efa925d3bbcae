package dct.ui;

import dct.core.Decimals;
import dct.core.triangulate.Domain;
import dct.render.Labels;
import dct.render.Viewport;
import dct.ui.canvas.CanvasPanel;
import dct.ui.canvas.InSight;
import dct.ui.canvas.Links;
import dct.ui.canvas.ToolMouse;
import dct.ui.command.CommandMenu;
import dct.ui.command.CommandRegistry;
import dct.ui.dialog.Failures;
import dct.ui.dialog.Placement;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.Editor;
import dct.ui.edit.CopyAsCommands;
import dct.ui.edit.CrossingWork;
import dct.ui.edit.EditCommands;
import dct.ui.edit.ModeCommands;
import dct.ui.edit.SelectionCommands;
import dct.ui.edit.SnapCommands;
import dct.ui.edit.WishWork;
import dct.ui.explain.BoundNote;
import dct.ui.explain.Explainer;
import dct.ui.file.ChangedFiles;
import dct.ui.file.Closing;
import dct.ui.file.FileCommands;
import dct.ui.file.FileDrop;
import dct.ui.file.FileWork;
import dct.ui.file.PictureCopy;
import dct.ui.file.WindowHost;
import dct.ui.flip.FlipCommands;
import dct.ui.flip.FlipDesk;
import dct.ui.help.CheckWork;
import dct.ui.help.HelpCommands;
import dct.ui.icon.ProgramIcon;
import dct.ui.job.Jobs;
import dct.ui.menu.CommandWindow;
import dct.ui.menu.MenuTable;
import dct.ui.menu.ToolBar;
import dct.ui.menu.ViewCommands;
import dct.ui.random.RandomCommands;
import dct.ui.result.Arrangement;
import dct.ui.result.ResultView;
import dct.ui.result.ViewArea;
import dct.ui.session.Journal;
import dct.ui.session.Journals;
import dct.ui.session.Orphan;
import dct.ui.session.Session;
import dct.ui.session.Settings;
import dct.ui.shell.CallCopy;
import dct.ui.solve.FlipListWork;
import dct.ui.solve.LiveCommands;
import dct.ui.solve.PieceWork;
import dct.ui.solve.ResultFrames;
import dct.ui.solve.ResultViewCommands;
import dct.ui.solve.ResultWork;
import dct.ui.solve.SearchOptions;
import dct.ui.solve.TriangulateCommands;
import dct.ui.study.StudyWork;
import dct.ui.tool.Key;
import dct.ui.tool.Snap;
import dct.ui.tool.Spot;
import dct.ui.tool.Tool;
import dct.ui.workbench.Workbench;
import java.awt.BorderLayout;
import java.awt.Cursor;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;

/** The thesis's window: menu bar, canvas, east panel; and a status line. */
public final class MainWindow extends JFrame implements CommandWindow {
  private static final long serialVersionUID = 1L;
  private static final String PROGRAM = "Degree Constrained Triangulation";

  private final CanvasPanel canvas = new CanvasPanel();
  private final transient Workbench workbench;
  private final StatusBar status;
  private final EastPanel east;
  private final Invitation invitation;
  private final ToolBar tools;
  private final transient CommandRegistry commands = new CommandRegistry();
  private final transient FileWork files;
  private final transient Links links = new Links();
  private final transient InSight inSight = new InSight(canvas, links);
  private final ViewArea area = new ViewArea(canvas, inSight::setShared);
  private final transient ResultFrames results;
  private final transient ResultViewCommands resultViews;
  private final transient StudyWork studies;
  private final transient FlipCommands flips;
  private final transient Explainer explainer;
  private final transient BoundNote bound;
  private final transient StepViews steps = new StepViews(canvas);
  private final transient Map<Editor, Left> views = new HashMap<>(); // of what is not shown
  private final transient Session session;
  private final transient List<Journal> journals;
  private final transient CrossingWork crossings;
  private final transient Closing closing;
  private final transient ChangedFiles changed;
  private final transient WindowForFile forFile;
  private transient Editor last; // what was shown before

  /** A window that is not visible yet, with no application chosen. */
  MainWindow(Session session, WindowHost host) {
    super(PROGRAM);
    this.session = session;
    setName("main");
    workbench = new Workbench(canvas::viewport, this::say);
    status = new StatusBar(workbench.jobs());
    links.addDrawing(canvas);
    files = new FileWork(this, workbench, session.recent(), this::showOpened);
    results = new ResultFrames(workbench, this, canvas, links, area, files);
    resultViews = new ResultViewCommands(this, commands, workbench, canvas, results, links);
    crossings = new CrossingWork(workbench, canvas, this::refit);
    closing = new Closing(this, workbench, files, host, this::closeForGood);
    forFile = new WindowForFile(() -> isIdleAndEmpty() && !host.isLast(this), this::closeForGood);
    changed = new ChangedFiles(this, workbench, files::save, session.lane());
    journals = Stream.of(Domain.values()).map(this::journal).toList();
    studies = new StudyWork(this, canvas, links, results::open);
    explainer = new Explainer(canvas, workbench.jobs(), workbench::solution);
    bound = new BoundNote(canvas, workbench.jobs(), workbench::showsBound, workbench::inCanvas);
    offerCommands(host);
    flips = offerFlips();
    inSight.shareWith(flips.panel());
    commands.bindKeys(getRootPane());
    area.whenInFront(view -> commands.setFront(view.map(ResultView::commands)));
    east = new EastPanel(workbench, commands);
    invitation = new Invitation(commands, files::openSample);
    canvas.setInvitation(invitation);
    tools = new ToolBar(MenuTable.TOOLS, commands);
    commands.refresh();
    setJMenuBar(CommandMenu.bar(MenuTable.MAIN, commands));
    setIconImages(ProgramIcon.images());
    layOut();
    listen(host);
    restoreView();
    refresh();
  }

  private Journal journal(Domain domain) {
    Journals journals = session.journals();
    return journals.of(
        workbench.editor(domain), e -> SwingUtilities.invokeLater(() -> say(journals.sentence(e))));
  }

  private void offerCommands(WindowHost host) {
    ModeCommands.offer(commands, workbench);
    EditCommands.offer(commands, workbench);
    SelectionCommands.offer(commands, workbench);
    CopyAsCommands.offer(commands, workbench, canvas);
    PictureCopy.offer(commands, canvas, workbench.jobs(), workbench::say);
    SnapCommands.offer(commands, this, workbench.snap(), session.settings());
    crossings.offer(commands);
    FileCommands.offer(commands, files, canvas, session.recent());
    commands.add("New Window", "ctrl shift N", "Opens another, empty window", host::openEmpty);
    commands.add("Close Window", "ctrl W", "Closes this window", this::close);
    commands.add("Exit", "ctrl Q", "Closes the application", () -> host.exit(this));
    CallCopy calls = new CallCopy(this, workbench);
    SearchOptions searches = new SearchOptions(calls::copySearch);
    TriangulateCommands.offer(
        commands,
        workbench,
        new ResultWork(workbench, results::showLate, searches::limits),
        new WishWork(this, workbench, files::folder));
    searches.offer(commands, this);
    PieceWork.offer(commands, workbench, results::show);
    RandomCommands.offer(commands, this, workbench, calls, this::refit);
    studies.offer(commands);
    ViewCommands.offer(commands, canvas);
    commands
        .add("Tool Bar", "", "Shows or hides the icons below the menus", this::toggleTools)
        .selectedWhen(() -> tools == null || tools.isVisible());
    LiveCommands.offer(commands, workbench, session.settings());
    resultViews.offer();
    explainer.offer(commands);
    CheckWork checks = new CheckWork(this, workbench, crossings::goTo);
    HelpCommands.offer(commands, this, workbench, checks, calls);
    status.offer(commands);
    commands.add(
        "Give Up",
        "ESCAPE",
        "Closes a menu, puts a dragged vertex back, stops what goes on, or leaves the drawing",
        this::giveUp);
  }

  private FlipCommands offerFlips() {
    FlipDesk desk = workbench.flips();
    FlipListWork lists = new FlipListWork(this, desk, workbench.jobs(), files::folder);
    return FlipCommands.offer(
        commands, desk, lists, canvas, () -> workbench.isChosen(Domain.SITES));
  }

  private void layOut() {
    add(tools, BorderLayout.NORTH);
    JPanel centre = new JPanel(new BorderLayout());
    centre.add(changed.bar(), BorderLayout.NORTH);
    centre.add(area, BorderLayout.CENTER);
    JPanel below = new JPanel(new BorderLayout());
    below.add(flips.panel(), BorderLayout.CENTER);
    below.add(status, BorderLayout.SOUTH);
    centre.add(below, BorderLayout.SOUTH);
    add(centre, BorderLayout.CENTER);
    add(east, BorderLayout.EAST);
  }

  private void listen(WindowHost host) {
    setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
    addWindowListener(
        new WindowAdapter() {
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
            changed.look();
          }

          @Override
          public void windowClosed(WindowEvent e) {
            changed.end(); // however it was closed: the system has few watches
          }

          @Override
          public void windowDeactivated(WindowEvent e) {
            remember();
          }
        });
    new ToolMouse(canvas, workbench::tool, workbench, this::mouseAt);
    canvas.setDescription(() -> CanvasWords.of(workbench.active()));
    canvas.setAside(status::setAside);
    canvas.addViewListener(() -> status.setZoom(canvas.viewport().scale()));
    workbench.addListener(this::refresh);
    workbench.flips().addListener(this::refresh);
    workbench.addListener(results::refresh);
    workbench.addListener(explainer::refresh);
    workbench.addListener(resultViews::refresh);
    workbench.addListener(changed::refresh);
    workbench.jobs().setListener(new JobListener());
    setTransferHandler(new FileDrop(dropped -> open(dropped, host)));
  }

  private void toggleTools() {
    tools.setVisible(!tools.isVisible());
  }

  private void giveUp() {
    MenuSelectionManager menus = MenuSelectionManager.defaultManager();
    if (menus.getSelectedPath().length > 0) {
      menus.clearSelectedPath(); // the keys of the window come before those of an open menu
    } else {
      giveUpWork();
    }
  }

  private void giveUpWork() {
    boolean dragging = workbench.tool().map(tool -> tool.cancelled(workbench)).orElse(false);
    if (!dragging && workbench.jobs().isIdle()) {
      workbench.tool().ifPresent(tool -> tool.keyPressed(workbench, Key.ESCAPE));
    } else if (!dragging) {
      workbench.jobs().cancelCurrent();
    }
    canvas.repaint();
  }

  private void mouseAt(Spot spot) {
    canvas.setCorner("x " + Decimals.format(spot.x()) + "   y " + Decimals.format(spot.y()));
    showHint();
  }

  private void showHint() {
    String hint = crossings.hint().orElseGet(workbench::hint);
    status.setHint(hint, workbench.active().map(Editor::document).orElse(null));
  }

  /** Shows a message in the status line. */
  void say(String message) {
    status.say(message);
  }

  /** Shows the state of the workbench. */
  private void refresh() {
    flips.refresh();
    Editor editor = workbench.active().orElse(null);
    if (editor != last) {
      showOther(editor);
    } else if (editor != null) {
      canvas.setScene(workbench.flips().onTheWay().orElse(editor.shown().scene()));
    }
    workbench.active().map(Editor::history).ifPresent(steps::follow);
    bound.refresh();
    boolean empty = editor == null || editor.visible().size() == 0;
    invitation.show(workbench.domain(), empty, workbench.isDrawing());
    canvas.setGrid(workbench.snap().isOn(Snap.To.GRID) ? workbench.snap().grid() : 0);
    status.setSnap(workbench.snap().words());
    canvas.setCursor(workbench.tool().map(Tool::cursor).orElse(Cursor.getDefaultCursor()));
    commands.refresh();
    east.refresh();
    showHint();
    setTitle(title());
  }

  /** How an application was left: what part was shown, and whether that was all of it. */
  private record Left(Viewport viewport, boolean isAllInSight) {}

  /** Shows the other application where it was left. */
  private void showOther(Editor editor) {
    if (last != null) {
      views.put(last, new Left(canvas.viewport(), canvas.isAllInSight()));
    }
    last = editor;
    canvas.setScene(editor.shown().scene());
    Left view = views.get(editor);
    if (view != null) {
      canvas.setViewport(view.viewport);
      if (view.isAllInSight && !canvas.isAllInSight()) {
        canvas.fit(); // the canvas has become smaller meanwhile
      }
    } else if (editor.document().size() > 0) {
      canvas.showWell();
    } else {
      canvas.showActualSize();
    }
  }

  private String title() {
    return workbench
        .active()
        .map(e -> (e.history().isUnsaved() ? "*" : "") + e.name() + " – " + PROGRAM)
        .orElse(PROGRAM);
  }

  private void showOpened(boolean yUp) {
    if (yUp && !canvas.viewport().yUp()) {
      canvas.setViewport(canvas.viewport().flipped(0, 0));
    }
    workbench.active().ifPresent(editor -> canvas.setScene(editor.shown().scene()));
    refit();
  }

  /** Shows all of what a step has put on the canvas. */
  private void refit() {
    workbench.active().map(Editor::history).ifPresent(steps::refit);
  }

  /** Opens a file, as File ▸ Open does. */
  public void open(Path file) {
    files.open(file);
  }

  /** Opens a file, and closes this window if nothing comes of it and it is not the last. */
  void openOrClose(Path file) {
    forFile.begin();
    files.open(file);
  }

  private void open(List<Path> dropped, WindowHost host) {
    dropped.stream().findFirst().ifPresent(files::open);
    host.open(dropped.stream().skip(1).toList());
  }

  private boolean isIdleAndEmpty() {
    return workbench.jobs().isIdle() && isFree(Domain.POLYGON) && isFree(Domain.SITES);
  }

  /** Whether this application of the window has nothing in it that would have to give way. */
  boolean isFree(Domain domain) {
    Editor editor = workbench.editor(domain);
    return editor.document().size() == 0 && !editor.history().isUnsaved();
  }

  /** Shows a drawing that was not saved when the program was killed; it still is not. */
  void recover(Orphan orphan) {
    Document document = orphan.document();
    Document empty = Document.empty(document.domain());
    workbench.choose(document.domain());
    workbench.chooseEdit();
    Editor editor = workbench.editor(document.domain());
    editor.load(empty, orphan.name(), orphan.origin());
    editor.perform(new Edit.Replace("Recover Drawing", empty, document));
    showOpened(false);
    say("Recovered " + orphan.name() + ", which is not saved yet");
  }

  private void restoreView() {
    Settings settings = session.settings();
    canvas.setLabels(new Labels(settings.isOn("labels.numbers"), settings.isOn("labels.degrees")));
    workbench.setShowsBound(settings.isOn("view.bound"));
    results.arrange(Arrangement.of(settings.get("results.arrangement").orElse("")));
    results.setInWindow(settings.isOn("results.inWindow"));
    if (settings.isOn("view.yUp")) {
      canvas.setViewport(canvas.viewport().flipped(0, 0));
    }
  }

  /** Tells the settings how this window looks. */
  private void remember() {
    Settings settings = session.settings();
    settings.put("labels.numbers", canvas.labels().numbers());
    settings.put("labels.degrees", canvas.labels().degrees());
    settings.put("view.bound", workbench.showsBound());
    settings.put("results.arrangement", results.arrangement().word());
    settings.put("results.inWindow", results.isInWindow());
    settings.put("view.yUp", canvas.viewport().yUp());
    Placement.remember(this, settings);
  }

  /** Asks, and closes this window and its results, once what is being saved is in its file. */
  void exit() {
    closing.begin();
  }

  /** Whether closing would lose anything or end what goes on. */
  boolean hasSomethingToLose() {
    return closing.hasSomethingToLose();
  }

  /** Asks as before closing this window, and does something then, unless the answer is Cancel. */
  void agree(Runnable then) {
    closing.agree(then);
  }

  /** Closes this window and its results; asks nothing. */
  void closeForGood() {
    remember();
    journals.forEach(Journal::end);
    results.dispose();
    studies.dispose();
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

  private final class JobListener implements Jobs.Listener {
    @Override
    public void running(String what, double fraction) {
      status.running(what, fraction);
    }

    @Override
    public void idle() {
      status.idle();
      SwingUtilities.invokeLater(forFile::ended); // what was read is shown before
    }

    @Override
    public void listed() {
      status.listed();
      commands.refresh();
    }

    @Override
    public void failed(String what, Throwable cause) {
      // A dialog waits for its answer; the queue must not wait with it.
      Failures failures = new Failures(MainWindow.this, crossings.remedies());
      forFile.failed(() -> failures.show(what, cause));
    }
  }
}
