package dct.ui.job;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class JobsTest {
  private final Jobs jobs = new Jobs();
  private final LinkedBlockingQueue<String> heard = new LinkedBlockingQueue<>();

  @BeforeEach
  void listen() {
    jobs.setListener(
        new Jobs.Listener() {
          @Override
          public void running(String what, double fraction) {
            heard.add("running " + what);
          }

          @Override
          public void idle() {
            heard.add("idle");
          }

          @Override
          public void failed(String what, Throwable cause) {
            heard.add("failed " + what + ": " + cause.getMessage());
          }
        });
  }

  @Test
  void workIsDoneOffTheEventThreadAndItsResultHandedOverOnIt() throws Exception {
    List<Boolean> onEventThread = new ArrayList<>();
    submit(() -> onEventThread.add(SwingUtilities.isEventDispatchThread()), onEventThread);
    awaitIdle();
    assertThat(onEventThread).containsExactly(false, true);
  }

  private void submit(Runnable work, List<Boolean> onEventThread) throws Exception {
    SwingUtilities.invokeAndWait(
        () ->
            jobs.submit(
                "work",
                progress -> {
                  work.run();
                  return 1;
                },
                result -> onEventThread.add(SwingUtilities.isEventDispatchThread())));
  }

  @Test
  void aCancelledJobHasNoEffect() throws Exception {
    CountDownLatch started = new CountDownLatch(1);
    List<Integer> results = new ArrayList<>();
    SwingUtilities.invokeAndWait(
        () ->
            jobs.submit(
                "endless",
                progress -> {
                  started.countDown();
                  while (true) {
                    progress.checkCancelled();
                    Thread.onSpinWait();
                  }
                },
                (Integer result) -> results.add(result)));
    assertThat(started.await(10, TimeUnit.SECONDS)).isTrue();
    SwingUtilities.invokeAndWait(jobs::cancelCurrent);
    awaitIdle();
    assertThat(results).isEmpty();
    assertThat(heard).noneMatch(line -> line.startsWith("failed"));
  }

  @Test
  void aSearchThatIsCancelledHandsOverTheBestThatItHas() throws Exception {
    CountDownLatch started = new CountDownLatch(1);
    LinkedBlockingQueue<String> results = new LinkedBlockingQueue<>();
    SwingUtilities.invokeAndWait(
        () ->
            jobs.submitSearch(
                "search",
                progress -> {
                  started.countDown();
                  while (!progress.isCancelled()) {
                    Thread.onSpinWait();
                  }
                  return "best so far";
                },
                results::add));
    assertThat(started.await(10, TimeUnit.SECONDS)).isTrue();
    SwingUtilities.invokeAndWait(jobs::cancelCurrent);
    awaitIdle();
    assertThat(results).containsExactly("best so far");
  }

  @Test
  void aFailureIsTold() throws Exception {
    SwingUtilities.invokeAndWait(
        () ->
            jobs.submit(
                "work",
                progress -> {
                  throw new IllegalStateException("broken");
                },
                result -> {}));
    List<String> lines = awaitIdle();
    assertThat(lines).contains("failed work: broken");
  }

  @Test
  void jobsRunOneAfterTheOther() throws Exception {
    List<Integer> order = new ArrayList<>();
    SwingUtilities.invokeAndWait(
        () -> {
          for (int i = 0; i < 20; i++) {
            int number = i;
            jobs.submit("work", progress -> number, order::add);
          }
        });
    awaitIdle();
    assertThat(order).hasSize(20).isSorted();
  }

  @Test
  void anUpdateOfThePictureDoesNotWaitForAJob() throws Exception {
    CountDownLatch updated = new CountDownLatch(1);
    List<String> order = new ArrayList<>();
    SwingUtilities.invokeAndWait(
        () -> {
          jobs.submit("job", progress -> await(updated), result -> order.add("job " + result));
          jobs.update(
              "update",
              progress -> "",
              result -> {
                order.add("update");
                updated.countDown();
              });
        });
    awaitIdle();
    assertThat(order).containsExactly("update", "job true");
  }

  private static boolean await(CountDownLatch latch) {
    try {
      return latch.await(10, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Test
  void onlyAJobThatHasNotBegunCanBeWithdrawn() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch goOn = new CountDownLatch(1);
    List<String> results = new ArrayList<>();
    List<Jobs.Handle> handles = new ArrayList<>();
    SwingUtilities.invokeAndWait(
        () -> {
          handles.add(
              jobs.update(
                  "first",
                  progress -> {
                    begun.countDown();
                    return await(goOn);
                  },
                  result -> results.add("first")));
          handles.add(jobs.update("second", progress -> 2, result -> results.add("second")));
          handles.add(jobs.update("third", progress -> 3, result -> results.add("third")));
        });
    assertThat(await(begun)).isTrue();
    handles.get(0).withdraw();
    handles.get(1).withdraw();
    goOn.countDown();
    awaitIdle();
    assertThat(results).containsExactly("first", "third");
  }

  @Test
  void aJobThatEndsInAnErrorEndsToo() throws Exception {
    SwingUtilities.invokeAndWait(
        () -> {
          jobs.submit("work", progress -> fail(new NoClassDefFoundError("gone")), result -> {});
          jobs.submit("next", progress -> 1, result -> heard.add("done"));
        });
    assertThat(awaitIdle()).contains("failed work: gone", "done");
  }

  private static Object fail(Error error) {
    throw error;
  }

  @Test
  void aResultThatCannotBeShownEndsItsJobAllTheSame() throws Exception {
    LinkedBlockingQueue<Throwable> uncaught = new LinkedBlockingQueue<>();
    SwingUtilities.invokeAndWait(
        () -> {
          Thread.currentThread().setUncaughtExceptionHandler((thread, e) -> uncaught.add(e));
          jobs.submit("work", progress -> new AssertionError("shown"), JobsTest::fail);
        });
    awaitIdle();
    assertThat(uncaught.poll(10, TimeUnit.SECONDS)).hasMessage("shown");
    SwingUtilities.invokeAndWait(() -> assertThat(jobs.isIdle()).isTrue());
  }

  @Test
  void filesAreReadAndWrittenWhileASearchRuns() throws Exception {
    CountDownLatch written = new CountDownLatch(2);
    List<String> order = new ArrayList<>();
    SwingUtilities.invokeAndWait(
        () -> {
          jobs.submitSearch("search", progress -> await(written), r -> order.add("search " + r));
          jobs.read("read", progress -> 1, result -> written.countDown());
          jobs.write("write", progress -> 1, result -> written.countDown());
        });
    awaitIdle();
    assertThat(order).containsExactly("search true");
  }

  @Test
  void filesAreWrittenInOrderWhateverIsCancelled() throws Exception {
    CountDownLatch cancelled = new CountDownLatch(1);
    List<Integer> order = Collections.synchronizedList(new ArrayList<>());
    CountDownLatch all = new CountDownLatch(20);
    SwingUtilities.invokeAndWait(
        () -> {
          jobs.write("first", progress -> await(cancelled), result -> {});
          for (int i = 0; i < 20; i++) {
            int number = i;
            jobs.write(
                "write",
                progress -> {
                  all.countDown();
                  return order.add(number);
                },
                result -> {});
          }
          assertThat(jobs.isWriting()).isTrue();
          jobs.cancelCurrent();
          jobs.shutDown();
          cancelled.countDown();
        });
    assertThat(await(all)).isTrue();
    awaitIdle();
    assertThat(order).hasSize(20).isSorted();
    SwingUtilities.invokeAndWait(() -> assertThat(jobs.isWriting()).isFalse());
  }

  @Test
  void whatWaitsIsListedAndWhatIsNextIsTold() throws Exception {
    CountDownLatch goOn = new CountDownLatch(1);
    SwingUtilities.invokeAndWait(
        () -> {
          jobs.submit("first", progress -> await(goOn), result -> {});
          jobs.submit("second", progress -> 2, result -> {});
          jobs.submit("third", progress -> 3, result -> {});
        });
    assertThat(heard.poll(10, TimeUnit.SECONDS)).isEqualTo("running first");
    assertThat(listed()).containsExactly("first running", "second waiting", "third waiting");
    SwingUtilities.invokeAndWait(() -> jobs.tasks().get(1).cancel());
    assertThat(listed()).containsExactly("first running", "third waiting");
    goOn.countDown();
    assertThat(awaitIdle())
        .anyMatch(line -> line.startsWith("running third"))
        .noneMatch(line -> line.startsWith("running second"));
    assertThat(listed()).isEmpty();
  }

  private List<String> listed() throws Exception {
    List<String> lines = new ArrayList<>();
    SwingUtilities.invokeAndWait(
        () ->
            jobs.tasks()
                .forEach(t -> lines.add(t.what() + (t.hasBegun() ? " running" : " waiting"))));
    return lines;
  }

  @Test
  void eachChangeOfTheListIsTold() throws Exception {
    List<Integer> sizes = Collections.synchronizedList(new ArrayList<>());
    LinkedBlockingQueue<String> told = new LinkedBlockingQueue<>();
    SwingUtilities.invokeAndWait(
        () -> {
          jobs.setListener(
              new Jobs.Listener() {
                @Override
                public void running(String what, double fraction) {}

                @Override
                public void idle() {
                  told.add("idle");
                }

                @Override
                public void failed(String what, Throwable cause) {}

                @Override
                public void listed() {
                  sizes.add(jobs.tasks().size());
                }
              });
          jobs.submit("first", progress -> 1, result -> {});
          jobs.submit("second", progress -> 2, result -> {});
        });
    assertThat(told.poll(10, TimeUnit.SECONDS)).isEqualTo("idle");
    assertThat(sizes).startsWith(1, 2).contains(1).endsWith(0);
  }

  private List<String> awaitIdle() throws InterruptedException {
    List<String> lines = new ArrayList<>();
    String line = "";
    while (!line.equals("idle")) {
      line = heard.poll(10, TimeUnit.SECONDS);
      assertThat(line).as("after %s", lines).isNotNull();
      lines.add(line);
    }
    return lines;
  }
}
