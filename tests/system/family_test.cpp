// Families of blending functions in the core: a family of its own on each axis, axes switched off,
// a user's matrix that saturates. Every bit against the model, values against the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "hwffd/model/organization.hpp"
#include "hwffd/model/organizations.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

constexpr std::size_t kVertices = 48;

struct Case {
  const char* name;
  std::array<const char*, 3> families;  ///< along s, t, u
};

constexpr std::array<Case, 6> kCases{{
    {"mixed", {"bspline", "bernstein", "catmull-rom"}},
    {"patch", {"bspline", "bspline", "constant"}},
    {"curve", {"constant", "bernstein", "constant"}},
    {"hermite", {"hermite", "hermite", "hermite"}},
    {"linear", {"linear", "linear", "linear"}},
    {"turned", {"catmull-rom", "constant", "hermite"}},
}};

/// Largest error of a component, points in [-1/2, 1/2), set over what was measured.
double bound(const Configuration& row) {
  static const std::map<std::string, double> bounds{{"fp32", 5e-7},   {"fx16", 5.6e-4},
                                                    {"fx17", 2.8e-4}, {"fx18", 1.4e-4},
                                                    {"fx32", 7e-9},   {"bfp32", 4e-8}};
  return bounds.at(row.format);
}

/// An evaluator with the B-spline wired in ignores what is loaded.
bool hard_wired(const Configuration& row) { return wired_in(row); }

/// Whether bank 3 of an axis has what the others leave of one.
bool completes(const Configuration& row) { return completes(organization_of(row).form); }

/// The function of a cell's axis that stands in bank 3.
int last_function(const InterleavedVertex& vertex, std::size_t axis) {
  return model::local_of_bank(3, vertex.cell[axis]);
}

/// What a row makes of functions in the cell of a vertex.
Oracle oracle_of(const Configuration& row, std::array<Oracle::Coefficients, 3> functions,
                 const InterleavedVertex& vertex) {
  for (std::size_t a = 0; a < 3 && completes(row); ++a) {
    const int last = last_function(vertex, a);
    functions[a].row(last).setZero();
    const Eigen::RowVector4d rest = functions[a].colwise().sum();
    functions[a].row(last) = Eigen::RowVector4d(1, 0, 0, 0) - rest;
  }
  return Oracle(functions[0], functions[1], functions[2]);
}

/// Uniform points in [-1/2, 1/2); one coordinate in four is 0 or 1.
std::vector<InterleavedVertex> vertices_of(const WordCodec& codec, tb::Random& random) {
  std::vector<InterleavedVertex> vertices(kVertices);
  for (std::size_t v = 0; v < kVertices; ++v) {
    vertices[v] = random_vertex(codec, random);
    vertices[v].tag = static_cast<std::uint16_t>(v);
    for (std::uint32_t& word : vertices[v].local) {
      if (random.chance(0.25)) word = codec.coordinate(random.chance(0.5) ? 1 : 0);
    }
    for (std::uint32_t& word : vertices[v].points) word = codec.point(random.unit() - 0.5);
  }
  return vertices;
}

Eigen::Vector3d exact(const Oracle& oracle, const InterleavedVertex& vertex,
                      const WordCodec& codec) {
  Support support;
  for (int i = 0; i < 192; ++i) support(i / 3, i % 3) = codec.decode_point(vertex.points[i]);
  return oracle.evaluate(support, codec.decode_coordinate(vertex.local[0]),
                         codec.decode_coordinate(vertex.local[1]),
                         codec.decode_coordinate(vertex.local[2]));
}

double difference(const Beat& result, const Eigen::Vector3d& expected, const WordCodec& codec) {
  double largest = 0;
  for (int c = 0; c < 3; ++c) {
    largest = std::max(largest, std::abs(codec.decode_point(result.words[c]) - expected[c]));
  }
  return largest;
}

class FamilyOnAxes : public PerConfiguration {};

