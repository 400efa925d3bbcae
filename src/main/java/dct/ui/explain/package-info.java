/** What is known of a result, explained and verified: dialogs beside a canvas, marks over it. */
package dct.ui.explain;
