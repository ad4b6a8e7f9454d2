#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "glu/volume.hpp"
#include "hwffd/glffd.h"

/// The renderer behind GLUffd: properties, callbacks, a device, and the volume that is open.
struct GLUffd {
 public:
  GLUffd();

  /// @throws GluError for an unknown property or a value that it does not take
  void set_property(GLenum property, float value);
  float property(GLenum property) const;
  /// @throws GluError if there is no such device
  void choose_device(const std::optional<std::string>& name);

  /// @throws GluError if there is no such callback
  void set_callback(GLenum which, GLUffdCallback callback);
  void set_data(void* data) { data_ = data; }
  void report(GLenum error) const;

  /// @throws GluError if a volume is open
  void begin();
  /// @throws GluError if none is
  hwffd::glu::Volume& volume();
  /// Closes the volume, evaluates it and draws it or calls back.
  /// @throws GluError
  void end();
  /// What a failed call does to the volume that is open.
  void spoil();

 private:
  /// Calls a callback with the user's data if it wants them.
  template <class... Arguments>
  void call(GLenum which, Arguments... arguments) const;
  hwffd::Device& device();
  void draw(const hwffd::gl::VertexBatch& batch, const std::vector<GLuint>& elements) const;
  void call_back(const hwffd::gl::VertexBatch& batch, const std::vector<GLuint>& elements) const;

  std::map<GLenum, float> properties_;
  std::map<GLenum, GLUffdCallback> callbacks_;
  void* data_ = nullptr;
  std::unique_ptr<hwffd::Device> device_;
  std::optional<hwffd::glu::Volume> volume_;
};
