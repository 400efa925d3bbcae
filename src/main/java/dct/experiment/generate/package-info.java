/** Seeded generators of sites and simple polygons; the same everywhere for the same seed. */
package dct.experiment.generate;
