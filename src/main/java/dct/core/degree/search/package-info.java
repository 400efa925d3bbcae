/** Searches that solve one small region after the other, for sites and for large polygons. */
package dct.core.degree.search;
