/**
 * Points, simple polygons and sets of sites; exact predicates on them; the check whether a polygon
 * is simple.
 *
 * <p>Coordinates are any finite doubles. {@link dct.core.geometry.Predicates} decides exactly: a
 * floating-point filter first, exact arithmetic where it fails. There is no tolerance.
 */
package dct.core.geometry;
