package dct.bench;

import com.jogamp.opengl.glu.GLUtessellatorCallbackAdapter;
import jogamp.opengl.glu.tessellator.GLUtessellatorImpl;

/** The tessellator of the OpenGL utility library, in JOGL's Java. */
final class GluPeer {
  private static final int CALLBACK_VERTEX = 100101;
  private static final int CALLBACK_EDGE_FLAG = 100104; // asks for triangles only

  private GluPeer() {}

  private static final class Corners extends GLUtessellatorCallbackAdapter {
    final int[] corner = new int[3];
    final TriangleList triangles;
    int count;

    Corners(int vertices) {
      triangles = new TriangleList(vertices);
    }

    @Override
    public void vertex(Object vertex) {
      corner[count++] = (Integer) vertex;
      if (count == 3) {
        triangles.add(corner[0], corner[1], corner[2]);
        count = 0;
      }
    }
  }

  static int[] polygon(double[] x, double[] y) {
    GLUtessellatorImpl tessellator = (GLUtessellatorImpl) GLUtessellatorImpl.gluNewTess();
    Corners corners = new Corners(x.length);
    tessellator.gluTessCallback(CALLBACK_VERTEX, corners);
    tessellator.gluTessCallback(CALLBACK_EDGE_FLAG, corners);
    tessellator.gluTessNormal(0, 0, 1);
    tessellator.gluTessBeginPolygon(null);
    tessellator.gluTessBeginContour();
    for (int i = 0; i < x.length; i++) {
      tessellator.gluTessVertex(new double[] {x[i], y[i], 0}, 0, i);
    }
    tessellator.gluTessEndContour();
    tessellator.gluTessEndPolygon();
    tessellator.gluDeleteTess();
    return corners.triangles.toArray();
  }
}
