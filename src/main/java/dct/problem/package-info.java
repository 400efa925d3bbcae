/**
 * What the window, the command line and the studies share: an {@link dct.problem.Instance} is what
 * is to be triangulated, a {@link dct.problem.Method} a way to do it, a {@link
 * dct.problem.Solution} what came out and how. {@code dct.problem.verify} checks solutions that
 * were stored.
 *
 * <p>Stands on {@code dct.core} alone; files, pictures and windows stand on it.
 */
package dct.problem;
