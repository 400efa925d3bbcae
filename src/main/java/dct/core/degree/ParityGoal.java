package dct.core.degree;

import dct.core.triangulate.Triangulation;
import java.util.Arrays;
import java.util.Locale;

/**
 * The parity that is wished for each vertex' degree; immutable. All even is the thesis's problem,
 * all odd its counterpart; a vertex may also be left free.
 */
public final class ParityGoal {

  /** What is wished of one vertex. */
  public enum Wish {
    EVEN,
    ODD,
    ANY;

    /** Whether the wish of a vertex of this degree is granted. */
    public boolean isGrantedBy(int degree) {
      return this == ANY || (degree & 1) == (this == ODD ? 1 : 0);
    }

    /** What a degree costs: 1 if it misses the wish, or else 0. */
    public int penalty(int degree) {
      return isGrantedBy(degree) ? 0 : 1;
    }
  }

  private final Wish[] wishes; // by vertex

  private ParityGoal(Wish[] wishes) {
    this.wishes = wishes;
  }

  /** Every one of n vertices even. */
  public static ParityGoal allEven(int n) {
    return all(n, Wish.EVEN);
  }

  /** Every one of n vertices odd. */
  public static ParityGoal allOdd(int n) {
    return all(n, Wish.ODD);
  }

  private static ParityGoal all(int n, Wish wish) {
    Wish[] wishes = new Wish[n];
    Arrays.fill(wishes, wish);
    return new ParityGoal(wishes);
  }

  /** A wish for each vertex; the array is copied. */
  public static ParityGoal of(Wish... wishes) {
    return new ParityGoal(wishes.clone());
  }

  /** This goal with another wish for vertex v. */
  public ParityGoal with(int v, Wish wish) {
    Wish[] changed = wishes.clone();
    changed[v] = wish;
    return new ParityGoal(changed);
  }

  /** This goal with a wish for a new vertex v; those from there on move up by one. */
  public ParityGoal inserted(int v, Wish wish) {
    Wish[] longer = Arrays.copyOf(wishes, wishes.length + 1);
    System.arraycopy(wishes, v, longer, v + 1, wishes.length - v);
    longer[v] = wish;
    return new ParityGoal(longer);
  }

  /** This goal without vertex v; those behind it move down by one. */
  public ParityGoal removed(int v) {
    Wish[] shorter = Arrays.copyOf(wishes, wishes.length - 1);
    System.arraycopy(wishes, v + 1, shorter, v, shorter.length - v);
    return new ParityGoal(shorter);
  }

  /** The number of vertices. */
  public int size() {
    return wishes.length;
  }

  /** What is wished of vertex v. */
  public Wish wish(int v) {
    return wishes[v];
  }

  /** Whether the same is wished of every vertex. */
  public boolean isAll(Wish wish) {
    for (Wish w : wishes) {
      if (w != wish) {
        return false;
      }
    }
    return true;
  }

  /** How many vertices have this wish. */
  public int count(Wish wish) {
    int count = 0;
    for (Wish w : wishes) {
      count += w == wish ? 1 : 0;
    }
    return count;
  }

  /** Whether vertex v has the parity wished in this triangulation. */
  public boolean isGranted(Triangulation triangulation, int v) {
    return wishes[v].isGrantedBy(triangulation.degree(v));
  }

  /** How many vertices do not have the parity wished, in linear time. */
  public int unmet(Triangulation triangulation) {
    int unmet = 0;
    for (int v = 0; v < wishes.length; v++) {
      unmet += isGranted(triangulation, v) ? 0 : 1;
    }
    return unmet;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ParityGoal that && Arrays.equals(wishes, that.wishes);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(wishes);
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT, "%d even, %d odd, %d any", count(Wish.EVEN), count(Wish.ODD), count(Wish.ANY));
  }
}