TEST_P(FamilyOnAxes, BitsOfTheModelAndValuesOfTheOracle) {
  const bool wired = hard_wired(GetParam());
  std::uint64_t checked = 0;
  for (const Case& c : kCases) {
    SystemRun run(GetParam(), tb::seed_from_environment(1));
    tb::Random random(tb::seed_from_environment(1));
    const WordCodec& codec = run.codec();
    std::array<AxisWords, 3> axes;
    std::array<Oracle::Coefficients, 3> expected;
    for (int a = 0; a < 3; ++a) {
      axes[a] = encode(family(c.families[a], codec), codec);
      // Coefficients above the degree must not matter.
      for (auto& words : axes[a].word) {
        for (int power = axes[a].degree + 1; power < 4; ++power) {
          words[power] = codec.coefficient(random.unit(), 0);
        }
      }
      expected[a] = wired ? Oracle::uniform_bspline() : Oracle::family(c.families[a]);
    }
    const auto vertices = vertices_of(codec, random);
    run.send(coefficients_packet(axes));
    run.send(interleaved_packet(vertices));
    ASSERT_TRUE(run.run()) << c.name;
    const auto& results = run.bench().results();
    ASSERT_EQ(results.size(), kVertices);
    double largest = 0;
    for (std::size_t v = 0; v < kVertices; ++v, ++checked) {
      EXPECT_EQ(results[v].words[3] >> 16, 0U) << c.name << " vertex " << v;
      const Oracle oracle = oracle_of(GetParam(), expected, vertices[v]);
      largest = std::max(largest, difference(results[v], exact(oracle, vertices[v], codec), codec));
    }
    EXPECT_LE(largest, bound(GetParam())) << c.name;
    EXPECT_GT(largest, 0) << c.name;
    std::printf("%s: %.3g\n", c.name, largest);
  }
  EXPECT_EQ(checked, 6 * kVertices);
}

// Along u the weights are 3 - 3 u and 3 u - 2, whose sum is 1: in fixed point the first leaves
// [-2, 2) where u is below 1/3, and the result says so; binary32 takes it as it is, and where the
// weight is what others leave, it is never computed.
TEST_P(FamilyOnAxes, AUsersMatrixThatSaturatesIsFlagged) {
  const bool wired = hard_wired(GetParam());
  SystemRun run(GetParam(), tb::seed_from_environment(1));
  tb::Random random(tb::seed_from_environment(1));
  const WordCodec& codec = run.codec();
  auto vertices = vertices_of(codec, random);
  for (InterleavedVertex& vertex : vertices) {
    for (std::uint32_t& word : vertex.points) word = codec.point(codec.decode_point(word) / 4);
  }
  const Blending user = user_blending({{{}, {3, -3, 0, 0}, {-2, 3, 0, 0}, {}}});
  EXPECT_EQ(user.degree, 1);
  EXPECT_EQ(encode(user, codec).shift, codec.has_fixed_weights() ? 1 : 0);
  const Blending bspline = family("bspline", codec);
  run.send(coefficients_packet({bspline, bspline, user}, codec));
  run.send(interleaved_packet(vertices));
  ASSERT_TRUE(run.run());
  const auto& results = run.bench().results();
  ASSERT_EQ(results.size(), kVertices);
  Oracle::Coefficients along_u = Oracle::uniform_bspline();
  if (!wired) {
    along_u.setZero();
    along_u.row(1) << 3, -3, 0, 0;
    along_u.row(2) << -2, 3, 0, 0;
  }
  const Oracle oracle(Oracle::uniform_bspline(), Oracle::uniform_bspline(), along_u);
  std::size_t flagged = 0;
  std::size_t whole = 0;
  for (std::size_t v = 0; v < kVertices; ++v) {
    const double u = codec.decode_coordinate(vertices[v].local[2]);
    const bool computed = !completes(GetParam()) || last_function(vertices[v], 2) != 1;
    const bool saturates = !wired && computed && codec.has_fixed_weights() && u < 1.0 / 3;
    EXPECT_EQ(results[v].words[3] >> 16, saturates ? kStatusSaturated >> 16 : 0U) << "u = " << u;
    if (saturates) {
      ++flagged;
      continue;
    }
    ++whole;
    EXPECT_LE(difference(results[v], exact(oracle, vertices[v], codec), codec), bound(GetParam()));
  }
  EXPECT_EQ(flagged + whole, kVertices);
  EXPECT_GT(whole, 5U);
  EXPECT_EQ(flagged > 5, !wired && codec.has_fixed_weights());
}

HWFFD_FOR_EACH_CONFIGURATION(FamilyOnAxes);

}  // namespace
}  // namespace hwffd::test
