/** Lower bounds on the number of unsatisfied vertices, each with its proof. */
package dct.core.degree.bound;
