/** Lower bounds on the number of unmet vertices, each with its proof. */
package dct.core.degree.bound;
