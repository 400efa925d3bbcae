package dct.ui.flip;

import dct.ui.document.Editor;
import dct.ui.document.Result;
import java.util.Optional;

/** Where a view has its triangulation from, and where flips of it go to. */
public interface FlipSource {

  /** What the view shows, if its edges can be flipped. */
  Optional<Result> result();

  /** Why nothing can be flipped, and what to do, where there is no {@link #result}. */
  String refusal();

  /** Whose history the flips become steps of. */
  Editor editor();
}
