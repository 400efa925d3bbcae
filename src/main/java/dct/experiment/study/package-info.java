/** The studies: many seeded trials on all cores, kept in a file, and their tables and charts. */
package dct.experiment.study;
