package dct.testing;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * A test of public data files that are not part of the project. Without the folder {@code
 * ../shared/data} it is left out, and one line after the last test says how many were.
 */
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
@Test
@ExtendWith(ForeignDataCondition.class)
public @interface ForeignDataTest {}
