package dct.ui;

import dct.core.triangulate.Domain;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import javax.swing.JMenu;
import javax.swing.JMenuItem;

/** The commands that open, save and export. */
final class FileCommands {

  private FileCommands() {}

  /**
   * Offers the commands of a window.
   *
   * @param exit asks, and closes the window
   */
  static void offer(CommandRegistry commands, FileWork files, CanvasPanel canvas, Runnable exit) {
    commands.add("New", "ctrl N", "Begins an empty document", files::startAnew);
    commands.add("Open", "ctrl O", "Opens a polygon or sites", files::open);
    commands.add("Save", "ctrl S", "Saves under a new name or replaces a file", files::save);
    commands.add("Export Picture", "ctrl E", pictures(), () -> files.exportPicture(canvas));
    commands.add("Exit", "ctrl Q", "Closes the application", exit);
    commands.addSubmenu("Open Sample", menu -> addSamples(menu, files));
  }

  /** What Export Picture does. */
  static String pictures() {
    return "Writes what is seen to a picture: " + FileEnding.list(Content.PICTURE);
  }

  private static void addSamples(JMenu menu, FileWork files) {
    for (Domain domain : Domain.values()) {
      if (menu.getItemCount() > 0) {
        menu.addSeparator();
      }
      for (String name : Samples.names(domain)) {
        JMenuItem item = new JMenuItem(Samples.title(name));
        item.setName(name);
        item.addActionListener(e -> files.openSample(name));
        menu.add(item);
      }
    }
  }
}
