package dct.ui.file;

import dct.core.triangulate.Domain;
import dct.io.FileEnding;
import dct.io.FileEnding.Content;
import dct.ui.canvas.CanvasPanel;
import dct.ui.command.CommandRegistry;
import dct.ui.session.RecentFiles;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JMenu;
import javax.swing.JMenuItem;

/** The commands that open, save and export. */
public final class FileCommands {

  private FileCommands() {}

  /** Offers the commands of a window. */
  public static void offer(
      CommandRegistry commands, FileWork files, CanvasPanel canvas, RecentFiles recent) {
    commands.add("New", "ctrl N", "Begins an empty document", files::startAnew);
    commands.add("Open", "ctrl O", "Opens a polygon or sites", files::open);
    commands.add(
        "Save", "ctrl S", "Saves to the file that was opened, or asks for one", files::save);
    commands.add(
        "Save As", "ctrl shift S", "Saves under a new name or replaces a file", files::saveAs);
    commands.add("Export Picture", "ctrl E", pictures(), () -> files.exportPicture(canvas));
    commands
        .add("Export Data", "", DataExport.description(), files::exportData)
        .enabledWhen(files::hasPoints);
    commands.addSubmenu("Open Sample", menu -> addSamples(menu, files));
    commands.addSubmenu("Open Recent", menu -> addRecent(menu, recent, files));
  }

  /** What Export Picture does. */
  public static String pictures() {
    return "Writes what is seen to a picture: " + FileEnding.list(Content.PICTURE);
  }

  private static void addSamples(JMenu menu, FileWork files) {
    for (Domain domain : Domain.applications()) {
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

  private static void addRecent(JMenu menu, RecentFiles recent, FileWork files) {
    for (Path file : recent.list()) {
      JMenuItem item = new JMenuItem(file.getFileName() + " – " + file.getParent());
      item.setName(file.toString());
      item.setEnabled(Files.isRegularFile(file));
      item.addActionListener(e -> files.open(file));
      menu.add(item);
    }
    JMenuItem clear = new JMenuItem("Clear");
    clear.setName("Clear Recent");
    clear.setEnabled(menu.getItemCount() > 0);
    clear.addActionListener(e -> recent.clear());
    menu.addSeparator();
    menu.add(clear);
  }
}
