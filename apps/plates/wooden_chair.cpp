#include <algorithm>

#include "plates/chairs.hpp"
#include "plates/solids.hpp"

namespace hwffd::plates {
namespace {

using Parts = std::vector<Mesh::Part>;

const Stuff kWood{"wood", {0.62f, 0.40f, 0.22f}, 0.02};
const Stuff kSeat{"seat", {0.74f, 0.53f, 0.32f}, 0.02};

constexpr double kSeatHeight = 0.45;

void add_legs(Parts& parts, double side) {
  parts.push_back(tube(kWood, {{{side * 0.205, 0.006, 0.205}, 0.014},
                               {{side * 0.180, kSeatHeight - 0.02, 0.175}, 0.021}}));
  // The hind legs go on as the posts of the back.
  parts.push_back(curved_tube(kWood, {{{side * 0.205, 0.006, -0.235}, 0.014},
                                      {{side * 0.185, 0.25, -0.195}, 0.019},
                                      {{side * 0.175, kSeatHeight, -0.180}, 0.021},
                                      {{side * 0.180, 0.70, -0.200}, 0.018},
                                      {{side * 0.190, 0.94, -0.255}, 0.014}}));
  parts.push_back(
      tube(kWood, {{{side * 0.196, 0.17, 0.195}, 0.010}, {{side * 0.191, 0.17, -0.208}, 0.010}}));
}

void add_rails(Parts& parts) {
  parts.push_back(tube(kWood, {{{-0.194, 0.17, 0.0}, 0.010}, {{0.194, 0.17, 0.0}, 0.010}}));
  parts.push_back(tube(kWood, {{{-0.190, 0.26, 0.187}, 0.010}, {{0.190, 0.26, 0.187}, 0.010}}));
  const auto bowed = [](const Point& p) -> Point {
    return {p.x(), p.y(), p.z() - 0.045 + 1.25 * p.x() * p.x()};
  };
  parts.push_back(
      moved(rounded_box(kWood, Point(0, 0.885, -0.240), Point(0.190, 0.045, 0.011), 0.010), bowed));
  parts.push_back(
      moved(rounded_box(kWood, Point(0, 0.575, -0.188), Point(0.178, 0.020, 0.010), 0.009), bowed));
  for (const double x : {-0.105, -0.035, 0.035, 0.105}) {
    parts.push_back(tube(kWood, {{bowed({x, 0.575, -0.188}), 0.008},
                                 {bowed({x, 0.72, -0.210}), 0.010},
                                 {bowed({x, 0.86, -0.235}), 0.008}}));
  }
}

}  // namespace

Mesh wooden_chair() {
  Parts parts;
  for (const double side : {-1.0, 1.0}) add_legs(parts, side);
  add_rails(parts);
  // Narrower behind, hollow in the middle.
  const auto saddle = [](const Point& p) -> Point {
    const double hollow = std::max(0.0, 1 - 25 * p.x() * p.x() - 25 * p.z() * p.z());
    const double above = p.y() > kSeatHeight ? 0.012 : 0.0;
    return {p.x() * (1 + 0.25 * p.z()), p.y() - above * hollow, p.z()};
  };
  parts.push_back(moved(
      rounded_box(kSeat, Point(0, kSeatHeight, 0.0), Point(0.225, 0.018, 0.220), 0.016), saddle));
  return Mesh::build("wooden-chair", parts);
}

}  // namespace hwffd::plates
