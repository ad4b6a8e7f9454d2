#ifndef HWFFD_GLFFD_H_
#define HWFFD_GLFFD_H_

/* Free-form deformation as an extension of OpenGL and GLU (paper, section 5), for C and C++. The
 * specification is docs/opengl.md.
 *
 * GL commands keep their state per thread and report errors through glGetError; a command that
 * raises an error has no other effect. GLU commands report errors through the callback
 * GLU_FFD_ERROR alone. Strides count elements, not bytes. Arrays are copied before a command
 * returns. */

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* --- Tokens of the GL commands. All are private: Khronos has not allocated them. ---------------
 */

/* Maps: what glMap3 defines and glEnableMap3 switches on, in the order of GL_MAP2_*. */
#define GL_MAP3_COLOR_4 0x0DC0
#define GL_MAP3_INDEX 0x0DC1
#define GL_MAP3_NORMAL 0x0DC2
#define GL_MAP3_TEXTURE_COORD_1 0x0DC3
#define GL_MAP3_TEXTURE_COORD_2 0x0DC4
#define GL_MAP3_TEXTURE_COORD_3 0x0DC5
#define GL_MAP3_TEXTURE_COORD_4 0x0DC6
#define GL_MAP3_VERTEX_3 0x0DC7
#define GL_MAP3_VERTEX_4 0x0DC8
/* Axes of a map, for glBlendCoefficient. */
#define GL_MAP3_U 0x0DC9
#define GL_MAP3_V 0x0DCA
#define GL_MAP3_W 0x0DCB
/* For glGetEval3. */
#define GL_MAP3_GRID_DOMAIN 0x0DCC
#define GL_MAP3_GRID_SEGMENTS 0x0DCD
#define GL_MAX_EVAL3_ORDER 0x0DCE

/* --- Maps
 * ---------------------------------------------------------------------------------------*/

/** Defines a map of uorder x vorder x worder control points: point (i, j, k) begins at
 * points[i * ustride + j * vstride + k * wstride]. Its domain may run backwards. */
void glMap3f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
             GLfloat v2, GLint vstride, GLint vorder, GLfloat w1, GLfloat w2, GLint wstride,
             GLint worder, const GLfloat* points);
void glMap3d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1,
             GLdouble v2, GLint vstride, GLint vorder, GLdouble w1, GLdouble w2, GLint wstride,
             GLint worder, const GLdouble* points);

/** GL_COEFF: all points, w fastest; GL_ORDER: 3 orders; GL_DOMAIN: u1, u2, v1, v2, w1, w2. */
void glGetMap3dv(GLenum target, GLenum query, GLdouble* v);
void glGetMap3fv(GLenum target, GLenum query, GLfloat* v);
void glGetMap3iv(GLenum target, GLenum query, GLint* v);

/** Switches a map on or off, or GL_AUTO_NORMAL for glEvalCoord3, glEvalPoint3 and glEvalMesh3. */
void glEnableMap3(GLenum cap);
void glDisableMap3(GLenum cap);
GLboolean glIsEnabledMap3(GLenum cap);

/* --- Blending functions
 * -------------------------------------------------------------------------*/

/** Sets the degree + 1 blending functions of an axis; function l is
 * coefficients[l * (degree + 1) + p] x^p, summed over p = 0 to degree. The degree is 0 to 3. A map
 * of n points then has n - degree cells. NULL returns to the initial state: Bernstein polynomials
 * of each map's own degree, one cell. */
void glBlendCoefficientf(GLenum axis, GLint degree, const GLfloat* coefficients);
void glBlendCoefficientd(GLenum axis, GLint degree, const GLdouble* coefficients);
/** GL_ORDER: degree + 1, 0 in the initial state; GL_COEFF: the coefficients as they were given. */
void glGetBlendCoefficientdv(GLenum axis, GLenum query, GLdouble* v);

/* --- Evaluation: attributes go to the current context, the vertex last -------------------------*/

