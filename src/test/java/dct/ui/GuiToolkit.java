package dct.ui;

/**
 * The toolkit that window tests run on: one that draws into memory, or with {@code
 * -Dgui.toolkit=native} the display that is there.
 */
final class GuiToolkit {
  static final boolean NATIVE = "native".equals(System.getProperty("gui.toolkit"));

  private GuiToolkit() {}

  /** To be called before any class of AWT is loaded. */
  static void load() {
    if (NATIVE) {
      return;
    }
    System.setProperty("cacio.managed.screensize", "1280x900");
    try {
      // Its static initializer puts the toolkit in place.
      Class.forName("com.github.caciocavallosilano.cacio.ctc.junit.CacioExtension");
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(e);
    }
  }
}
