package dct.ui.session;

import dct.core.Decimals;
import dct.core.degree.ParityGoal;
import dct.core.geometry.Points;
import dct.core.triangulate.Domain;
import dct.io.FileStamp;
import dct.problem.verify.WishLetters;
import dct.ui.document.Document;
import dct.ui.document.Layout;
import dct.ui.document.Origin;
import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The lines of a journal. A head says whose drawing it is; then come steps, each of which says
 * which vertices it takes out and puts in, at one place or at several from the first to the last,
 * numbered as they were before it, and ends with a line of its own:
 *
 * <pre>
 * dct-journal/1
 * kind polygon
 * name a_polygonbased.txt
 * step 2 0 1
 * 300 400 e
 * step 7 1 0
 * rings 0-43 44-49
 * fixed 12-47
 * end
 * </pre>
 *
 * <p>Where a polygon has holes, sites inside or fixed edges, a step ends with its {@link
 * LayoutText}.
 *
 * <p>A step that is not whole does not count: it was being written when the program was killed.
 */
final class JournalText {
  private static final String FORMAT = "dct-journal/1";
  private static final String STEP = "step";
  private static final String RESULT = "result";
  private static final String END = "end";

  private JournalText() {}

  /**
   * What a journal says.
   *
   * @param view of the result that lies beside the journal; nothing if there is none
   * @param title of that result
   */
  record Content(
      Document document,
      String name,
      Optional<Origin> origin,
      Optional<Integer> view,
      String title) {}

  /** The head of a journal. */
  static String head(Document document, String name, Optional<Origin> origin) {
    StringBuilder text = new StringBuilder(FORMAT + "\nkind " + document.domain().word() + "\n");
    text.append("name ").append(line(name)).append('\n');
    origin.ifPresent(
        from -> {
          text.append("file ").append(from.file().toUri()).append('\n');
          from.stamp().ifPresent(s -> text.append("stamp ").append(s.digest()).append('\n'));
        });
    return text.toString();
  }

  private static String line(String name) {
    return name.replaceAll("[\\r\\n]", " ");
  }

  /**
   * The step from one document to another, in linear time: the vertices that differ where as many
   * are there as before, and else those that have gone or come.
   */
  static String step(Document before, Document after) {
    StringBuilder text = new StringBuilder();
    String letters = WishLetters.of(after.wishes());
    int from = 0; // in the document before
    int to = 0; // in the one after
    while (from < before.size() || to < after.size()) {
      int same = common(before, from, after, to);
      from += same;
      to += same;
      int gone = 0;
      int come = 0;
      while ((from + gone < before.size() || to + come < after.size())
          && !isCommon(before, from + gone, after, to + come)) {
        int surplus = (before.size() - from - gone) - (after.size() - to - come);
        gone += surplus >= 0 ? 1 : 0;
        come += surplus <= 0 ? 1 : 0;
      }
      if (gone > 0 || come > 0) {
        change(text, from, gone, come);
        vertices(text, after, letters, to, come);
      }
      from += gone;
      to += come;
    }
    if (text.length() == 0) {
      change(text, 0, 0, 0);
    }
    if (!after.layout().equals(Layout.PLAIN) || !before.layout().equals(Layout.PLAIN)) {
      text.append(LayoutText.of(after));
    }
    return text.append(END + "\n").toString();
  }

  private static int common(Document before, int from, Document after, int to) {
    int same = 0;
    while (isCommon(before, from + same, after, to + same)) {
      same++;
    }
    return same;
  }

  private static boolean isCommon(Document before, int v, Document after, int w) {
    return v < before.size() && w < after.size() && same(before, v, after, w);
  }

  private static void change(StringBuilder text, int at, int gone, int come) {
    text.append(STEP + " ").append(at).append(' ').append(gone).append(' ').append(come);
    text.append('\n');
  }

  private static void vertices(
      StringBuilder text, Document document, String letters, int first, int count) {
    for (int v = first; v < first + count; v++) {
      Decimals.append(text, document.points().x(v));
      text.append(' ');
      Decimals.append(text, document.points().y(v));
      text.append(' ').append(letters.charAt(v)).append('\n');
    }
  }

  private static boolean same(Document one, int v, Document other, int w) {
    return one.points().x(v) == other.points().x(w)
        && one.points().y(v) == other.points().y(w)
        && one.wishes().wish(v) == other.wishes().wish(w);
  }

  /** Says that a result of the vertices as they are lies beside the journal. */
  static String result(int view, String title) {
    return RESULT + " " + view + " " + line(title) + "\n" + END + "\n";
  }

