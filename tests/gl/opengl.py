"""OpenGL, EGL and the extension of glffd.h, by the prototypes and tokens of their headers.

gl.Map3d is the command glMap3d, gl.MAP3_U the token GL_MAP3_U; glu and egl likewise. Arrays are
lists or NumPy's, of the type that the prototype has; what a command fills is NumPy's.

SPDX-License-Identifier: Apache-2.0
"""

import ctypes
import os
import pathlib
import re
import subprocess

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("HWFFD_BUILD") or ROOT / "build")
SIZE = 64  # of the context's buffer, in pixels

HEADERS = """
#define HWFFD_GL_NAMES
#define GL_GLEXT_PROTOTYPES
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <hwffd/glffd.h>
#include <GL/glext.h>
"""
SCALARS = {"void": None, "GLboolean": ctypes.c_ubyte, "GLenum": ctypes.c_uint,
           "GLbitfield": ctypes.c_uint, "GLuint": ctypes.c_uint, "GLint": ctypes.c_int,
           "GLsizei": ctypes.c_int, "GLfloat": ctypes.c_float, "GLdouble": ctypes.c_double,
           "EGLBoolean": ctypes.c_uint, "EGLenum": ctypes.c_uint, "EGLint": ctypes.c_int}
ELEMENTS = {"GLubyte": np.uint8, "GLuint": np.uint32, "GLint": np.int32, "GLfloat": np.float32,
            "GLdouble": np.float64, "EGLint": np.int32}


def preprocessed(text, *options):
    folders = (f"-I{folder}/api/gl/include" for folder in (ROOT, BUILD))
    result = subprocess.run(["cc", "-E", "-P", *folders, *options, "-x", "c", "-"],
                            input=text, text=True, stdout=subprocess.PIPE, check=True)
    return result.stdout


def macros(text):
    """What is defined behind some lines, and what it stands for."""
    return dict(re.findall(r"#define (\w+) ?(.*)\n", preprocessed(text, "-dM")))


MACROS = macros(HEADERS)
PROTOTYPES = {name: (result, arguments) for result, name, arguments in re.findall(
    r"([\w ]+[ *]+)\b((?:hwffd_)?(?:glu?|egl)[A-Z]\w*) *\(([^()]*)\);", preprocessed(HEADERS))}
EXTENSION = {name for name in PROTOTYPES if name.startswith("hwffd_")}
called = set()  # of the extension


class Array:
    """A pointer as an argument: a list or an array of its type, an address, or None."""

    def __init__(self, element):
        self.element = element

    def from_param(self, value):
        if isinstance(value, (list, tuple)):
            value = np.array(value, self.element)
        if isinstance(value, np.ndarray):
            if self.element not in (None, value.dtype) or not value.flags.c_contiguous:
                raise TypeError(f"an array of {value.dtype} or with gaps for one of {self.element}")
            value = value.ctypes.data_as(ctypes.c_void_p)
        return ctypes.c_void_p.from_param(value)


def type_of(declaration):
    """Of an argument."""
    kind, *rest = re.sub(r"\bconst\b", "", declaration).replace("*", " * ").split()
    if "*" not in rest:
        return SCALARS.get(kind, ctypes.c_void_p)
    return ctypes.c_char_p if kind == "char" else Array(ELEMENTS.get(kind))


def result_of(declaration):
    if "*" in declaration:
        return ctypes.c_char_p if "char" in declaration else ctypes.c_void_p
    return SCALARS.get(declaration.split()[-1], ctypes.c_void_p)


class Names:
    """The commands and tokens of a prefix."""

    def __init__(self, prefix, library):
        self._prefix = prefix
        self._library = ctypes.CDLL(library)

    def __getattr__(self, name):
        token = f"{self._prefix.upper()}_{name}"
        while token in MACROS:
            token = MACROS[token]
        value = int(token, 0) if token[0].isdigit() else self._command(self._prefix + name)
        setattr(self, name, value)
        return value

    def _command(self, name):
        symbol = MACROS.get(name, name)
        result, arguments = PROTOTYPES[symbol]
        command = getattr(extension if symbol in EXTENSION else self._library, symbol)
        command.restype = result_of(result)
        command.argtypes = [type_of(argument) for argument in arguments.split(",")
                            if argument.strip() != "void"]
        if symbol not in EXTENSION:
            return command

        def noted(*values):
            called.add(symbol)
            return command(*values)
        return noted


