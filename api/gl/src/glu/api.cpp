// The GLU commands: arguments checked in the order of the specification (docs/opengl.md), errors to
// the callback.

#include <exception>
#include <functional>
#include <new>

#include "glu/error.hpp"
#include "glu/renderer.hpp"

namespace hwffd::glu {
namespace {

/// Runs the body of a command; what it throws goes to the callback and spoils the open volume.
void run(GLUffd* ffd, const std::function<void()>& body) {
  if (ffd == nullptr) return;
  try {
    body();
  } catch (const GluError& error) {
    ffd->spoil();
    ffd->report(error.code);
  } catch (const std::exception&) {
    ffd->spoil();
    ffd->report(GLU_FFD_DEVICE_FAILED);
  }
}

/// Rows of `width` numbers.
template <std::size_t width>
std::vector<std::array<float, width>> rows_of(GLsizei count, GLint stride, const GLfloat* from) {
  std::vector<std::array<float, width>> rows(static_cast<std::size_t>(count));
  for (std::array<float, width>& row : rows) {
    std::copy_n(from, width, row.begin());
    from += stride;
  }
  return rows;
}

void check_array(GLsizei count, const void* array) {
  if (count < 0) throw GluError{GLU_FFD_INVALID_VALUE};
  if (array == nullptr) throw GluError{GLU_FFD_NULL_CONTROL};
}

/// The components of a type's control points.
int components_of(GLenum type) {
  static const std::map<GLenum, int> components{
      {GL_MAP3_COLOR_4, 4},         {GL_MAP3_NORMAL, 3},          {GL_MAP3_TEXTURE_COORD_1, 1},
      {GL_MAP3_TEXTURE_COORD_2, 2}, {GL_MAP3_TEXTURE_COORD_3, 3}, {GL_MAP3_TEXTURE_COORD_4, 4},
      {GL_MAP3_VERTEX_3, 3},        {GL_MAP3_VERTEX_4, 4}};
  const auto it = components.find(type);
  if (it == components.end()) throw GluError{GLU_FFD_INVALID_ENUM};
  return it->second;
}

}  // namespace
}  // namespace hwffd::glu

using namespace hwffd::glu;

GLUffd* gluNewFfdRenderer(void) { return new (std::nothrow) GLUffd; }

void gluDeleteFfdRenderer(GLUffd* ffd) { delete ffd; }

void gluFfdProperty(GLUffd* ffd, GLenum property, GLfloat value) {
  run(ffd, [&] { ffd->set_property(property, value); });
}

void gluGetFfdProperty(GLUffd* ffd, GLenum property, GLfloat* value) {
  run(ffd, [&] { *value = ffd->property(property); });
}

void gluFfdDevice(GLUffd* ffd, const char* name) {
  run(ffd, [&] {
    ffd->choose_device(name == nullptr ? std::nullopt : std::optional<std::string>(name));
  });
}

void gluFfdCallback(GLUffd* ffd, GLenum which, GLUffdCallback callback) {
  run(ffd, [&] { ffd->set_callback(which, callback); });
}

void gluFfdCallbackData(GLUffd* ffd, void* data) {
  run(ffd, [&] { ffd->set_data(data); });
}

const char* gluFfdErrorString(GLenum error) { return error_string(error); }

void gluBeginVolume(GLUffd* ffd) {
  run(ffd, [&] { ffd->begin(); });
}

void gluEndVolume(GLUffd* ffd) {
  run(ffd, [&] { ffd->end(); });
}

void gluFfdVolume(GLUffd* ffd, GLsizei count, GLint stride, const GLfloat* coordinates,
                  GLint sknot_count, const GLfloat* sknots, GLint tknot_count,
                  const GLfloat* tknots, GLint uknot_count, const GLfloat* uknots, GLint sstride,
                  GLint tstride, GLint ustride, const GLfloat* control, GLint sorder, GLint torder,
                  GLint uorder, GLenum type) {
  run(ffd, [&] {
    Volume& volume = ffd->volume();
    const int components = components_of(type);
    if (sstride < 0 || tstride < 0 || ustride < 0 || stride < 4) {
      throw GluError{GLU_FFD_INVALID_STRIDE};
    }
    check_array(count, coordinates);
    check_array(count, control);
    std::array<Knots, 3> knots{Knots(sorder, sknot_count, sknots),
                               Knots(torder, tknot_count, tknots),
                               Knots(uorder, uknot_count, uknots)};
    hwffd::gl::ControlGrid grid({knots[0].points(), knots[1].points(), knots[2].points()},
                                components, {sstride, tstride, ustride}, control);
    volume.add(VolumeAttribute(type, std::move(knots), std::move(grid),
                               rows_of<4>(count, stride, coordinates)));
  });
}

void gluFfdNormals(GLUffd* ffd, GLsizei count, GLint stride, const GLfloat* normals) {
  run(ffd, [&] {
    Volume& volume = ffd->volume();
    if (stride < 3) throw GluError{GLU_FFD_INVALID_STRIDE};
    check_array(count, normals);
    hwffd::gl::ControlGrid::Values values(count, 3);
    Eigen::Index row = 0;
    for (const std::array<float, 3>& normal : rows_of<3>(count, stride, normals)) {
      for (int c = 0; c < 3; ++c) values(row, c) = normal[c];
      ++row;
    }
    volume.set_normals(std::move(values));
  });
}

void gluFfdElements(GLUffd* ffd, GLsizei count, const GLuint* vertices) {
  run(ffd, [&] {
    Volume& volume = ffd->volume();
    check_array(count, vertices);
    volume.set_elements({vertices, vertices + count});
  });
}
