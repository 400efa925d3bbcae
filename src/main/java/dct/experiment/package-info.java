/** Seeded generators and the studies that use them. */
package dct.experiment;
