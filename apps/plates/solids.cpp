#include "plates/solids.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace hwffd::plates {
namespace {

constexpr unsigned kAround = 20;  // corners of a tube's circle
constexpr int kRounding = 4;      // edges across a rounded edge
constexpr double kEnd = 0.35;     // depth of a rounded end by its radius
constexpr double kTurn = 6.283185307179586476925;

/// Collects a part's points and triangles.
class Builder {
 public:
  explicit Builder(const Stuff& stuff) : stuff_(stuff) {}

  std::uint32_t add(const Point& point) {
    points_.push_back(point);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    triangles_.push_back({a, b, c});
  }
  /// Corners counterclockwise seen from outside.
  void square(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }

  Mesh::Part part() const {
    Points positions(static_cast<Eigen::Index>(points_.size()), 3);
    for (std::size_t p = 0; p < points_.size(); ++p) {
      positions.row(static_cast<Eigen::Index>(p)) = points_[p];
    }
    return {stuff_.name, stuff_.colour, positions, triangles_};
  }

 private:
  Stuff stuff_;
  std::vector<Point> points_;
  std::vector<Mesh::Triangle> triangles_;
};

int pieces(double length, double step) {
  return std::max(1, static_cast<int>(std::ceil(length / step)));
}

/// Stations in between, so that none is further from the next than a step.
std::vector<Station> refined(const std::vector<Station>& stations, double step) {
  std::vector<Station> fine{stations.front()};
  for (std::size_t s = 1; s < stations.size(); ++s) {
    const Station& from = stations[s - 1];
    const Station& to = stations[s];
    const int count = pieces((to.centre - from.centre).norm(), step);
    for (int i = 1; i <= count; ++i) {
      const double x = static_cast<double>(i) / count;
      fine.push_back(
          {(1 - x) * from.centre + x * to.centre, (1 - x) * from.radius + x * to.radius});
    }
  }
  return fine;
}

/// Circles of a rounded end beyond a station, outwards: from the widest on.
std::vector<Station> rounded_end(const Station& end, const Point& outwards) {
  std::vector<Station> circles;
  for (int i = 1; i < kRounding; ++i) {
    const double angle = kTurn / 4 * i / kRounding;
    circles.push_back({end.centre + kEnd * end.radius * std::sin(angle) * outwards,
                       end.radius * std::cos(angle)});
  }
  return circles;
}

/// The coordinates of a rounded box's points along an axis.
std::vector<double> divided(double half, double radius, double step) {
  std::vector<double> places;
  for (int i = 0; i < kRounding; ++i) places.push_back(-half + radius * i / kRounding);
  const double flat = 2 * (half - radius);
  const int count = flat > 0 ? pieces(flat, step) : 0;
  for (int i = 0; i <= count; ++i) {
    places.push_back(count == 0 ? 0.0 : -half + radius + flat * i / count);
  }
  for (int i = 1; i <= kRounding; ++i) places.push_back(half - radius + radius * i / kRounding);
  return places;
}

}  // namespace

Mesh::Part tube(const Stuff& stuff, const std::vector<Station>& stations) {
  std::vector<Station> circles = refined(stations, stuff.step);
  const std::size_t last = circles.size() - 1;
  const Point first_way = (circles[0].centre - circles[1].centre).normalized();
  const Point last_way = (circles[last].centre - circles[last - 1].centre).normalized();
  std::vector<Station> begin = rounded_end(circles.front(), first_way);
  const std::vector<Station> end = rounded_end(circles.back(), last_way);
  std::reverse(begin.begin(), begin.end());
  const Point first_pole = circles.front().centre + kEnd * circles.front().radius * first_way;
  const Point last_pole = circles.back().centre + kEnd * circles.back().radius * last_way;
  circles.insert(circles.begin(), begin.begin(), begin.end());
  circles.insert(circles.end(), end.begin(), end.end());

  Builder builder(stuff);
  Point side = first_way.unitOrthogonal();
  for (std::size_t s = 0; s < circles.size(); ++s) {
    const Point before = circles[s == 0 ? 0 : s - 1].centre;
    const Point after = circles[std::min(s + 1, circles.size() - 1)].centre;
    const Point way = (after - before).normalized();
    side = (side - side.dot(way) * way).normalized();
    const Point other = way.cross(side);
    for (unsigned c = 0; c < kAround; ++c) {
      const double angle = kTurn * c / kAround;
      builder.add(circles[s].centre +
                  circles[s].radius * (std::cos(angle) * side + std::sin(angle) * other));
    }
  }
  const auto at = [&](std::size_t s, unsigned c) {
    return static_cast<std::uint32_t>(s * kAround + c % kAround);
  };
  const std::uint32_t low = builder.add(first_pole);
  const std::uint32_t high = builder.add(last_pole);
  for (unsigned c = 0; c < kAround; ++c) {
    for (std::size_t s = 0; s + 1 < circles.size(); ++s) {
      builder.square(at(s, c), at(s, c + 1), at(s + 1, c + 1), at(s + 1, c));
    }
    builder.triangle(low, at(0, c + 1), at(0, c));
    builder.triangle(high, at(circles.size() - 1, c), at(circles.size() - 1, c + 1));
  }
  return builder.part();
}

