#ifndef HWFFD_GLFFD_H_
#define HWFFD_GLFFD_H_

/* Free-form deformation as an extension of OpenGL and GLU (paper, section 5), for C and C++. The
 * specification is docs/opengl.md.
 *
 * GL commands keep their state per thread and report errors through glGetError; a command that
 * raises an error has no other effect. GLU commands report errors through the callback
 * GLU_FFD_ERROR alone. Strides count elements, not bytes. Arrays are copied before a command
 * returns.
 *
 * No registry has given out these names, so all have a prefix: hwffd_glMap3f, HWFFD_GL_MAP3_INDEX.
 * A program that defines HWFFD_GL_NAMES before it includes this header has them without it
 * (glffd_names.h), as the specification and the comments here do. */

#include <GL/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* --- Tokens of the GL commands. All are private: Khronos has not allocated them. ---------------
 */

/* Maps: what glMap3 defines and glEnableMap3 switches on, in the order of GL_MAP2_*. */
#define HWFFD_GL_MAP3_COLOR_4 0x0DC0
#define HWFFD_GL_MAP3_INDEX 0x0DC1
#define HWFFD_GL_MAP3_NORMAL 0x0DC2
#define HWFFD_GL_MAP3_TEXTURE_COORD_1 0x0DC3
#define HWFFD_GL_MAP3_TEXTURE_COORD_2 0x0DC4
#define HWFFD_GL_MAP3_TEXTURE_COORD_3 0x0DC5
#define HWFFD_GL_MAP3_TEXTURE_COORD_4 0x0DC6
#define HWFFD_GL_MAP3_VERTEX_3 0x0DC7
#define HWFFD_GL_MAP3_VERTEX_4 0x0DC8
/* Axes of a map, for glBlendCoefficient. */
#define HWFFD_GL_MAP3_U 0x0DC9
#define HWFFD_GL_MAP3_V 0x0DCA
#define HWFFD_GL_MAP3_W 0x0DCB
/* For glGetEval3. */
#define HWFFD_GL_MAP3_GRID_DOMAIN 0x0DCC
#define HWFFD_GL_MAP3_GRID_SEGMENTS 0x0DCD
#define HWFFD_GL_MAX_EVAL3_ORDER 0x0DCE

/* --- Maps
 * ---------------------------------------------------------------------------------------*/

/** Defines a map of uorder x vorder x worder control points: point (i, j, k) begins at
 * points[i * ustride + j * vstride + k * wstride]. Its domain may run backwards. */
void hwffd_glMap3f(GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
                   GLfloat v2, GLint vstride, GLint vorder, GLfloat w1, GLfloat w2, GLint wstride,
                   GLint worder, const GLfloat* points);
void hwffd_glMap3d(GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder,
                   GLdouble v1, GLdouble v2, GLint vstride, GLint vorder, GLdouble w1, GLdouble w2,
                   GLint wstride, GLint worder, const GLdouble* points);

/** GL_COEFF: all points, w fastest; GL_ORDER: 3 orders; GL_DOMAIN: u1, u2, v1, v2, w1, w2. */
void hwffd_glGetMap3dv(GLenum target, GLenum query, GLdouble* v);
void hwffd_glGetMap3fv(GLenum target, GLenum query, GLfloat* v);
void hwffd_glGetMap3iv(GLenum target, GLenum query, GLint* v);

/** Switches a map on or off, or GL_AUTO_NORMAL for glEvalCoord3, glEvalPoint3 and glEvalMesh3. */
void hwffd_glEnableMap3(GLenum cap);
void hwffd_glDisableMap3(GLenum cap);
GLboolean hwffd_glIsEnabledMap3(GLenum cap);

/* --- Blending functions
 * -------------------------------------------------------------------------*/

/** Sets the degree + 1 blending functions of an axis; function l is
 * coefficients[l * (degree + 1) + p] x^p, summed over p = 0 to degree. The degree is 0 to 3. A map
 * of n points then has n - degree cells. NULL returns to the initial state: Bernstein polynomials
 * of each map's own degree, one cell. */
void hwffd_glBlendCoefficientf(GLenum axis, GLint degree, const GLfloat* coefficients);
void hwffd_glBlendCoefficientd(GLenum axis, GLint degree, const GLdouble* coefficients);
/** GL_ORDER: degree + 1, 0 in the initial state; GL_COEFF: the coefficients as they were given, but
 * in double those of the uniform cubic B-spline where they are these within a float's rounding. */
