/** What a file of any format gives: shapes, each a list of points, and what was left out. */
package dct.io.format;
