package dct.experiment.study;

import java.util.ArrayList;
import java.util.List;

/**
 * What a study is made of: so many sets of each shape and size.
 *
 * @param shapes the words of the generators
 * @param sizes the numbers of vertices
 * @param sets how many of each shape and size
 * @param seed from which the seed of each trial follows; more sets, sizes and shapes leave the
 *     trials of a smaller plan as they are
 */
public record StudyPlan(List<String> shapes, List<Integer> sizes, int sets, long seed) {

  public StudyPlan {
    shapes = List.copyOf(shapes);
    sizes = List.copyOf(sizes);
  }

  /** The trials: set by set, so that a study that is cancelled has something of everything. */
  List<Trial> trials() {
    List<Trial> trials = new ArrayList<>();
    for (int set = 1; set <= sets; set++) {
      for (String shape : shapes) {
        for (int n : sizes) {
          trials.add(Trial.planned(shape, n, set, seed));
        }
      }
    }
    return trials;
  }
}
