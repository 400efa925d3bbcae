/**
 * Triangulations of sites as empty triangles in two colours: the triangles, and the systems of rows
 * on the edges between them that have a solution just if some triangulation has given odd vertices.
 */
package dct.core.degree.colour;
