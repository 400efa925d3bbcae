/** Views of results, wherever they are shown, and what is said of results together. */
package dct.ui.result;
