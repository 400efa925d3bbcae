/**
 * The best triangulation there is, for polygons and for sites: the order in which bounds, exact
 * methods and searches are tried, and the check of a claimed bound. It stands on the packages
 * {@code bound}, {@code exact}, {@code region} and {@code strip}, which do not know of each other's
 * use.
 */
package dct.core.degree.best;
