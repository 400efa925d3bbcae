/**
 * What outlives a run of the program: settings, recent files, and journals of drawings, from which
 * they come back if the program is killed. All of it lies in one folder of the user.
 */
package dct.ui.session;