void glEvalCoord3f(GLfloat u, GLfloat v, GLfloat w);
void glEvalCoord3d(GLdouble u, GLdouble v, GLdouble w);
void glEvalCoord3fv(const GLfloat* u);
void glEvalCoord3dv(const GLdouble* u);

void glMapGrid3f(GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2, GLint wn,
                 GLfloat w1, GLfloat w2);
void glMapGrid3d(GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2, GLint wn,
                 GLdouble w1, GLdouble w2);
void glEvalPoint3(GLint i, GLint j, GLint k);
/** @param mode GL_POINT or GL_LINE */
void glEvalMesh3(GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2, GLint k1, GLint k2);

/** GL_MAP3_GRID_DOMAIN: 6 values; GL_MAP3_GRID_SEGMENTS: 3; GL_MAX_EVAL3_ORDER: 1. */
void glGetEval3dv(GLenum pname, GLdouble* v);

/** Draws count vertices from an interleaved stream (paper, fig. 3): s, t, u and the 64 control
 * points x, y, z of each, point (l, m, n) at (l * 4 + m) * 4 + n; 195 numbers a vertex.
 * @param mode  a mode of glDrawArrays
 * @param type  GL_FLOAT or GL_DOUBLE */
void glFFD(GLenum mode, GLsizei count, GLenum type, const GLvoid* stream);

/** The device of the GL commands: "model", "rtl" or "reference", perhaps with an organization and a
 * format as in "rtl:parallel:fx18"; NULL: what the environment's HWFFD_DEVICE says, else the model.
 */
void glFfdDevice(const char* name);

/* --- GLU
 * ----------------------------------------------------------------------------------------*/

/* Tokens, private too, from a range that glu.h leaves free. */

/* Callbacks. With *_DATA the user's pointer comes as last argument; it has precedence. */
#define GLU_FFD_ERROR 100300    /* void (GLenum error) */
#define GLU_FFD_PROGRESS 100301 /* void (GLfloat done), 0 to 1 */
#define GLU_FFD_BEGIN 100302    /* void (GLenum primitive) */
#define GLU_FFD_VERTEX 100303   /* void (const GLfloat* vertex), 3 or 4 numbers; as those below */
#define GLU_FFD_NORMAL 100304   /* 3 */
#define GLU_FFD_COLOR 100305    /* 4 */
#define GLU_FFD_TEXTURE_COORD 100306 /* 1 to 4 */
#define GLU_FFD_END 100307           /* void (void) */
#define GLU_FFD_ERROR_DATA 100310
#define GLU_FFD_PROGRESS_DATA 100311
#define GLU_FFD_BEGIN_DATA 100312
#define GLU_FFD_VERTEX_DATA 100313
#define GLU_FFD_NORMAL_DATA 100314
#define GLU_FFD_COLOR_DATA 100315
#define GLU_FFD_TEXTURE_COORD_DATA 100316
#define GLU_FFD_END_DATA 100317

/* Properties. */
#define GLU_FFD_MODE 100320         /* GLU_FFD_RENDERER, GLU_FFD_EVALUATOR */
#define GLU_FFD_PRIMITIVE 100321    /* a mode of glDrawArrays; GL_TRIANGLES */
#define GLU_FFD_DISPLAY_MODE 100322 /* GL_POINT, GL_LINE, GL_FILL */
#define GLU_FFD_LINE_WIDTH 100323   /* above 0; 1 */
#define GLU_FFD_POINT_SIZE 100324   /* above 0; 1 */
#define GLU_FFD_DEVICE 100325       /* GLU_FFD_MODEL, GLU_FFD_RTL, GLU_FFD_REFERENCE */

/* Values of properties. */
#define GLU_FFD_RENDERER 100330  /* results go to the current OpenGL context */
#define GLU_FFD_EVALUATOR 100331 /* results go to the callbacks; needs no context */
#define GLU_FFD_MODEL 100332
#define GLU_FFD_RTL 100333
#define GLU_FFD_REFERENCE 100334

