package dct.ui.study;

import dct.experiment.study.StudyPicture;
import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** What the dialog of a study needs of the window that it belongs to. */
public interface StudyHost {

  /** Shows pictures of a trial, each in a frame of its own. */
  void show(Component over, String name, List<StudyPicture> pictures);

  /** Asks for a file to write to, and whether it may be replaced. */
  Optional<Path> askFile(Component over, String suggested);

  /** Says that something is wrong. */
  void sorry(Component over, String title, String sentence);

  /** Says why some work failed. */
  void failed(Component over, String what, Throwable cause);
}
