/**
 * Checks what a result file claims against its own points and edges: {@link
 * dct.problem.verify.Claims} are what stands in the file, {@link dct.problem.verify.Verifier}
 * checks them and believes none, {@link dct.problem.verify.Restoration} makes a solution of them
 * again.
 */
package dct.problem.verify;
