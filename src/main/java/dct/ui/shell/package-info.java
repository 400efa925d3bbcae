/** The calls of the command line that make what the window shows. */
package dct.ui.shell;
