/**
 * What is being edited: immutable {@link dct.ui.document.Document} states, named {@link
 * dct.ui.document.Edit}s between them, and an {@link dct.ui.document.Editor} with its history.
 */
package dct.ui.document;
