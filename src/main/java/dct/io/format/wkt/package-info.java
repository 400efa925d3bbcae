/** Well-Known Text. */
package dct.io.format.wkt;
