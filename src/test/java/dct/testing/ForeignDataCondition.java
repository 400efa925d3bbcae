package dct.testing;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;

/** Leaves out the tests of foreign data where there is none, and counts them. */
final class ForeignDataCondition implements ExecutionCondition {

  /** The tests left out in one run; JUnit closes it after the last test. */
  private static final class LeftOut implements AutoCloseable {
    private final AtomicInteger count = new AtomicInteger();

    @Override
    public void close() {
      System.out.println(message(count.get()));
    }
  }

  static String message(int leftOut) {
    return leftOut + " tests of foreign data left out: there is no folder ../shared/data";
  }

  @Override
  public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
    if (context.getTestMethod().isEmpty() || SharedData.folder().isPresent()) {
      return ConditionEvaluationResult.enabled("");
    }
    context
        .getRoot()
        .getStore(Namespace.create(ForeignDataCondition.class))
        .getOrComputeIfAbsent(LeftOut.class, key -> new LeftOut(), LeftOut.class)
        .count
        .incrementAndGet();
    return ConditionEvaluationResult.disabled("no folder ../shared/data");
  }
}
