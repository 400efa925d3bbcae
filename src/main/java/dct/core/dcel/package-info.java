/**
 * The topology of plane subdivisions, without coordinates: half-edges as ints in arrays, operators
 * that come in inverse pairs, and the check of their laws. docs/architecture.md has the pictures.
 */
package dct.core.dcel;
