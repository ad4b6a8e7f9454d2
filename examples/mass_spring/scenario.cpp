#include "mass_spring/scenario.hpp"

#include <Eigen/Geometry>

#include "hwffd/error.hpp"
#include "mass_spring/mass_spring.hpp"

namespace hwffd::mass_spring {
namespace {

constexpr double kFramesPerSecond = 24;
constexpr int kStepsPerFrame = 64;
constexpr double kAside = 0.45;  // of the lattice's height
constexpr double kUp = 0.10;     // of the lattice's height
constexpr double kRound = 0.30;  // radians

/// Calls f(row) for every point of a layer along t.
template <typename F>
void each_of_layer(const Lattice& lattice, int layer, F f) {
  for (int i = 0; i < lattice.dims()[0]; ++i) {
    for (int k = 0; k < lattice.dims()[2]; ++k) f(lattice.index(i, layer, k));
  }
}

/// Holds the highest layer where it is after a part (0 to 1) of the way.
void pull(MassSpring& body, const Lattice& rest, double part) {
  const int top = rest.dims()[1] - 1;
  const Point low = rest.points().colwise().minCoeff();
  const Point high = rest.points().colwise().maxCoeff();
  const Point middle = (low + high) / 2;
  const Point way = (high.y() - low.y()) * Point(kAside, kUp, 0);
  const Eigen::AngleAxisd turn(part * kRound, Point::UnitY());
  each_of_layer(rest, top, [&](Eigen::Index p) {
    const Point from = rest.points().row(p);
    body.hold(p, middle + turn * (from - middle) + part * way);
  });
}

}  // namespace

std::vector<Frame> pull_and_release(const Lattice& rest, int frames) {
  if (rest.dims()[1] < 5) throw Error("pull and release: 5 points along t are needed; give more");
  if (frames < 4) throw Error("pull and release: 4 frames are needed; give more");
  MassSpring body(rest);
  for (const int layer : {0, 1}) {
    each_of_layer(rest, layer, [&](Eigen::Index p) { body.hold(p, rest.points().row(p)); });
  }
  const int pulled = frames / 4;
  const auto frame = [&](bool released) {
    return Frame{body.lattice(), body.kinetic_energy(), body.elastic_energy(), released};
  };
  std::vector<Frame> film{frame(false)};
  while (static_cast<int>(film.size()) < frames) {
    const int before = static_cast<int>(film.size()) - 1;
    if (before == pulled) {
      each_of_layer(rest, rest.dims()[1] - 1, [&](Eigen::Index p) { body.let_go(p); });
    }
    for (int step = 1; step <= kStepsPerFrame; ++step) {
      const double now = before + static_cast<double>(step) / kStepsPerFrame;
      if (before < pulled) pull(body, rest, now / pulled);
      body.step(1 / (kFramesPerSecond * kStepsPerFrame));
    }
    film.push_back(frame(before >= pulled));
  }
  return film;
}

}  // namespace hwffd::mass_spring
