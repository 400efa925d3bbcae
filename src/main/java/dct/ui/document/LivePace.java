package dct.ui.document;

import dct.core.Progress;

/**
 * How long live triangulations take: what fits into a frame of the screen is made at once, and the
 * rest in the background. The last one that was measured tells of the next.
 */
final class LivePace {
  private static final long FRAME_NANOS = 14_000_000;

  /** So many vertices are tried at once before anything was measured. */
  private static final int SMALL = 200;

  private volatile double nanos; // per square of the number of vertices; 0 before the first
  private volatile LiveMethod of;

  /** Whether a polygon of so many vertices is likely to be analysed within a frame. */
  boolean isQuick(Manner manner, int size) {
    return manner.live().isEmpty()
        || (manner.live().get().equals(of) ? nanos * size * size <= FRAME_NANOS : size <= SMALL);
  }

  /** An analysis; how long it takes is remembered. */
  Analysis measured(Document document, Manner manner, Progress progress) {
    long begin = System.nanoTime();
    Analysis made = Analysis.of(document, manner, progress);
    if (manner.live().isPresent() && made.solution().isPresent()) {
      double size = document.size();
      of = manner.live().get();
      nanos = (System.nanoTime() - begin) / (size * size);
    }
    return made;
  }
}
