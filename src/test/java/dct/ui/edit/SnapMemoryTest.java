package dct.ui.edit;

import static org.assertj.core.api.Assertions.assertThat;

import dct.ui.session.Session;
import dct.ui.session.Settings;
import dct.ui.tool.Snap;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What places snap to is there in the next run. */
class SnapMemoryTest {
  @TempDir Path folder;

  /** Those of the next run, once those of this one are in their file. */
  private Settings next(Session session) throws Exception {
    session.journals().await();
    return Session.in(folder).settings();
  }

  @Test
  void whatIsOnAndItsSizesComeBack() throws Exception {
    Session session = Session.in(folder);
    Snap snap = new Snap(() -> {});
    snap.toggle(Snap.To.EDGES);
    snap.toggle(Snap.To.ANGLES);
    snap.setGrid(0.1);
    snap.setAngle(22.5);
    SnapMemory.remember(snap, session.settings());
    Snap again = new Snap(() -> {});
    SnapMemory.restore(again, next(session));
    assertThat(again.words()).isEqualTo("Snap: edges, angles 22.5°");
    assertThat(again.grid()).isEqualTo(0.1);
    snap.toggle(Snap.To.EDGES);
    SnapMemory.remember(snap, session.settings());
    SnapMemory.restore(again, next(session));
    assertThat(again.words()).isEqualTo("Snap: angles 22.5°");
  }

  @Test
  void whatCannotBeIsLeftOut() throws Exception {
    Session session = Session.in(folder);
    Settings settings = session.settings();
    settings.put("snap.grid.size", -3);
    settings.put("snap.angle.degrees", "many");
    settings.put("snap.grid", true);
    Snap snap = new Snap(() -> {});
    SnapMemory.restore(snap, settings);
    assertThat(snap.words()).isEqualTo("Snap: grid 20");
    assertThat(snap.angle()).isEqualTo(15);
    session.journals().await(); // lest the folder be removed before
  }
}
