package dct.ui.result;

import java.util.List;
import java.util.Optional;

/** Where views are shown. */
public interface ViewHost {

  /**
   * Shows a view that is not shown here, and brings it to the front.
   *
   * @param beside a view to be compared with it, which stays in sight if there is any room
   */
  void show(ResultView view, Optional<ResultView> beside);

  /** Shows views that belong together, each so that it hides none of the others if it can. */
  void showAll(List<ResultView> views);

  /** Takes a view out of sight; it may come back, to the same place. */
  void hide(ResultView view);

  /** Takes a view away for good, or to another host. */
  void release(ResultView view);

  /** Whether the view is shown here, if not in front. */
  boolean isShown(ResultView view);

  /** Brings a view that is shown to the front and gives it the focus. */
  void toFront(ResultView view);
}
