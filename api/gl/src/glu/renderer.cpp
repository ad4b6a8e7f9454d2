#include "glu/renderer.hpp"

#include "device_name.hpp"
#include "glu/error.hpp"
#include "hwffd/error.hpp"

using hwffd::Device;
using hwffd::glu::GluError;
using hwffd::glu::Volume;

namespace {

constexpr GLenum kData =
    GLU_FFD_ERROR_DATA - GLU_FFD_ERROR;  // from a callback to the one with data

bool is_one_of(float value, std::initializer_list<GLenum> tokens) {
  for (const GLenum token : tokens) {
    if (value == static_cast<float>(token)) return true;
  }
  return false;
}

bool takes(GLenum property, float value) {
  switch (property) {
    case GLU_FFD_MODE:
      return is_one_of(value, {GLU_FFD_RENDERER, GLU_FFD_EVALUATOR});
    case GLU_FFD_PRIMITIVE:
      return is_one_of(
          value, {GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP,
                  GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON});
    case GLU_FFD_DISPLAY_MODE:
      return is_one_of(value, {GL_POINT, GL_LINE, GL_FILL});
    case GLU_FFD_DEVICE:
      return is_one_of(value, {GLU_FFD_MODEL, GLU_FFD_RTL, GLU_FFD_REFERENCE});
    default:
      return value > 0;  // widths and sizes
  }
}

GLenum token_of(const std::string& kind) {
  if (kind == "rtl") return GLU_FFD_RTL;
  return kind == "reference" ? GLU_FFD_REFERENCE : GLU_FFD_MODEL;
}

const char* kind_of(float token) {
  if (token == static_cast<float>(GLU_FFD_RTL)) return "rtl";
  return token == static_cast<float>(GLU_FFD_REFERENCE) ? "reference" : "model";
}

}  // namespace

GLUffd::GLUffd()
    : properties_{{GLU_FFD_MODE, static_cast<float>(GLU_FFD_RENDERER)},
                  {GLU_FFD_PRIMITIVE, static_cast<float>(GL_TRIANGLES)},
                  {GLU_FFD_DISPLAY_MODE, static_cast<float>(GL_FILL)},
                  {GLU_FFD_LINE_WIDTH, 1.0F},
                  {GLU_FFD_POINT_SIZE, 1.0F},
                  {GLU_FFD_DEVICE, static_cast<float>(GLU_FFD_MODEL)}} {}

void GLUffd::set_property(GLenum property, float value) {
  const auto it = properties_.find(property);
  if (it == properties_.end()) throw GluError{GLU_FFD_INVALID_ENUM};
  if (!takes(property, value)) throw GluError{GLU_FFD_INVALID_VALUE};
  if (property == GLU_FFD_DEVICE) return choose_device(kind_of(value));
  it->second = value;
}

float GLUffd::property(GLenum property) const {
  const auto it = properties_.find(property);
  if (it == properties_.end()) throw GluError{GLU_FFD_INVALID_ENUM};
  return it->second;
}

void GLUffd::choose_device(const std::optional<std::string>& name) {
  try {
    const hwffd::DeviceChoice choice =
        name ? hwffd::gl::parse_device(*name) : hwffd::gl::device_of_environment();
    device_ = hwffd::make_device(choice);
    properties_[GLU_FFD_DEVICE] = static_cast<float>(token_of(choice.device));
  } catch (const hwffd::Error&) {
    throw GluError{GLU_FFD_DEVICE_FAILED};
  }
}

Device& GLUffd::device() {
  if (device_ == nullptr) choose_device(std::nullopt);
  return *device_;
}

void GLUffd::set_callback(GLenum which, GLUffdCallback callback) {
  const bool is_plain = which >= GLU_FFD_ERROR && which <= GLU_FFD_END;
  const bool is_with_data = which >= GLU_FFD_ERROR_DATA && which <= GLU_FFD_END_DATA;
  if (!is_plain && !is_with_data) throw GluError{GLU_FFD_INVALID_ENUM};
  callbacks_[which] = callback;
}

template <class... Arguments>
void GLUffd::call(GLenum which, Arguments... arguments) const {
  const auto callback_of = [this](GLenum number) {
    const auto it = callbacks_.find(number);
    return it == callbacks_.end() ? nullptr : it->second;
  };
  if (GLUffdCallback with_data = callback_of(which + kData)) {
    reinterpret_cast<void (*)(Arguments..., void*)>(with_data)(arguments..., data_);
  } else if (GLUffdCallback plain = callback_of(which)) {
    reinterpret_cast<void (*)(Arguments...)>(plain)(arguments...);
  }
}

void GLUffd::report(GLenum error) const { call(GLU_FFD_ERROR, error); }

void GLUffd::begin() {
  if (volume_) throw GluError{GLU_FFD_NESTED_VOLUME};
  volume_.emplace();
}

Volume& GLUffd::volume() {
  if (!volume_) throw GluError{GLU_FFD_MISSING_BEGIN};
  return *volume_;
}

void GLUffd::spoil() {
  if (volume_) volume_->spoil();
}

void GLUffd::end() {
  const Volume closed = std::move(volume());
  volume_.reset();
  if (closed.is_spoilt()) return;
  closed.check();
  double shown = -1;
  const auto progress = [&](double done) {
    shown = done;
    call(GLU_FFD_PROGRESS, static_cast<GLfloat>(done));
  };
  const hwffd::gl::VertexBatch batch = closed.evaluate(device(), progress);
  if (shown < 1) progress(1);
  if (properties_[GLU_FFD_MODE] == static_cast<float>(GLU_FFD_EVALUATOR)) {
    call_back(batch, closed.elements());
  } else {
    draw(batch, closed.elements());
  }
}

void GLUffd::draw(const hwffd::gl::VertexBatch& batch, const std::vector<GLuint>& elements) const {
  batch.draw(static_cast<GLenum>(property(GLU_FFD_PRIMITIVE)), {elements},
             GL_LINE_BIT | GL_POINT_BIT | GL_POLYGON_BIT, [this] {
               glLineWidth(property(GLU_FFD_LINE_WIDTH));
               glPointSize(property(GLU_FFD_POINT_SIZE));
               glPolygonMode(GL_FRONT_AND_BACK,
                             static_cast<GLenum>(property(GLU_FFD_DISPLAY_MODE)));
             });
}

void GLUffd::call_back(const hwffd::gl::VertexBatch& batch,
                       const std::vector<GLuint>& elements) const {
  call(GLU_FFD_BEGIN, static_cast<GLenum>(property(GLU_FFD_PRIMITIVE)));
  for (const GLuint vertex : elements) {
    if (batch.color.size > 0) call(GLU_FFD_COLOR, batch.color.of(vertex));
    if (batch.normal.size > 0) call(GLU_FFD_NORMAL, batch.normal.of(vertex));
    if (batch.tex_coord.size > 0) call(GLU_FFD_TEXTURE_COORD, batch.tex_coord.of(vertex));
    call(GLU_FFD_VERTEX, batch.vertex.of(vertex));
  }
  call(GLU_FFD_END);
}
