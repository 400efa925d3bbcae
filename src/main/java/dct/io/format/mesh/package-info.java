/** Meshes of triangles, and the files of programs that make them. */
package dct.io.format.mesh;
