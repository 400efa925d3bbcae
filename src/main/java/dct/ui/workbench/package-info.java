/** What the parts of one window share: its two editors, the mode, what places snap to, the jobs. */
package dct.ui.workbench;
