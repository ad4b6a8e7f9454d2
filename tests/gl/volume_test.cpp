// The GLU renderer: volumes of models, callbacks, properties. Most of it without a context.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "context.hpp"
#include "hwffd/device/device.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "scene.hpp"

namespace hwffd::gltest {
namespace {

/// What callbacks were called with.
struct Log {
  std::vector<std::string> calls;
  std::vector<GLenum> errors;
  std::vector<double> progress;
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Vector3f> normals;
  GLenum primitive = GL_NONE;
};

void set(GLUffd* ffd, GLenum which, void* function) {
  gluFfdCallback(ffd, which, reinterpret_cast<GLUffdCallback>(function));
}

template <class Function>
void* pointer(Function function) {
  return reinterpret_cast<void*>(+function);
}

Log& log_of(void* data) { return *static_cast<Log*>(data); }

/// A renderer whose callbacks write a log.
class Renderer {
 public:
  explicit Renderer(const char* device = "model") {
    gluFfdCallbackData(ffd_, &log);
    set(ffd_, GLU_FFD_ERROR_DATA,
        pointer([](GLenum error, void* d) { log_of(d).errors.push_back(error); }));
    set(ffd_, GLU_FFD_PROGRESS_DATA, pointer([](GLfloat done, void* d) {
          log_of(d).progress.push_back(static_cast<double>(done));
        }));
    set(ffd_, GLU_FFD_BEGIN_DATA, pointer([](GLenum primitive, void* d) {
          log_of(d).primitive = primitive;
          log_of(d).calls.emplace_back("begin");
        }));
    set(ffd_, GLU_FFD_VERTEX_DATA, pointer([](const GLfloat* v, void* d) {
          log_of(d).vertices.emplace_back(v);
          log_of(d).calls.emplace_back("vertex");
        }));
    set(ffd_, GLU_FFD_NORMAL_DATA, pointer([](const GLfloat* n, void* d) {
          log_of(d).normals.emplace_back(n);
          log_of(d).calls.emplace_back("normal");
        }));
    set(ffd_, GLU_FFD_COLOR_DATA,
        pointer([](const GLfloat*, void* d) { log_of(d).calls.emplace_back("color"); }));
    set(ffd_, GLU_FFD_TEXTURE_COORD_DATA,
        pointer([](const GLfloat*, void* d) { log_of(d).calls.emplace_back("texture"); }));
    set(ffd_, GLU_FFD_END_DATA, pointer([](void* d) { log_of(d).calls.emplace_back("end"); }));
    gluFfdProperty(ffd_, GLU_FFD_MODE, GLU_FFD_EVALUATOR);
    gluFfdDevice(ffd_, device);
  }
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  ~Renderer() { gluDeleteFfdRenderer(ffd_); }

  operator GLUffd*() { return ffd_; }
  Log log;

 private:
  GLUffd* ffd_ = gluNewFfdRenderer();
};

/// A deformed lattice and places in it, as gluFfdVolume takes them.
struct Model {
  Lattice lattice;
  std::vector<Embedded> places;
  std::vector<GLfloat> coordinates;
  std::vector<GLfloat> control;

  Model(Lattice deformed, std::vector<Embedded> embedded)
      : lattice(std::move(deformed)), places(std::move(embedded)) {
    for (Embedded& at : places) {
      for (double& coordinate : at.local) {
        coordinates.push_back(static_cast<GLfloat>(coordinate));
        coordinate = static_cast<double>(coordinates.back());
      }
      coordinates.push_back(
          static_cast<GLfloat>(lattice.index(at.cell[0], at.cell[1], at.cell[2])));
    }
    Points rounded = lattice.points();
    for (double& value : rounded.reshaped<Eigen::RowMajor>()) {
      control.push_back(static_cast<GLfloat>(value));
      value = static_cast<double>(control.back());
    }
    lattice = Lattice(lattice.dims(), rounded);
  }

  void give(GLUffd* ffd, GLenum type = GL_MAP3_VERTEX_3) const {
    const auto& [ns, nt, nu] = lattice.dims();
    gluFfdVolume(ffd, static_cast<GLsizei>(places.size()), 4, coordinates.data(), ns + 4, nullptr,
                 nt + 4, nullptr, nu + 4, nullptr, nt * nu * 3, nu * 3, 3, control.data(), 4, 4, 4,
                 type);
  }

