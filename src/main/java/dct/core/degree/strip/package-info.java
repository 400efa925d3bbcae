/**
 * Strips of a triangulation solved anew: an axis is laid through it, two paths move away from the
 * axis over layers of triangles, and a beam search sweeps what lies between them.
 */
package dct.core.degree.strip;
