/** The best triangulation there is, for polygons and for sites, and the check of its claim. */
package dct.core.degree.best;