  /// A volume of the model and of what `more` gives beside it.
  void draw(
      GLUffd* ffd, const std::function<void()>& more = [] {}) const {
    gluBeginVolume(ffd);
    give(ffd);
    more();
    gluEndVolume(ffd);
  }
  void draw_with_normals(GLUffd* ffd, const std::vector<GLfloat>& normals) const {
    draw(ffd, [&] { gluFfdNormals(ffd, static_cast<GLsizei>(places.size()), 3, normals.data()); });
  }
};

Model knot_model(const Index3& dims, const char* deformation) {
  const Points points = Mesh::procedural().positions();
  const Box box = Box::around(points);
  return {Deformation::parse(deformation).apply(box.lattice(dims)), box.embed(dims, points)};
}

TEST(Volume, VerticesOfAMeshAreThoseOfTheDevice) {
  int compared = 0;
  const Model model = knot_model({5, 4, 6}, "twist:90");
  for (const auto& [name, choice] :
       {std::pair("model:basic:fp32", DeviceChoice{"model", "basic", "fp32"}),
        std::pair("model:parallel:fx18", DeviceChoice{"model", "parallel", "fx18"}),
        std::pair("rtl:basic:fx18", DeviceChoice{"rtl", "basic", "fx18"}),
        std::pair("reference", DeviceChoice{"reference", "", ""})}) {
    Renderer renderer(name);
    model.draw(renderer);
    EXPECT_TRUE(renderer.log.errors.empty()) << name;
    const Points expected = make_device(choice)->evaluate(model.lattice, model.places);
    ASSERT_EQ(renderer.log.vertices.size(), model.places.size()) << name;
    for (std::size_t v = 0; v < model.places.size(); ++v, ++compared) {
      const Eigen::Vector3f here =
          expected.row(static_cast<Eigen::Index>(v)).transpose().cast<float>();
      EXPECT_EQ(renderer.log.vertices[v], here) << name << " " << v;
    }
  }
  EXPECT_EQ(compared, 4 * 3072);
}

TEST(Volume, ProgressRisesToOneOnEveryDevice) {
  const Model model = knot_model({4, 4, 4}, "bend:90");
  std::vector<GLfloat> normals(3 * model.places.size(), 1.0F);
  for (const char* device : {"model", "rtl:basic:fx18", "reference"}) {
    Renderer renderer(device);
    model.draw_with_normals(renderer, normals);
    const std::vector<double>& progress = renderer.log.progress;
    ASSERT_FALSE(progress.empty()) << device;
    EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end())) << device;
    EXPECT_EQ(progress.back(), 1) << device;
    EXPECT_EQ(std::count(progress.begin(), progress.end(), 1.0), 1) << device;
    if (device != std::string("reference")) {
      EXPECT_GT(progress.size(), 150U) << device;  // two passes, about a hundred steps each
      EXPECT_LT(progress.front(), 0.01) << device;
    }
  }
}

TEST(Volume, AttributesComeBeforeTheVertexAndElementsGiveTheOrder) {
  Renderer renderer;
  const Model model = knot_model({4, 4, 4}, "none");
  const GLuint elements[] = {5, 3, 5};
  std::vector<GLfloat> four(4 * model.control.size(), 0.5F);
  gluFfdProperty(renderer, GLU_FFD_PRIMITIVE, GL_LINE_STRIP);
  gluBeginVolume(renderer);
  model.give(renderer);
  const auto count = static_cast<GLsizei>(model.places.size());
  for (const GLenum type : {GL_MAP3_TEXTURE_COORD_2, GL_MAP3_COLOR_4, GL_MAP3_NORMAL}) {
    gluFfdVolume(renderer, count, 4, model.coordinates.data(), 8, nullptr, 8, nullptr, 8, nullptr,
                 64, 16, 4, four.data(), 4, 4, 4, type);
  }
  gluFfdElements(renderer, 3, elements);
  gluEndVolume(renderer);
  std::vector<std::string> expected{"begin"};
  for (int v = 0; v < 3; ++v) {
    for (const char* call : {"color", "normal", "texture", "vertex"}) expected.emplace_back(call);
  }
  expected.emplace_back("end");
  EXPECT_EQ(renderer.log.calls, expected);
  EXPECT_EQ(renderer.log.primitive, GLenum{GL_LINE_STRIP});
  ASSERT_EQ(renderer.log.vertices.size(), 3U);
  EXPECT_EQ(renderer.log.vertices[0], renderer.log.vertices[2]);
  EXPECT_NE(renderer.log.vertices[0], renderer.log.vertices[1]);
}

