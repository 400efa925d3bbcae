/** Writes the tables and the picture of the documentation, and tests that they are so. */
package dct.docs;
