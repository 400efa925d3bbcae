/** Commands and keys, the finder of commands, and the check of a result. */
package dct.ui.help;
