#include <Eigen/Geometry>
#include <cmath>

#include "plates/chairs.hpp"
#include "plates/solids.hpp"

namespace hwffd::plates {
namespace {

using Parts = std::vector<Mesh::Part>;

constexpr double kPi = 3.14159265358979323846;
constexpr int kArms = 5;
constexpr double kReach = 0.30;   // from the stem to a castor
constexpr double kWheel = 0.030;  // radius

const Stuff kFabric{"fabric", {0.17f, 0.34f, 0.50f}, 0.025};
const Stuff kPlastic{"plastic", {0.20f, 0.21f, 0.23f}, 0.02};
const Stuff kMetal{"metal", {0.66f, 0.68f, 0.71f}, 0.015};
const Stuff kRubber{"rubber", {0.13f, 0.13f, 0.14f}, 0.01};

/// An arm along x with its castor, turned about the stem.
void add_arm(Parts& parts, double angle) {
  const Eigen::AngleAxisd turn(angle, Point::UnitY());
  const auto turned = [&](const Point& p) -> Point { return turn * p; };
  parts.push_back(moved(curved_tube(kPlastic, {{{0, 0.115, 0}, 0.028},
                                               {{0.12, 0.112, 0}, 0.024},
                                               {{0.24, 0.096, 0}, 0.019},
                                               {{kReach, 0.084, 0}, 0.017}}),
                        turned));
  parts.push_back(
      moved(tube(kMetal, {{{kReach, 0.088, 0}, 0.008}, {{kReach, 0.045, 0}, 0.008}}), turned));
  // Castors trail: their wheels stand off the arm's line, each at an angle of its own.
  const Eigen::AngleAxisd trail(angle * 2.3 + 0.6, Point::UnitY());
  const auto castor = [&](const Point& p) -> Point {
    return turned(trail * p + Point(kReach, 0, 0));
  };
  parts.push_back(moved(
      rounded_box(kPlastic, Point(0.008, 0.050, 0), Point(0.022, 0.012, 0.006), 0.005), castor));
  for (const double side : {-1.0, 1.0}) {
    parts.push_back(moved(tube(kRubber, {{{0.012, kWheel, side * 0.011}, kWheel},
                                         {{0.012, kWheel, side * 0.022}, kWheel}}),
                          castor));
  }
}

/// A telescope of three pipes.
void add_stem(Parts& parts) {
  parts.push_back(tube(kPlastic, {{{0, 0.085, 0}, 0.045}, {{0, 0.140, 0}, 0.042}}));
  parts.push_back(tube(kPlastic, {{{0, 0.14, 0}, 0.030}, {{0, 0.25, 0}, 0.030}}));
  parts.push_back(tube(kPlastic, {{{0, 0.25, 0}, 0.024}, {{0, 0.33, 0}, 0.024}}));
  parts.push_back(tube(kMetal, {{{0, 0.33, 0}, 0.016}, {{0, kOfficeStemTop - 0.006, 0}, 0.016}}));
}

void add_seat(Parts& parts) {
  parts.push_back(rounded_box(kPlastic, Point(0, 0.447, -0.01), Point(0.13, 0.017, 0.13), 0.012));
  const auto hollow = [](const Point& p) -> Point {
    return {p.x(), p.y() + 0.35 * p.x() * p.x() - 1.2 * std::pow(std::max(0.0, p.z() - 0.1), 2),
            p.z()};
  };
  parts.push_back(moved(
      rounded_box(kFabric, Point(0, 0.497, 0.01), Point(0.245, 0.036, 0.235), 0.034), hollow));
}

void add_back(Parts& parts) {
  parts.push_back(curved_tube(kPlastic, {{{0, 0.450, -0.10}, 0.018},
                                         {{0, 0.450, -0.20}, 0.018},
                                         {{0, 0.470, -0.285}, 0.018},
                                         {{0, 0.580, -0.315}, 0.018},
                                         {{0, 0.760, -0.318}, 0.016}}));
  // Curved around the sitter, narrower at the top, leaning back.
  const auto shaped = [](const Point& p) -> Point {
    const double height = p.y() - 0.6;
    const double narrower = 1 - 0.25 * height;
    const double x = p.x() * narrower;
    return {x, p.y(), p.z() + 0.9 * x * x - 0.12 * height - 0.1 * height * height};
  };
  parts.push_back(moved(
      rounded_box(kFabric, Point(0, 0.86, -0.275), Point(0.225, 0.255, 0.030), 0.028), shaped));
}

void add_armrest(Parts& parts, double side) {
  parts.push_back(curved_tube(kPlastic, {{{side * 0.10, 0.450, -0.02}, 0.015},
                                         {{side * 0.24, 0.450, -0.02}, 0.015},
                                         {{side * 0.29, 0.475, -0.02}, 0.015},
                                         {{side * 0.298, 0.560, -0.015}, 0.015},
                                         {{side * 0.295, 0.685, -0.01}, 0.015}}));
  parts.push_back(
      rounded_box(kPlastic, Point(side * 0.292, 0.700, 0.01), Point(0.032, 0.015, 0.135), 0.014));
}

}  // namespace

Mesh office_chair() {
  Parts parts;
  for (int arm = 0; arm < kArms; ++arm) add_arm(parts, 2 * kPi * (arm + 0.25) / kArms);
  add_stem(parts);
  add_seat(parts);
  add_back(parts);
  for (const double side : {-1.0, 1.0}) add_armrest(parts, side);
  return Mesh::build("office-chair", parts);
}

}  // namespace hwffd::plates