TEST(Volume, NormalsAreThoseOfTheInverseJacobian) {
  const Model model = knot_model({5, 5, 4}, "random:3");
  tb::Random random(5);
  std::vector<GLfloat> normals;
  for (std::size_t number = 0; number < 3 * model.places.size(); ++number) {
    normals.push_back(static_cast<GLfloat>(uniform(random, -1, 1)));
  }
  for (const auto& [device, tolerance] :
       {std::pair("reference", 1e-5), std::pair("model", 1e-4), std::pair("model:basic:fx32", 1e-4),
        std::pair("model:basic:fx18", 3e-2)}) {
    Renderer renderer(device);
    model.draw_with_normals(renderer, normals);
    ASSERT_EQ(renderer.log.normals.size(), model.places.size());
    for (std::size_t v = 0; v < model.places.size(); ++v) {
      const Embedded& at = model.places[v];
      const Eigen::Matrix3d jacobian =
          Oracle().jet(model.lattice.support(at.cell), at.local).jacobian;
      const Eigen::RowVector3f given(&normals[3 * v]);
      const Eigen::RowVector3d expected = given.cast<double>() * jacobian.inverse();
      EXPECT_LT((renderer.log.normals[v].transpose().cast<double>() - expected).norm(),
                tolerance * expected.norm())
          << device << " " << v;
    }
  }
}

/// The B-spline number `i` of a degree at t, by its recurrence.
double bspline(const std::vector<GLfloat>& knots, std::size_t i, int degree, double t) {
  if (degree == 0) return t >= knots[i] && t < knots[i + 1] ? 1 : 0;
  const auto d = static_cast<std::size_t>(degree);
  double sum = 0;
  if (knots[i + d] > knots[i]) {
    sum += (t - knots[i]) / (knots[i + d] - knots[i]) * bspline(knots, i, degree - 1, t);
  }
  if (knots[i + d + 1] > knots[i + 1]) {
    sum += (knots[i + d + 1] - t) / (knots[i + d + 1] - knots[i + 1]) *
           bspline(knots, i + 1, degree - 1, t);
  }
  return sum;
}

TEST(Volume, KnotsOfAnyKind) {
  const std::vector<GLfloat> s{0, 0, 0, 0, 1, 1.5F, 4, 4, 4, 4};  // order 4, 6 points
  const std::vector<GLfloat> t{-3, -2, 0, 0.5F, 0.5F, 2};         // order 3, 3 points
  const std::vector<GLfloat> u{0, 1, 3, 3.25F, 7};                // order 2, 3 points
  tb::Random random(9);
  std::vector<GLfloat> control(6 * 3 * 3 * 3);
  for (GLfloat& value : control) value = static_cast<GLfloat>(uniform(random, -1, 1));
  std::vector<GLfloat> coordinates;
  std::vector<Eigen::Vector3d> expected;
  for (int vertex = 0; vertex < 60; ++vertex) {
    const Index3 cell{vertex % 3, 0, vertex / 3 % 2};
    Eigen::Vector3d at;
    const std::size_t span[3] = {static_cast<std::size_t>(cell[0] + 3), 2,
                                 static_cast<std::size_t>(cell[2] + 1)};
    const std::vector<GLfloat>* const knots[3] = {&s, &t, &u};
    for (int axis = 0; axis < 3; ++axis) {
      coordinates.push_back(static_cast<GLfloat>(random.unit()));
      const double first = (*knots[axis])[span[axis]];
      at[axis] = first + coordinates.back() * ((*knots[axis])[span[axis] + 1] - first);
    }
    coordinates.push_back(static_cast<GLfloat>((cell[0] * 3 + cell[1]) * 3 + cell[2]));
    Eigen::Vector3d& sum = expected.emplace_back(0, 0, 0);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t k = 0; k < 3; ++k) {
          const Eigen::Vector3f point(&control[((i * 3 + j) * 3 + k) * 3]);
          sum += bspline(s, i, 3, at[0]) * bspline(t, j, 2, at[1]) * bspline(u, k, 1, at[2]) *
                 point.cast<double>();
        }
      }
    }
  }
  Renderer renderer;
  gluBeginVolume(renderer);
  gluFfdVolume(renderer, 60, 4, coordinates.data(), 10, s.data(), 6, t.data(), 5, u.data(), 27, 9,
               3, control.data(), 4, 3, 2, GL_MAP3_VERTEX_3);
  gluEndVolume(renderer);
  EXPECT_TRUE(renderer.log.errors.empty());
  ASSERT_EQ(renderer.log.vertices.size(), expected.size());
  for (std::size_t v = 0; v < expected.size(); ++v) {
    EXPECT_LT((renderer.log.vertices[v].cast<double>() - expected[v]).norm(), 1e-5) << v;
  }
}

