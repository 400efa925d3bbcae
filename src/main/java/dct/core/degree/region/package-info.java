/**
 * One small region after the other solved exactly, for polygons and for sites: the mesh that a
 * search works on, the regions taken out of it, the tables that fill them, and the searches that
 * choose them.
 */
package dct.core.degree.region;
