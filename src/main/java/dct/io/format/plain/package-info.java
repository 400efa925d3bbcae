/** Text with a vertex a line: the program's own, and that of people and other programs. */
package dct.io.format.plain;
