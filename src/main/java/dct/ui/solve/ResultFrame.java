package dct.ui.solve;

import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandMenu;
import dct.ui.command.CommandRegistry;
import dct.ui.icon.ProgramIcon;
import dct.ui.menu.CommandWindow;
import dct.ui.result.ResultView;
import java.awt.BorderLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import javax.swing.JFrame;

/** A frame that shows the view of one result. */
public final class ResultFrame extends JFrame implements CommandWindow {
  private static final long serialVersionUID = 1L;

  private final ResultView view;

  /** A frame that is not visible yet; the view's commands are in its menus. */
  ResultFrame(ResultView view) {
    super(view.title());
    this.view = view;
    setName("result");
    setIconImages(ProgramIcon.images());
    add(view, BorderLayout.CENTER);
    setJMenuBar(CommandMenu.bar(ResultCommands.menus(view), view.commands()));
    view.commands().bindKeys(getRootPane());
    view.addListener(() -> setTitle(view.title()));
    setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
    addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent e) {
            view.close();
          }
        });
  }

  /** What it shows. */
  public ResultView view() {
    return view;
  }

  @Override
  public CommandRegistry commands() {
    return view.commands();
  }

  /** The canvas. */
  public CanvasPanel canvas() {
    return view.canvas();
  }
}
