/**
 * Degree constrained triangulation: triangulations of simple polygons and point sites with as many
 * vertices of even degree as possible. {@link dct.Main} starts the window or the command line;
 * docs/architecture.md explains the packages.
 */
package dct;