TEST(Volume, ACallThatFailsSpoilsItsVolumeAlone) {
  Renderer renderer;
  const Model model = knot_model({4, 4, 4}, "none");
  model.draw(renderer, [&] { gluFfdElements(renderer, -1, nullptr); });
  EXPECT_EQ(renderer.log.errors, std::vector<GLenum>{GLU_FFD_INVALID_VALUE});
  EXPECT_TRUE(renderer.log.vertices.empty());
  model.draw(renderer);
  EXPECT_EQ(renderer.log.errors.size(), 1U);
  EXPECT_EQ(renderer.log.vertices.size(), model.places.size());
}

TEST(Volume, CallbacksWithoutDataAreCalledWhereNoneWithDataIs) {
  static int plain = 0;
  Renderer renderer;
  set(renderer, GLU_FFD_BEGIN, pointer([](GLenum) { ++plain; }));
  set(renderer, GLU_FFD_END, pointer([] { ++plain; }));
  set(renderer, GLU_FFD_END_DATA, nullptr);
  const Model model = knot_model({4, 4, 4}, "none");
  model.draw(renderer);
  EXPECT_EQ(plain, 1);
  EXPECT_EQ(renderer.log.calls.front(), "begin");
  EXPECT_EQ(renderer.log.calls.back(), "vertex");
}

TEST(Properties, DefaultsAndValues) {
  GLUffd* ffd = gluNewFfdRenderer();
  const std::vector<std::array<GLfloat, 3>> rows{
      // property, initial value, another
      {GLU_FFD_MODE, GLU_FFD_RENDERER, GLU_FFD_EVALUATOR},
      {GLU_FFD_PRIMITIVE, GL_TRIANGLES, GL_POINTS},
      {GLU_FFD_DISPLAY_MODE, GL_FILL, GL_LINE},
      {GLU_FFD_LINE_WIDTH, 1, 2.5F},
      {GLU_FFD_POINT_SIZE, 1, 4},
      {GLU_FFD_DEVICE, GLU_FFD_MODEL, GLU_FFD_REFERENCE}};
  for (const auto& [property, initial, other] : rows) {
    const auto name = static_cast<GLenum>(property);
    GLfloat value = -1;
    gluGetFfdProperty(ffd, name, &value);
    EXPECT_EQ(value, initial) << name;
    gluFfdProperty(ffd, name, other);
    gluGetFfdProperty(ffd, name, &value);
    EXPECT_EQ(value, other) << name;
  }
  gluFfdDevice(ffd, "rtl:basic:fx18");
  GLfloat device = 0;
  gluGetFfdProperty(ffd, GLU_FFD_DEVICE, &device);
  EXPECT_EQ(device, static_cast<GLfloat>(GLU_FFD_RTL));
  gluDeleteFfdRenderer(ffd);
  gluDeleteFfdRenderer(nullptr);
}

TEST(Drawing, GoesToTheContextInTheDisplayMode) {
  const glapi::Context context;
  Renderer renderer;
  const Model knot = knot_model({4, 4, 4}, "twist:45");
  const Model model(Lattice(knot.lattice.dims(), knot.lattice.points() / 8), knot.places);
  const GLuint elements[] = {0, 100, 2000, 7, 8, 9};
  const auto draw = [&] { model.draw(renderer, [&] { gluFfdElements(renderer, 6, elements); }); };
  draw();
  ASSERT_EQ(renderer.log.vertices.size(), 6U);
  gluFfdProperty(renderer, GLU_FFD_MODE, GLU_FFD_RENDERER);
  GLint modes[2];
  for (const auto& [mode, count] :
       {std::pair(GL_FILL, 6U), std::pair(GL_LINE, 12U), std::pair(GL_POINT, 6U)}) {
    gluFfdProperty(renderer, GLU_FFD_DISPLAY_MODE, static_cast<GLfloat>(mode));
    const std::vector<glapi::Seen> seen = glapi::seen(draw);
    ASSERT_EQ(seen.size(), count) << mode;
    for (std::size_t v = 0; mode != GL_LINE && v < seen.size(); ++v) {
      EXPECT_LT((seen[v].position - renderer.log.vertices[v].cast<double>()).norm(), 1e-5);
    }
    glGetIntegerv(GL_POLYGON_MODE, modes);
    EXPECT_EQ(modes[0], GL_FILL) << "left behind";
  }
  EXPECT_EQ(renderer.log.calls.size(), 8U) << "callbacks while drawing";
  EXPECT_TRUE(renderer.log.errors.empty());
}

}  // namespace
}  // namespace hwffd::gltest
