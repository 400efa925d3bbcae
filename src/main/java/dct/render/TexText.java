package dct.render;

/** Text as TeX wants it: its special characters escaped, signs that its fonts lack as commands. */
public final class TexText {
  private TexText() {}

  /** The text, escaped. */
  public static String of(String text) {
    StringBuilder tex = new StringBuilder();
    text.codePoints().forEach(c -> append(tex, c));
    return tex.toString();
  }

  private static void append(StringBuilder tex, int c) {
    switch (c) {
      case '#', '$', '%', '&', '_', '{', '}' -> tex.append('\\').appendCodePoint(c);
      case '\\' -> tex.append("\\textbackslash{}");
      case '~' -> tex.append("\\textasciitilde{}");
      case '^' -> tex.append("\\textasciicircum{}");
      case '·' -> tex.append("$\\cdot$");
      case '±' -> tex.append("$\\pm$");
      case '≡' -> tex.append("$\\equiv$");
      case '→' -> tex.append("$\\to$");
      case '−' -> tex.append("$-$");
      case '–' -> tex.append("--");
      case '—' -> tex.append("---");
      default -> tex.appendCodePoint(c);
    }
  }
}