Mesh::Part curved_tube(const Stuff& stuff, const std::vector<Station>& stations) {
  const auto at = [&](std::size_t s, int offset) {
    const int last = static_cast<int>(stations.size()) - 1;
    const Station& station =
        stations[static_cast<std::size_t>(std::clamp(static_cast<int>(s) + offset, 0, last))];
    return Eigen::Vector4d(station.centre.x(), station.centre.y(), station.centre.z(),
                           station.radius);
  };
  std::vector<Station> curve{stations.front()};
  for (std::size_t s = 0; s + 1 < stations.size(); ++s) {
    const int count = pieces((stations[s + 1].centre - stations[s].centre).norm(), stuff.step / 2);
    for (int i = 1; i <= count; ++i) {
      const double x = static_cast<double>(i) / count;
      const Eigen::Vector4d p0 = at(s, -1);
      const Eigen::Vector4d p1 = at(s, 0);
      const Eigen::Vector4d p2 = at(s, 1);
      const Eigen::Vector4d p3 = at(s, 2);
      const Eigen::Vector4d p = p1 + x / 2 * (p2 - p0) +
                                x * x / 2 * (2 * p0 - 5 * p1 + 4 * p2 - p3) +
                                x * x * x / 2 * (3 * p1 - p0 - 3 * p2 + p3);
      curve.push_back({p.head<3>(), p[3]});
    }
  }
  return tube(stuff, curve);
}

Mesh::Part rounded_box(const Stuff& stuff, const Point& centre, const Point& half, double radius) {
  const std::array<std::vector<double>, 3> places{divided(half.x(), radius, stuff.step),
                                                  divided(half.y(), radius, stuff.step),
                                                  divided(half.z(), radius, stuff.step)};
  Builder builder(stuff);
  std::map<std::array<std::size_t, 3>, std::uint32_t> known;
  // The point of the plain box goes to where the ball around its nearest inner point ends.
  const auto place = [&](const std::array<std::size_t, 3>& at) {
    const auto [entry, is_new] = known.emplace(at, 0);
    if (is_new) {
      const Point outer(places[0][at[0]], places[1][at[1]], places[2][at[2]]);
      const Point room = half - Point::Constant(radius);
      const Point inner = outer.cwiseMin(room).cwiseMax(-room);
      entry->second = builder.add(centre + inner + radius * (outer - inner).normalized());
    }
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t a = (axis + 1) % 3;
    const std::size_t b = (axis + 2) % 3;
    for (std::size_t i = 0; i + 1 < places[a].size(); ++i) {
      for (std::size_t j = 0; j + 1 < places[b].size(); ++j) {
        const auto corner = [&](std::size_t end, std::size_t da, std::size_t db) {
          std::array<std::size_t, 3> at{};
          at[axis] = end;
          at[a] = i + da;
          at[b] = j + db;
          return place(at);
        };
        const std::size_t top = places[axis].size() - 1;
        builder.square(corner(top, 0, 0), corner(top, 1, 0), corner(top, 1, 1), corner(top, 0, 1));
        builder.square(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
      }
    }
  }
  return builder.part();
}

Mesh::Part moved(Mesh::Part part, const std::function<Point(const Point&)>& move) {
  for (Eigen::Index p = 0; p < part.positions.rows(); ++p) {
    part.positions.row(p) = move(part.positions.row(p));
  }
  return part;
}

}  // namespace hwffd::plates
