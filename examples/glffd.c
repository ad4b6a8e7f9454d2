/* A cube whose eight corners are twisted in a lattice of 4 x 4 x 4 control points: through the GLU
 * calls and their callbacks, so that no window and no OpenGL context are needed. With a context,
 * leave out GLU_FFD_MODE and the triangles are drawn. HWFFD_DEVICE=rtl lets the simulated hardware
 * evaluate them. */
#define HWFFD_GL_NAMES
#include <hwffd/glffd.h>
#include <math.h>
#include <stdio.h>

static int failures = 0;
static int vertices = 0;

static void on_error(GLenum error) {
  fprintf(stderr, "glffd: %s\n", gluFfdErrorString(error));
  failures++;
}

static void on_vertex(const GLfloat* v) {
  printf("vertex %7.4f %7.4f %7.4f\n", v[0], v[1], v[2]);
  vertices++;
}

/* Control points one apart, so that the cell in the middle is the unit cube; layers along t turn,
 * each a little further than the one below. */
static void twist(GLfloat control[4][4][4][3]) {
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++) {
      for (int k = 0; k < 4; k++) {
        const double angle = 0.5 * (j - 1), x = i - 1.5, z = k - 1.5;
        control[i][j][k][0] = (GLfloat)(x * cos(angle) + z * sin(angle));
        control[i][j][k][1] = (GLfloat)(j - 1);
        control[i][j][k][2] = (GLfloat)(z * cos(angle) - x * sin(angle));
      }
    }
  }
}

int main(void) {
  /* s, t, u in the only cell, whose first control point is number 0. */
  static const GLfloat corners[8][4] = {{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 1, 0, 0}, {0, 1, 0, 0},
                                        {0, 0, 1, 0}, {1, 0, 1, 0}, {1, 1, 1, 0}, {0, 1, 1, 0}};
  static const GLuint sides[24] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4,
                                   3, 7, 6, 2, 0, 4, 7, 3, 1, 2, 6, 5};
  GLfloat control[4][4][4][3];
  GLUffd* ffd = gluNewFfdRenderer();
  gluFfdCallback(ffd, GLU_FFD_ERROR, (GLUffdCallback)on_error);
  gluFfdCallback(ffd, GLU_FFD_VERTEX, (GLUffdCallback)on_vertex);
  gluFfdProperty(ffd, GLU_FFD_MODE, GLU_FFD_EVALUATOR);
  gluFfdProperty(ffd, GLU_FFD_PRIMITIVE, GL_QUADS);
  twist(control);
  gluBeginVolume(ffd);
  gluFfdVolume(ffd, 8, 4, &corners[0][0], 8, NULL, 8, NULL, 8, NULL, 48, 12, 3,
               &control[0][0][0][0], 4, 4, 4, GL_MAP3_VERTEX_3);
  gluFfdElements(ffd, 24, sides);
  gluEndVolume(ffd);
  gluDeleteFfdRenderer(ffd);
  return failures == 0 && vertices == 24 ? 0 : 1;
}
