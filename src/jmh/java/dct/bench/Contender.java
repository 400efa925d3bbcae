package dct.bench;

/**
 * Someone who makes triangles of points, each three vertex numbers in a row: from an array of
 * doubles to an array of indices, whatever lies between.
 *
 * @param name as the tables call it
 * @param maker what is timed
 */
record Contender(String name, Maker maker) {

  /** Makes the triangles; may fail with any exception, which is noted as its result. */
  @FunctionalInterface
  interface Maker {
    int[] triangles(double[] x, double[] y) throws Exception;
  }
}