void hwffd_glGetBlendCoefficientdv(GLenum axis, GLenum query, GLdouble* v);

/* --- Evaluation: attributes go to the current context, the vertex last -------------------------*/

void hwffd_glEvalCoord3f(GLfloat u, GLfloat v, GLfloat w);
void hwffd_glEvalCoord3d(GLdouble u, GLdouble v, GLdouble w);
void hwffd_glEvalCoord3fv(const GLfloat* u);
void hwffd_glEvalCoord3dv(const GLdouble* u);

void hwffd_glMapGrid3f(GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2, GLint wn,
                       GLfloat w1, GLfloat w2);
void hwffd_glMapGrid3d(GLint un, GLdouble u1, GLdouble u2, GLint vn, GLdouble v1, GLdouble v2,
                       GLint wn, GLdouble w1, GLdouble w2);
void hwffd_glEvalPoint3(GLint i, GLint j, GLint k);
/** @param mode GL_POINT or GL_LINE */
void hwffd_glEvalMesh3(GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2, GLint k1, GLint k2);

/** GL_MAP3_GRID_DOMAIN: 6 values; GL_MAP3_GRID_SEGMENTS: 3; GL_MAX_EVAL3_ORDER: 1. */
void hwffd_glGetEval3dv(GLenum pname, GLdouble* v);

/** Draws count vertices from an interleaved stream (paper, fig. 3): s, t, u and the 64 control
 * points x, y, z of each, point (l, m, n) at (l * 4 + m) * 4 + n; 195 numbers a vertex.
 * @param mode  a mode of glDrawArrays
 * @param type  GL_FLOAT or GL_DOUBLE */
void hwffd_glFFD(GLenum mode, GLsizei count, GLenum type, const GLvoid* stream);

/** The device of the GL commands: "model", "rtl" or "reference", perhaps with an organization and a
 * format as in "rtl:parallel:fx18"; NULL: what the environment's HWFFD_DEVICE says, else the model.
 */
void hwffd_glFfdDevice(const char* name);

/* --- GLU
 * ----------------------------------------------------------------------------------------*/

/* Tokens, private too, from a range that glu.h leaves free. */

/* Callbacks. With *_DATA the user's pointer comes as last argument; it has precedence. */
#define HWFFD_GLU_FFD_ERROR 100300    /* void (GLenum error) */
#define HWFFD_GLU_FFD_PROGRESS 100301 /* void (GLfloat done), 0 to 1 */
#define HWFFD_GLU_FFD_BEGIN 100302    /* void (GLenum primitive) */
#define HWFFD_GLU_FFD_VERTEX \
  100303 /* void (const GLfloat* v), 3 or 4 numbers; those below likewise */
#define HWFFD_GLU_FFD_NORMAL 100304        /* 3 */
#define HWFFD_GLU_FFD_COLOR 100305         /* 4 */
#define HWFFD_GLU_FFD_TEXTURE_COORD 100306 /* 1 to 4 */
#define HWFFD_GLU_FFD_END 100307           /* void (void) */
#define HWFFD_GLU_FFD_ERROR_DATA 100310
#define HWFFD_GLU_FFD_PROGRESS_DATA 100311
#define HWFFD_GLU_FFD_BEGIN_DATA 100312
#define HWFFD_GLU_FFD_VERTEX_DATA 100313
#define HWFFD_GLU_FFD_NORMAL_DATA 100314
#define HWFFD_GLU_FFD_COLOR_DATA 100315
#define HWFFD_GLU_FFD_TEXTURE_COORD_DATA 100316
#define HWFFD_GLU_FFD_END_DATA 100317

/* Properties. */
#define HWFFD_GLU_FFD_MODE 100320         /* GLU_FFD_RENDERER, GLU_FFD_EVALUATOR */
#define HWFFD_GLU_FFD_PRIMITIVE 100321    /* a mode of glDrawArrays; GL_TRIANGLES */
#define HWFFD_GLU_FFD_DISPLAY_MODE 100322 /* GL_POINT, GL_LINE, GL_FILL */
#define HWFFD_GLU_FFD_LINE_WIDTH 100323   /* above 0; 1 */
#define HWFFD_GLU_FFD_POINT_SIZE 100324   /* above 0; 1 */
#define HWFFD_GLU_FFD_DEVICE 100325       /* GLU_FFD_MODEL, GLU_FFD_RTL, GLU_FFD_REFERENCE */

