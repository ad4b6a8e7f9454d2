// What arrangements of the control points move: predictions by hand, against the packets that are
// made, and against what the RTL takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/stream/packed.hpp"
#include "hwffd/tb/arrangement.hpp"
#include "hwffd/tb/random.hpp"
#include "order.hpp"
#include "pages.hpp"
#include "report.hpp"
#include "study.hpp"

namespace hwffd::streams {
namespace {

using Kind = tb::Arrangement::Kind;

constexpr std::uint64_t kCoefficients = 13;

std::vector<Index3> cells_of(const std::vector<Embedded>& vertices) {
  std::vector<Index3> cells;
  for (const Embedded& vertex : vertices) cells.push_back(vertex.cell);
  return cells;
}

/// Vertices in runs of random length and cell.
std::vector<Embedded> random_vertices(const Index3& dims, std::size_t count, int longest) {
  tb::Random random(1);
  std::vector<Embedded> vertices;
  while (vertices.size() < count) {
    Embedded vertex;
    for (int a = 0; a < 3; ++a) vertex.cell[a] = static_cast<int>(random.between(0, dims[a] - 4));
    const auto run = static_cast<std::size_t>(random.between(1, longest));
    vertices.insert(vertices.end(), std::min(run, count - vertices.size()), vertex);
  }
  return vertices;
}

TEST(Order, TheCurveVisitsEveryCellInStepsOfOne) {
  std::vector<Index3> at(4096, Index3{-1, -1, -1});
  for (int i = 0; i < 16; ++i) {
    for (int j = 0; j < 16; ++j) {
      for (int k = 0; k < 16; ++k) {
        const std::size_t place = place_on_curve({i, j, k});
        ASSERT_LT(place, at.size());
        EXPECT_EQ(at[place][0], -1) << place << " twice";
        at[place] = {i, j, k};
      }
    }
  }
  for (std::size_t place = 1; place < at.size(); ++place) {
    int steps = 0;
    for (int a = 0; a < 3; ++a) steps += std::abs(at[place][a] - at[place - 1][a]);
    EXPECT_EQ(steps, 1) << place;
  }
}

TEST(Order, KeepsEveryVertexAndTheOrderWithinACell) {
  std::vector<Embedded> vertices = random_vertices({7, 5, 9}, 500, 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v].local[0] = static_cast<double>(v);
  for (const std::string& order : order_names()) {
    const std::vector<Embedded> sorted = ordered(vertices, order);
    std::set<double> seen;
    std::set<Index3> cells;
    std::size_t changes = 0;
    for (std::size_t v = 0; v < sorted.size(); ++v) {
      seen.insert(sorted[v].local[0]);
      cells.insert(sorted[v].cell);
      const bool same = v > 0 && sorted[v].cell == sorted[v - 1].cell;
      if (same) {
        EXPECT_GT(sorted[v].local[0], sorted[v - 1].local[0]);
      } else {
        ++changes;
      }
    }
    EXPECT_EQ(seen.size(), vertices.size()) << order;
    EXPECT_EQ(changes == cells.size(), order != "file") << order;
  }
}

// Three vertices: a cell, its neighbour, the first again.
TEST(Predicted, ByHand) {
  const std::vector<Index3> cells{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}};
  const auto beats = [&](Kind kind, std::size_t capacity) {
    return tb::predicted_beats({kind, capacity, {}}, {4, 4, 5}, cells) - kCoefficients;
  };
  EXPECT_EQ(beats(Kind::kInterleaved, 0), 1 + 3 * 49U);
  EXPECT_EQ(beats(Kind::kResident, 0), 1 + 80 + 1 + 3U);
  EXPECT_EQ(beats(Kind::kPacked, 0), 1 + 80 + 1 + 2U);
  EXPECT_EQ(beats(Kind::kCells, 1), 3 * (1 + 64 + 1 + 1U));
  EXPECT_EQ(beats(Kind::kCells, 2), 1 + 64 + 1 + 1 + 1 + 64 + 1 + 2U);
  // 64 points are 192 words, 16 are 48; with two words of mask 49 and 13 beats.
  EXPECT_EQ(beats(Kind::kChanged, 0), 1 + (1 + 49) + 2 * (1 + 13U));
}

TEST(Predicted, PackedVerticesAreTheSizeOfTheirPackets) {
  for (const std::size_t count : {1U, 2U, 1023U, 1024U, 1025U, 3001U}) {
    std::size_t beats = kCoefficients + 1 + 80;
    for (std::size_t left = count; left > 0;) {
      const std::size_t some = std::min<std::size_t>(left, kPacketVertices);
      beats += packed_packet(std::vector<PackedVertex>(some)).size();
      left -= some;
    }
    const std::vector<Index3> cells(count, Index3{0, 0, 0});
    EXPECT_EQ(tb::predicted_beats({Kind::kPacked, 0, {}}, {4, 4, 5}, cells), beats) << count;
  }
}

TEST(Predicted, IsTheSizeOfThePackets) {
  const Index3 dims{6, 5, 7};
  const Lattice lattice = Box({0, 0, 0}, Eigen::Matrix3d::Identity()).lattice(dims);
  std::size_t compared = 0;
  for (const int longest : {1, 5, 3000}) {
    const std::vector<Embedded> vertices = random_vertices(dims, 4000, longest);
    for (const tb::Arrangement& arrangement : tb::arrangements()) {
      if (!arrangement.is_built()) {
        EXPECT_THROW(tb::packets(arrangement, lattice, vertices, "fx18"), std::invalid_argument);
        continue;
      }
      EXPECT_EQ(tb::packets(arrangement, lattice, vertices, "fx18").size(),
                tb::predicted_beats(arrangement, dims, cells_of(vertices)))
          << arrangement.name();
      ++compared;
    }
  }
  EXPECT_EQ(compared, 9U);
}

TEST(Study, CountedEqualsPredicted) {
  std::vector<NamedMesh> meshes;
  meshes.push_back({"built-in", Mesh::procedural()});
  const std::vector<Row> rows = study(meshes, {4, 7}, find_configuration("basic-fx18-overlapped"),
                                      [](std::size_t, std::size_t) {});
  EXPECT_EQ(faults(rows), "");
  ASSERT_EQ(rows.size(), 2 * 10U);
  std::size_t counted = 0;
  for (const Row& row : rows) {
    counted += row.counted ? 1 : 0;
    if (row.arrangement != "resident") continue;
    const double lattice = row.points * row.points * row.points;
    const double packets = 14 + std::ceil(static_cast<double>(row.vertices) / kPacketVertices);
    EXPECT_DOUBLE_EQ(row.words_per_vertex(), 4 + 4 * (lattice + packets) / row.vertices);
  }
  EXPECT_EQ(counted, 2 * 4U);
  EXPECT_EQ(nlohmann::json::parse(json_report(rows)).at("rows").size(), rows.size());
}

// Pages by hand: 20 points an axis are two pages, of 15 and 8 points.
TEST(PagesStudy, CountedEqualsPredicted) {
  std::vector<NamedMesh> meshes;
  meshes.push_back({"built-in", Mesh::procedural()});
  const auto rows = pages_study(meshes, {20, 30}, find_configuration("basic-fx18-overlapped"));
  EXPECT_EQ(faults({}, rows), "");
  ASSERT_EQ(rows.size(), 2 * 8U);
  for (const PagesRow& row : rows) {
    if (row.points != 20 || row.batch != row.vertices) continue;
    const std::uint64_t packets = row.predicted - kCoefficients - row.vertices;
    const std::uint64_t points = 23 * 23 * 23;  // of all eight pages
    EXPECT_GE(packets, 8 + points + 8) << row.pages;
    EXPECT_LE(packets, 8 + points + 8 + row.vertices / kPacketVertices) << row.pages;
  }
  // In batches pages that are kept are not sent again.
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].pages != 16 || rows[r].batch == rows[r].vertices) continue;
    EXPECT_LT(rows[r].predicted, rows[r - 3].predicted) << "2 buffers";
    EXPECT_LE(rows[r].predicted, rows[r - 1].predicted) << "8 pages";
  }
  EXPECT_EQ(nlohmann::json::parse(json_report({}, rows)).at("pages").size(), rows.size());
  PagesRow wrong = rows[0];
  wrong.mismatches = 3;
  ++wrong.counted;
  const std::string text = faults({}, {wrong});
  EXPECT_NE(text.find("20 points an axis, 0 pages"), std::string::npos) << text;
  EXPECT_NE(text.find("3 results differ"), std::string::npos) << text;
  EXPECT_NE(text.find("beats predicted"), std::string::npos) << text;
}

TEST(Study, FaultsAreNamed) {
  Row row{"cat.3ds", 10, 4, "resident", "file"};
  row.predicted = 80;
  row.counted = 80;
  EXPECT_EQ(faults({row}), "");
  Row larger = row;
  larger.points = 6;
  larger.counted = 81;
  EXPECT_NE(faults({row, larger}).find("80 beats predicted, 81 counted"), std::string::npos);
  row.counted.reset();
  EXPECT_EQ(faults({row}), "");
  row.mismatches = 2;
  EXPECT_NE(faults({row}).find("2 results differ"), std::string::npos);
}

}  // namespace
}  // namespace hwffd::streams
