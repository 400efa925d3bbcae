/**
 * Reading and writing files: points as text or JSON, results as JSON, the names that files have.
 *
 * <p>Numbers are read and written with a point, whatever the locale. Files are written whole or not
 * at all.
 */
package dct.io;
