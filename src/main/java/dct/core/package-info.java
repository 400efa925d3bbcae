/**
 * What all algorithms share: being told to stop and saying how far they are ({@link
 * dct.core.Progress}), and limits of time ({@link dct.core.Deadline}).
 *
 * <p>The packages below hold the algorithms. They use no Swing, read and write no files, print
 * nothing, and may be used from any thread; {@code degree} uses {@code triangulate}, that {@code
 * dcel}, that {@code geometry}.
 */
package dct.core;