/* Errors. */
#define GLU_FFD_INVALID_ENUM 100340
#define GLU_FFD_INVALID_VALUE 100341
#define GLU_FFD_INVALID_ORDER 100342
#define GLU_FFD_TOO_FEW_KNOTS 100343
#define GLU_FFD_EMPTY_KNOT_RANGE 100344
#define GLU_FFD_DECREASING_KNOTS 100345
#define GLU_FFD_KNOT_MULTIPLICITY 100346
#define GLU_FFD_NESTED_VOLUME 100347
#define GLU_FFD_MISSING_BEGIN 100348
#define GLU_FFD_INVALID_STRIDE 100349
#define GLU_FFD_NULL_CONTROL 100350
#define GLU_FFD_INVALID_INDEX 100351
#define GLU_FFD_TOO_MANY_CELLS 100352
#define GLU_FFD_MISSING_DATA 100353
#define GLU_FFD_DEVICE_FAILED 100354

typedef struct GLUffd GLUffd;
typedef void (*GLUffdCallback)(void);

/** NULL if memory is short. */
GLUffd* gluNewFfdRenderer(void);
void gluDeleteFfdRenderer(GLUffd* ffd);

void gluFfdProperty(GLUffd* ffd, GLenum property, GLfloat value);
void gluGetFfdProperty(GLUffd* ffd, GLenum property, GLfloat* value);
/** As glFfdDevice, for this renderer. */
void gluFfdDevice(GLUffd* ffd, const char* name);

/** @param callback  NULL: none */
void gluFfdCallback(GLUffd* ffd, GLenum which, GLUffdCallback callback);
void gluFfdCallbackData(GLUffd* ffd, void* data);
/** One line in English on an error of the callback; NULL for another number. */
const char* gluFfdErrorString(GLenum error);

void gluBeginVolume(GLUffd* ffd);
/** Evaluates what gluFfdVolume gave since gluBeginVolume, and draws it or calls back. */
void gluEndVolume(GLUffd* ffd);

/** One attribute of the model's vertices.
 * @param count         vertices
 * @param stride        from one vertex in `coordinates` to the next, at least 4
 * @param coordinates   s, t, u within the cell, 0 to 1, then the number of the cell's first control
 *                      point: (i * nt + j) * nu + k, for nt and nu control points along t and u
 * @param sknots        sknot_count of them, for sknot_count - sorder control points, as those of
 *                      gluNurbsSurface; NULL: 0, 1, 2, ..., the uniform B-spline
 * @param control       point (i, j, k) begins at control[i * sstride + j * tstride + k * ustride]
 * @param sorder        degree + 1, 1 to 4
 * @param type          GL_MAP3_VERTEX_3, GL_MAP3_COLOR_4, ...
 */
void gluFfdVolume(GLUffd* ffd, GLsizei count, GLint stride, const GLfloat* coordinates,
                  GLint sknot_count, const GLfloat* sknots, GLint tknot_count,
                  const GLfloat* tknots, GLint uknot_count, const GLfloat* uknots, GLint sstride,
                  GLint tstride, GLint ustride, const GLfloat* control, GLint sorder, GLint torder,
                  GLint uorder, GLenum type);

/** Normals of the model in the coordinates s, t, u, one a vertex of the volume. Those drawn are
 * n J^-1, not normalized, with J the derivatives of the deformed position.
 * @param stride  from one normal to the next, at least 3 */
void gluFfdNormals(GLUffd* ffd, GLsizei count, GLint stride, const GLfloat* normals);
/** The order in which vertices are drawn, as in glDrawElements; else each once, in its order. */
void gluFfdElements(GLUffd* ffd, GLsizei count, const GLuint* vertices);

#ifdef __cplusplus
}
#endif

#endif /* HWFFD_GLFFD_H_ */