  /**
   * The state after the last whole step; nothing if the program was killed before there was one.
   *
   * @throws UnreadableJournalException if there may be more in it than can be read
   */
  static Optional<Content> read(BufferedReader in) throws IOException {
    Reader reader = new Reader(in);
    try {
      if (!reader.head()) {
        return Optional.empty();
      }
      while (reader.step()) {
        // one after the other
      }
    } catch (IllegalArgumentException e) {
      reader.requireSteps(); // what was read before it counts
    } catch (CharacterCodingException e) {
      throw new UnreadableJournalException();
    }
    return reader.content();
  }

  /** Reads one journal. */
  private static final class Reader {
    private final BufferedReader in;
    private final Map<String, String> head = new HashMap<>();
    private List<String> vertices = new ArrayList<>(); // as they stand in their lines
    private List<String> laid = List.of(); // the lines of the layout
    private String line;
    private int steps;
    private Optional<Integer> view = Optional.empty();
    private String title = "";

    Reader(BufferedReader in) {
      this.in = in;
    }

    private String next() throws IOException {
      line = in.readLine();
      return line;
    }

    /** Reads the head; false if the file ends within its first line. */
    boolean head() throws IOException {
      if (next() == null || (!FORMAT.equals(line) && FORMAT.startsWith(line))) {
        return false;
      }
      require(FORMAT.equals(line));
      while (next() != null && !line.startsWith(STEP + " ")) {
        int gap = line.indexOf(' ');
        require(gap > 0);
        head.put(line.substring(0, gap), line.substring(gap + 1));
      }
      return true;
    }

    /** Reads the step that the line begins; false if there is none that is whole. */
    boolean step() throws IOException {
      if (line == null) {
        return false;
      }
      String[] words = line.split(" ", 4);
      require(words.length >= 3);
      return words[0].equals(RESULT) ? result(words) : change(words);
    }

    private boolean result(String[] words) throws IOException {
      int number = Integer.parseInt(words[1]);
      String said = line.substring(RESULT.length() + words[1].length() + 2);
      if (!END.equals(next())) {
        return false;
      }
      view = Optional.of(number);
      title = said;
      next();
      return true;
    }

    private boolean change(String[] first) throws IOException {
      List<String> changed = new ArrayList<>(vertices.size() + 1);
      int done = 0; // of the vertices before
      String[] words = first;
      do {
        require(words[0].equals(STEP) && words.length == 4);
        int at = Integer.parseInt(words[1]);
        int removed = Integer.parseInt(words[2]);
        int inserted = Integer.parseInt(words[3]);
        require(at >= done && removed >= 0 && at + removed <= vertices.size());
        changed.addAll(vertices.subList(done, at));
        done = at + removed;
        for (int i = 0; i < inserted && next() != null; i++) {
          changed.add(line);
        }
        if (next() == null) {
          return false;
        }
        words = line.split(" ", 4);
      } while (STEP.equals(words[0]));
      List<String> said = new ArrayList<>();
      while (!END.equals(line)) {
        said.add(line);
        if (next() == null) {
          return false;
        }
      }
      if (!said.isEmpty()) {
        laid = said;
      }
      changed.addAll(vertices.subList(done, vertices.size()));
      vertices = changed;
      steps++;
      view = Optional.empty(); // the result was of other vertices
      next();
      return true;
    }

    private static void require(boolean holds) {
      if (!holds) {
        throw new IllegalArgumentException("this is no line of a journal");
      }
    }

    void requireSteps() throws UnreadableJournalException {
      if (steps == 0) {
        throw new UnreadableJournalException();
      }
    }

    Optional<Content> content() throws UnreadableJournalException {
      if (steps == 0) {
        return Optional.empty();
      }
      Domain domain =
          Domain.parse(head.getOrDefault("kind", "")).orElseThrow(UnreadableJournalException::new);
      try {
        Document document = document(domain);
        return Optional.of(
            new Content(document, head.getOrDefault("name", ""), origin(), view, title));
      } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
        throw new UnreadableJournalException(); // no vertices after all
      }
    }

    private Document document(Domain domain) {
      int n = vertices.size();
      double[] x = new double[n];
      double[] y = new double[n];
      StringBuilder letters = new StringBuilder(n);
      for (int v = 0; v < n; v++) {
        String[] words = vertices.get(v).split(" ", 3);
        x[v] = Decimals.parse(words[0]);
        y[v] = Decimals.parse(words[1]);
        letters.append(words[2]);
      }
      ParityGoal wishes =
          WishLetters.parse(letters.toString())
              .filter(goal -> goal.size() == n)
              .orElseThrow(() -> new IllegalArgumentException("a vertex has no wish"));
      Points points = Points.of(x, y);
      return new Document(domain, points, LayoutText.parse(laid, points), wishes);
    }

    private Optional<Origin> origin() {
      return Optional.ofNullable(head.get("file"))
          .map(uri -> Path.of(URI.create(uri)))
          .map(
              file -> new Origin(file, Optional.ofNullable(head.get("stamp")).map(FileStamp::new)));
    }
  }
}
