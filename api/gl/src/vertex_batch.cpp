#include "vertex_batch.hpp"

#include <cstdint>

namespace hwffd::gl {
namespace {

bool has_room(GLenum depth, GLenum most) {
  GLint used = 0;
  GLint all = 0;
  glGetIntegerv(depth, &used);
  glGetIntegerv(most, &all);
  return used < all;
}

/// Whether OpenGL's stacks take what a draw pushes; else raises GL_STACK_OVERFLOW.
bool stacks_have_room() {
  if (!has_room(GL_ATTRIB_STACK_DEPTH, GL_MAX_ATTRIB_STACK_DEPTH)) {
    glPushAttrib(0);
    return false;
  }
  if (!has_room(GL_CLIENT_ATTRIB_STACK_DEPTH, GL_MAX_CLIENT_ATTRIB_STACK_DEPTH)) {
    glPushClientAttrib(0);
    return false;
  }
  return true;
}

/// Whether a program's primitive restart (OpenGL 3.1) takes a vertex for the end of a primitive.
bool restarts() {
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  return (major > 3 || (major == 3 && minor > 0)) && glIsEnabled(GL_PRIMITIVE_RESTART) == GL_TRUE;
}

/// State, vertex array and buffer of one draw; the context gets its own back afterwards.
class Buffers {
 public:
  Buffers(std::size_t numbers, GLbitfield attributes) : restarts_(restarts()) {
    if (restarts_) glDisable(GL_PRIMITIVE_RESTART);
    glPushAttrib(GL_CURRENT_BIT | attributes);
    glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
    glGenBuffers(1, &buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers * sizeof(GLfloat)), nullptr,
                 GL_STREAM_DRAW);
    glClientActiveTexture(GL_TEXTURE0);  // where evaluators' texture coordinates go
  }
  Buffers(const Buffers&) = delete;
  Buffers& operator=(const Buffers&) = delete;
  ~Buffers() {
    glPopClientAttrib();
    glPopAttrib();
    if (restarts_) glEnable(GL_PRIMITIVE_RESTART);
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(1, &buffer_);
  }

  /// Puts an attribute behind the last one and has `point_at` (size, its place) find it.
  template <class PointAt>
  void add(GLenum client_state, const VertexBatch::Attribute& attribute, PointAt point_at) {
    if (attribute.size == 0) return;
    const std::size_t bytes = attribute.values.size() * sizeof(GLfloat);
    glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(used_), static_cast<GLsizeiptr>(bytes),
                    attribute.values.data());
    glEnableClientState(client_state);
    const char* const start = nullptr;  // of the buffer, as OpenGL has it
    point_at(attribute.size, start + used_);
    used_ += bytes;
  }

 private:
  bool restarts_;
  GLuint array_ = 0;
  GLuint buffer_ = 0;
  std::uintptr_t used_ = 0;
};

}  // namespace

VertexBatch::Attribute::Attribute(const ControlGrid::Values& from)
    : size(static_cast<int>(from.cols())) {
  values.reserve(static_cast<std::size_t>(from.size()));
  for (Eigen::Index row = 0; row < from.rows(); ++row) {
    for (Eigen::Index c = 0; c < from.cols(); ++c) {
      values.push_back(static_cast<GLfloat>(from(row, c)));
    }
  }
}

void VertexBatch::issue(std::size_t number) const {
  if (color.size > 0) glColor4fv(color.of(number));
  if (index.size > 0) glIndexfv(index.of(number));
  if (normal.size > 0) glNormal3fv(normal.of(number));
  using Call = void (*)(const GLfloat*);
  static constexpr Call kTexCoord[] = {glTexCoord1fv, glTexCoord2fv, glTexCoord3fv, glTexCoord4fv};
  if (tex_coord.size > 0) kTexCoord[tex_coord.size - 1](tex_coord.of(number));
  if (vertex.size == 3) glVertex3fv(vertex.of(number));
  if (vertex.size == 4) glVertex4fv(vertex.of(number));
}

void VertexBatch::draw(GLenum mode, const Primitives& primitives, GLbitfield attributes,
                       const std::function<void()>& set) const {
  if (!stacks_have_room()) return;
  Buffers buffers(color.values.size() + index.values.size() + normal.values.size() +
                      tex_coord.values.size() + vertex.values.size(),
                  attributes);
  if (set) set();
  buffers.add(GL_COLOR_ARRAY, color,
              [](int size, const void* at) { glColorPointer(size, GL_FLOAT, 0, at); });
  buffers.add(GL_INDEX_ARRAY, index, [](int, const void* at) { glIndexPointer(GL_FLOAT, 0, at); });
  buffers.add(GL_NORMAL_ARRAY, normal,
              [](int, const void* at) { glNormalPointer(GL_FLOAT, 0, at); });
  buffers.add(GL_TEXTURE_COORD_ARRAY, tex_coord,
              [](int size, const void* at) { glTexCoordPointer(size, GL_FLOAT, 0, at); });
  buffers.add(GL_VERTEX_ARRAY, vertex,
              [](int size, const void* at) { glVertexPointer(size, GL_FLOAT, 0, at); });
  for (const std::vector<GLuint>& primitive : primitives) {
    glDrawElements(mode, static_cast<GLsizei>(primitive.size()), GL_UNSIGNED_INT, primitive.data());
  }
}

}  // namespace hwffd::gl
