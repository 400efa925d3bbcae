/** The command line: the verbs of the window without a screen, and a checker of results. */
package dct.cli;
