/** The commands of the windows: each has a name, a key, a place in a menu and a tooltip. */
package dct.ui.command;
