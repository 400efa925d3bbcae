/** The icons of the program, drawn by itself: of its windows and of its tool bar. */
package dct.ui.icon;
