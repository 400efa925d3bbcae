package dct.ui.tool;

import dct.core.Progress;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.render.Viewport;
import dct.ui.document.Analysis;
import dct.ui.document.Document;
import dct.ui.document.Edit;
import dct.ui.document.History;
import dct.ui.document.Selection;

/** A document without a window. */
final class FakeContext implements ToolContext {
  final History history;
  Viewport viewport = Viewport.IDENTITY;
  Points preview;
  String said = "";
  Selection selection = Selection.NONE;
  final Snap snap = new Snap(() -> {});
  boolean editing; // Edit Vertex was chosen

  FakeContext(Domain domain, double... pairs) {
    history = new History(new Document(domain, Points.ofPairs(pairs)));
  }

  Spot spot(double screenX, double screenY) {
    return Spot.at(viewport, screenX, screenY);
  }

  Points points() {
    return document().points();
  }

  @Override
  public Document document() {
    return history.present();
  }

  @Override
  public Analysis shown() {
    Document shown = preview == null ? document() : document().with(preview);
    return Analysis.of(shown, false, Progress.NONE);
  }

  @Override
  public Viewport viewport() {
    return viewport;
  }

  @Override
  public void perform(Edit edit) {
    preview = null;
    history.perform(edit);
  }

  @Override
  public void preview(Points points) {
    preview = points;
  }

  @Override
  public void endPreview() {
    preview = null;
  }

  @Override
  public Selection selection() {
    return selection;
  }

  @Override
  public void select(Selection others) {
    selection = others;
  }

  @Override
  public Snap snap() {
    return snap;
  }

  @Override
  public void chooseEdit() {
    editing = true;
  }

  @Override
  public void say(String message) {
    said = message;
  }
}
