/** Which menu and which tool bar hold which commands; how the window looks. */
package dct.ui.menu;