/* Values of properties. */
#define HWFFD_GLU_FFD_RENDERER 100330  /* results go to the current OpenGL context */
#define HWFFD_GLU_FFD_EVALUATOR 100331 /* results go to the callbacks; needs no context */
#define HWFFD_GLU_FFD_MODEL 100332
#define HWFFD_GLU_FFD_RTL 100333
#define HWFFD_GLU_FFD_REFERENCE 100334

/* Errors. */
#define HWFFD_GLU_FFD_INVALID_ENUM 100340
#define HWFFD_GLU_FFD_INVALID_VALUE 100341
#define HWFFD_GLU_FFD_INVALID_ORDER 100342
#define HWFFD_GLU_FFD_TOO_FEW_KNOTS 100343
#define HWFFD_GLU_FFD_EMPTY_KNOT_RANGE 100344
#define HWFFD_GLU_FFD_DECREASING_KNOTS 100345
#define HWFFD_GLU_FFD_KNOT_MULTIPLICITY 100346
#define HWFFD_GLU_FFD_NESTED_VOLUME 100347
#define HWFFD_GLU_FFD_MISSING_BEGIN 100348
#define HWFFD_GLU_FFD_INVALID_STRIDE 100349
#define HWFFD_GLU_FFD_NULL_CONTROL 100350
#define HWFFD_GLU_FFD_INVALID_INDEX 100351
#define HWFFD_GLU_FFD_TOO_MANY_CELLS 100352
#define HWFFD_GLU_FFD_MISSING_DATA 100353
#define HWFFD_GLU_FFD_DEVICE_FAILED 100354

typedef struct hwffd_GLUffd hwffd_GLUffd;
typedef void (*hwffd_GLUffdCallback)(void);

/** NULL if memory is short. */
hwffd_GLUffd* hwffd_gluNewFfdRenderer(void);
void hwffd_gluDeleteFfdRenderer(hwffd_GLUffd* ffd);

void hwffd_gluFfdProperty(hwffd_GLUffd* ffd, GLenum property, GLfloat value);
void hwffd_gluGetFfdProperty(hwffd_GLUffd* ffd, GLenum property, GLfloat* value);
/** As glFfdDevice, for this renderer. */
void hwffd_gluFfdDevice(hwffd_GLUffd* ffd, const char* name);

/** @param callback  NULL: none */
void hwffd_gluFfdCallback(hwffd_GLUffd* ffd, GLenum which, hwffd_GLUffdCallback callback);
void hwffd_gluFfdCallbackData(hwffd_GLUffd* ffd, void* data);
/** One line in English on an error of the callback; NULL for another number. */
const char* hwffd_gluFfdErrorString(GLenum error);

void hwffd_gluBeginVolume(hwffd_GLUffd* ffd);
/** Evaluates what gluFfdVolume gave since gluBeginVolume, and draws it or calls back. */
void hwffd_gluEndVolume(hwffd_GLUffd* ffd);

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
void hwffd_gluFfdVolume(hwffd_GLUffd* ffd, GLsizei count, GLint stride, const GLfloat* coordinates,
                        GLint sknot_count, const GLfloat* sknots, GLint tknot_count,
                        const GLfloat* tknots, GLint uknot_count, const GLfloat* uknots,
                        GLint sstride, GLint tstride, GLint ustride, const GLfloat* control,
                        GLint sorder, GLint torder, GLint uorder, GLenum type);

/** Normals of the model in the coordinates s, t, u, one a vertex of the volume. Those drawn are
 * n J^-1, not normalized, with J the derivatives of the deformed position.
 * @param stride  from one normal to the next, at least 3 */
void hwffd_gluFfdNormals(hwffd_GLUffd* ffd, GLsizei count, GLint stride, const GLfloat* normals);
/** The order in which vertices are drawn, as in glDrawElements; else each once, in its order. */
void hwffd_gluFfdElements(hwffd_GLUffd* ffd, GLsizei count, const GLuint* vertices);

#ifdef __cplusplus
}
#endif

#ifdef HWFFD_GL_NAMES
#include "hwffd/glffd_names.h"
#endif

#endif /* HWFFD_GLFFD_H_ */
