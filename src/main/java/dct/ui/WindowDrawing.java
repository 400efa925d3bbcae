package dct.ui;

import dct.render.Viewport;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import dct.ui.document.Editor;
import dct.ui.edit.CopyAsCommands;
import dct.ui.edit.CrossingWork;
import dct.ui.edit.EditCommands;
import dct.ui.edit.ModeCommands;
import dct.ui.edit.SelectionCommands;
import dct.ui.edit.SnapCommands;
import dct.ui.file.PictureCopy;
import dct.ui.menu.ViewCommands;
import dct.ui.random.RandomCommands;
import dct.ui.session.Settings;
import dct.ui.shell.CallCopy;
import dct.ui.tool.Key;
import dct.ui.tool.Snap;
import dct.ui.tool.Tool;
import dct.ui.workbench.Workbench;
import java.awt.Cursor;
import java.util.HashMap;
import java.util.Map;
import javax.swing.JFrame;
import javax.swing.MenuSelectionManager;

/**
 * The drawing of a window: shows on the canvas what the workbench holds, each application where it
 * was left, and offers what is done to it by hand.
 */
final class WindowDrawing {
  private final JFrame window;
  private final Workbench workbench;
  private final CanvasPanel canvas;
  private final CrossingWork crossings;
  private final StepViews steps;
  private final Map<Editor, Left> views = new HashMap<>(); // of what is not shown
  private Invitation invitation; // null until the window invites
  private Editor last; // what was shown before

  /** How an application was left: what part was shown, and whether that was all of it. */
  private record Left(Viewport viewport, boolean isAllInSight) {}

  /** The drawing of a window on its canvas. */
  WindowDrawing(JFrame window, Workbench workbench, CanvasPanel canvas) {
    this.window = window;
    this.workbench = workbench;
    this.canvas = canvas;
    steps = new StepViews(canvas);
    crossings = new CrossingWork(workbench, canvas, this::refit);
    canvas.setDescription(() -> CanvasWords.of(workbench.active()));
  }

  /** Says on the empty canvas what to do. */
  void invite(Invitation invites) {
    invitation = invites;
    canvas.setInvitation(invites);
  }

  /** Offers what is done to a drawing: by tools, to what is selected, by chance. */
  void offer(CommandRegistry commands, CallCopy calls, Settings settings) {
    ModeCommands.offer(commands, workbench);
    EditCommands.offer(commands, workbench);
    SelectionCommands.offer(commands, workbench);
    CopyAsCommands.offer(commands, workbench, canvas);
    PictureCopy.offer(commands, canvas, workbench.jobs(), workbench::say);
    SnapCommands.offer(commands, window, workbench.snap(), settings);
    crossings.offer(commands);
    RandomCommands.offer(commands, window, workbench, calls, this::refit);
    ViewCommands.offer(commands, canvas);
  }

  /** What is known of edges that cross. */
  CrossingWork crossings() {
    return crossings;
  }

  /** The hint for the tool that is chosen, or for what is wrong with the drawing. */
  String hint() {
    return crossings.hint().orElseGet(workbench::hint);
  }

  /** Shows the state of the workbench. */
  void refresh() {
    Editor editor = workbench.active().orElse(null);
    if (editor != last) {
      showOther(editor);
    } else if (editor != null) {
      canvas.setScene(workbench.flips().onTheWay().orElse(editor.shown().scene()));
    }
    workbench.active().map(Editor::history).ifPresent(steps::follow);
    boolean empty = editor == null || editor.visible().size() == 0;
    invitation.show(workbench.domain(), empty, workbench.isDrawing());
    canvas.setGrid(workbench.snap().isOn(Snap.To.GRID) ? workbench.snap().grid() : 0);
    canvas.setCursor(workbench.tool().map(Tool::cursor).orElse(Cursor.getDefaultCursor()));
  }

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

  /**
   * Shows all of a document that was opened.
   *
   * @param yUp whether y grows upwards in its file
   */
  void showOpened(boolean yUp) {
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

  /** Closes a menu, or else gives up what the mouse or a job does. */
  void giveUp() {
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
}
