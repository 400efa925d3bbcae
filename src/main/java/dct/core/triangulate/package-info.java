/**
 * Triangulations and partitions of polygons (thesis, Chapter 2) and the Delaunay triangulation of
 * sites. All of them return a {@link dct.core.triangulate.Triangulation} or a {@link
 * dct.core.triangulate.Partition}, keep every vertex, straight ones included, and decide by exact
 * predicates only.
 */
package dct.core.triangulate;
