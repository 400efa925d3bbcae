/** Lists of points and rings as other programs write them. */
package dct.io.format.lists;
