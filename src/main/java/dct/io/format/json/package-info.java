/** Formats that are written in JSON, other than the program's own. */
package dct.io.format.json;
