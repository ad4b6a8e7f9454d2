#pragma once

#include <functional>
#include <vector>

#include "control_grid.hpp"
#include "opengl.hpp"

namespace hwffd::gl {

/// Vertices with their attributes, on their way to the current context.
class VertexBatch {
 public:
  /// One attribute: `size` numbers a vertex, none if the vertices do not have it.
  struct Attribute {
    int size = 0;
    std::vector<GLfloat> values;

    Attribute() = default;
    explicit Attribute(const ControlGrid::Values& from);
    const GLfloat* of(std::size_t vertex) const { return values.data() + vertex * size; }
  };

  Attribute color;      ///< 4
  Attribute index;      ///< 1
  Attribute normal;     ///< 3
  Attribute tex_coord;  ///< 1 to 4
  Attribute vertex;     ///< 3 or 4

  /// Vertices by their numbers, a primitive each.
  using Primitives = std::vector<std::vector<GLuint>>;

  /// Issues one vertex by immediate mode calls, legal between glBegin and glEnd: attributes first,
  /// the vertex last, as glEvalCoord does.
  void issue(std::size_t number) const;

  /// Draws through vertex buffers and leaves the context's state as it was. Where the context's
  /// stacks of attributes are full it raises GL_STACK_OVERFLOW and draws nothing.
  /// @param attributes  groups of attributes that `set` changes for the draw
  void draw(GLenum mode, const Primitives& primitives, GLbitfield attributes = 0,
            const std::function<void()>& set = nullptr) const;
};

}  // namespace hwffd::gl
