/**
 * The commands that triangulate, flip, optimize and compare, and the frames that show what came
 * out.
 */
package dct.ui.solve;