LIBRARY = BUILD / "api" / "gl" / "libhwffd_gl.so"
extension = ctypes.CDLL(str(LIBRARY))
gl, glu, egl = Names("gl", "libGL.so.1"), Names("glu", "libGL.so.1"), Names("egl", "libEGL.so.1")


def checked(command, *arguments):
    result = command(*arguments)
    if not result:
        raise RuntimeError(f"no OpenGL without a display here ({command.__name__}: EGL error "
                           f"0x{egl.GetError():04X}); install the packages libegl1 and "
                           "libgl1-mesa-dri")
    return result


class Context:
    """A compatibility context without a display (EGL, platform "surfaceless" of Mesa), with a
    buffer to draw to; current until it is closed."""

    def __init__(self):
        self.display = checked(egl.GetPlatformDisplay, egl.PLATFORM_SURFACELESS_MESA, None, None)
        checked(egl.Initialize, self.display, None, None)
        checked(egl.BindAPI, egl.OPENGL_API)
        config, count = np.zeros(1, np.uintp), np.zeros(1, np.int32)
        checked(egl.ChooseConfig, self.display,
                [egl.SURFACE_TYPE, egl.PBUFFER_BIT, egl.RENDERABLE_TYPE, egl.OPENGL_BIT, egl.NONE],
                config, 1, count)
        size = [egl.WIDTH, SIZE, egl.HEIGHT, SIZE, egl.NONE]
        self.surface = checked(egl.CreatePbufferSurface, self.display, int(config[0]), size)
        self.context = checked(egl.CreateContext, self.display, int(config[0]), None, None)
        checked(egl.MakeCurrent, self.display, self.surface, self.surface, self.context)

    def close(self):
        egl.MakeCurrent(self.display, None, None, None)
        egl.DestroyContext(self.display, self.context)
        egl.DestroySurface(self.display, self.surface)


class Seen:
    """Vertices when they reach the rasterizer: in feedback mode, under identity transforms."""

    def __init__(self, rows):
        self.positions = rows[:, :3] * [2 / SIZE, 2 / SIZE, 2] - 1  # in the cube from -1 to 1
        self.colors = rows[:, 3:7]
        self.textures = rows[:, 7:]  # s, t, r, q

    def __len__(self):
        return len(self.positions)


def seen(draw):
    """The vertices that `draw` issues, in their order."""
    buffer = np.zeros(1 << 20, np.float32)
    gl.FeedbackBuffer(buffer.size, getattr(gl, "3D_COLOR_TEXTURE"), buffer)
    gl.RenderMode(gl.FEEDBACK)
    draw()
    used = gl.RenderMode(gl.RENDER)
    if used < 0:
        raise RuntimeError("more vertices than the feedback buffer holds; draw fewer")
    rows = [np.zeros((0, 11))]
    at = 0
    while at < used:
        token = buffer[at]
        is_polygon = token == gl.POLYGON_TOKEN
        count = int(buffer[at + 1]) if is_polygon else 1 if token == gl.POINT_TOKEN else 2
        at += 2 if is_polygon else 1
        rows.append(buffer[at:at + 11 * count].reshape(count, 11))
        at += 11 * count
    return Seen(np.concatenate(rows))


def seen_normals(draw):
    """The same with the normals, in the place of texture coordinates."""
    gl.PushAttrib(gl.TEXTURE_BIT | gl.ENABLE_BIT)
    for axis in (gl.S, gl.T, gl.R):
        gl.TexGeni(axis, gl.TEXTURE_GEN_MODE, gl.NORMAL_MAP)
        gl.Enable(gl.TEXTURE_GEN_S + axis - gl.S)
    # Coordinates are generated only for a texture that is there.
    gl.TexImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE,
                  np.full(4, 255, np.uint8))
    gl.TexParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST)
    gl.Enable(gl.TEXTURE_2D)
    vertices = seen(draw)
    gl.PopAttrib()
    return vertices.textures[:, :3]


def error_of(command, *arguments):
    """What glGetError says after a call, and nothing of what it said before."""
    while gl.GetError() != gl.NO_ERROR:
        pass
    command(*arguments)
    return gl.GetError()


def asked(command, *query, count, element=np.float64):
    """The numbers that a query gives."""
    numbers = np.zeros(count, element)
    command(*query, numbers)
    return numbers.tolist()
