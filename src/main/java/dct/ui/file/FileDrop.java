package dct.ui.file;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.TransferHandler;

/** Opens the files that are dropped on a window. */
public final class FileDrop extends TransferHandler {
  private static final long serialVersionUID = 1L;

  private final transient Consumer<List<Path>> open;

  public FileDrop(Consumer<List<Path>> open) {
    this.open = open;
  }

  @Override
  public boolean canImport(TransferSupport support) {
    return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
  }

  /** Opens these files. */
  public void open(List<Path> files) {
    open.accept(files);
  }

  @Override
  public boolean importData(TransferSupport support) {
    try {
      Object data = support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
      List<Path> paths =
          data instanceof List<?> files
              ? files.stream().map(File.class::cast).map(File::toPath).toList()
              : List.of();
      open(paths);
      return !paths.isEmpty();
    } catch (UnsupportedFlavorException | IOException e) {
      return false; // nothing was dropped that could be opened
    }
  }
}
