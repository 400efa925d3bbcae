/**
 * Exact optima of sites: a sweep over all triangulations of a few, and the refutation of all sets
 * of few odd vertices.
 */
package dct.core.degree.exact;
