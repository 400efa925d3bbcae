/** Bytes and lines of text, and the sentences that say what is wrong with them. */
package dct.io.text;
