/** Long work off the event thread. */
package dct.ui.job;
