// Lattices larger than a core keeps, cut into pages: the bits are those of one lattice, in the
// model of the stream and of the evaluator; how many words a vertex takes.
#include "hwffd/stream/large_lattice.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>

#include "hwffd/error.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/spans.hpp"
#include "random_lattice.hpp"

namespace hwffd {
namespace {

/// All pages and vertices of a lattice, through the model of a core of that many points an axis.
std::vector<Beat> by_pages(const Configuration& row, const LatticeWords& lattice,
                           const std::vector<VertexBeat>& vertices, int axis_points,
                           OutsideMode mode, Results results) {
  const WordCodec codec(row.format);
  model::StreamModel model(row, model::kAllFeatures, axis_points);
  model.run(coefficients_packet(watertight_bspline(codec), codec, Functions::kDerivativesToo));
  const PagedVertices paged = by_page(vertices, lattice.dims, axis_points);
  const auto packets = page_packets(pages_of(lattice, axis_points), paged, mode, results);
  return in_order(model.run(packets), paged, results);
}

const char* const kRows[] = {"basic-fx18-overlapped", "basic-fp32-overlapped",
                             "basic-bfp32-overlapped", "factored-fp32-overlapped"};

// The reference has the lattice whole: each vertex with the points of its cell, and with the cell
// of the lattice.
TEST(LargeLattice, PagesGiveTheBitsOfOneLattice) {
  constexpr std::size_t kVertices = 1200;
  int compared = 0;
  for (const char* name : kRows) {
    const Configuration& row = find_configuration(name);
    const WordCodec codec(row.format);
    const auto whole = model::make_evaluator_model(row);
    load(*whole, encode(watertight_bspline(codec), codec));
    std::mt19937_64 random(1);
    for (const auto& [dims, axis_points] : {std::pair<Dims, int>{{40, 23, 33}, 16},
                                            {{17, 28, 29}, 16},
                                            {{21, 9, 13}, 8},
                                            {{9, 4, 64}, 7}}) {
      const LatticeWords lattice = random_words(codec, dims, random);
      const auto vertices = random_beats(codec, dims, kVertices, random);
      const auto results =
          by_pages(row, lattice, vertices, axis_points, OutsideMode::kClamp, Results::kPosition);
      ASSERT_EQ(results.size(), kVertices);
      for (std::size_t v = 0; v < kVertices; ++v) {
        model::VertexWords words;
        words.local = vertices[v].local;
        words.cell = vertices[v].cell;
        words.exponent = lattice.exponent;
        for (int p = 0; p < 64; ++p) {
          const int at =
              ((words.cell[0] + p / 16) * dims[1] + words.cell[1] + p / 4 % 4) * dims[2] +
              words.cell[2] + p % 4;
          for (int c = 0; c < 3; ++c) words.points[3 * p + c] = lattice.points[at][c];
        }
        const model::ResultWords expected = whole->evaluate(0, words);
        for (std::size_t c = 0; c < 3; ++c, ++compared) {
          ASSERT_EQ(results[v].words[c], expected.words[c]) << name << " vertex " << v;
        }
        EXPECT_EQ(results[v].words[3] & kTagMask, vertices[v].tag);
      }
    }
  }
  EXPECT_EQ(compared, 4 * 4 * 3 * static_cast<int>(kVertices));
}

// Status, modes and derivatives too, as a core with a longer axis gives them: 19 points, the most
// whose cells have four bits.
TEST(LargeLattice, PagesGiveTheBeatsOfALongerAxis) {
  constexpr int kLong = 19;
  for (const char* name : kRows) {
    const Configuration& row = find_configuration(name);
    const WordCodec codec(row.format);
    std::mt19937_64 random(2);
    const LatticeWords lattice = random_words(codec, {kLong, 17, 18}, random);
    for (const auto mode : {OutsideMode::kClamp, OutsideMode::kPass, OutsideMode::kBlank}) {
      for (const auto results : {Results::kPosition, Results::kDerivatives, Results::kDeterminant,
                                 Results::kDeterminantAlone}) {
        const auto vertices = random_beats(codec, lattice.dims, 150, random, true, 16);
        const std::size_t each = results_of(results);
        model::StreamModel model(row, model::kAllFeatures, kLong);
        model.run(
            coefficients_packet(watertight_bspline(codec), codec, Functions::kDerivativesToo));
        model.run(lattice_packet(lattice));
        const auto expected = model.run(vertices_packet(vertices, mode, results));
        ASSERT_EQ(expected.size(), each * vertices.size());
        for (const int axis_points : {16, 8}) {
          EXPECT_EQ(by_pages(row, lattice, vertices, axis_points, mode, results), expected)
              << name << " " << axis_points;
        }
      }
    }
  }
}

TEST(LargeLattice, PagesCoverEveryCellOnce) {
  const WordCodec codec("fx18");
  std::mt19937_64 random(3);
  for (int axis_points = 7; axis_points <= 16; ++axis_points) {
    for (int points = 4; points <= 48; ++points) {
      const LatticeWords lattice = random_words(codec, {points, 4, 5}, random);
      int next = 0;
      for (const LatticePage& page : pages_of(lattice, axis_points)) {
        EXPECT_EQ(page.origin[0], next);
        EXPECT_EQ(page.origin[0] % 4, 0);
        EXPECT_LE(page.lattice.dims[0], axis_points);
        EXPECT_GE(page.lattice.dims[0], 4);
        next += page.lattice.dims[0] - 3;
        EXPECT_EQ(page.lattice.points.size(), 20U * page.lattice.dims[0]);
        EXPECT_EQ(page.lattice.points.front(), lattice.points[20 * page.origin[0]]);
      }
      EXPECT_EQ(next, points - 3);
    }
  }
  const LatticeWords fits = random_words(codec, {16, 4, 9}, random);
  ASSERT_EQ(pages_of(fits).size(), 1U);
  EXPECT_EQ(pages_of(fits)[0].lattice.points, fits.points);
}

TEST(LargeLattice, WhatCannotBeCutIsRefused) {
  LatticeWords lattice;
  lattice.dims = {3, 4, 4};
  EXPECT_THROW(pages_of(lattice), UsageError);
  lattice.dims = {8, 4, 4};
  EXPECT_THROW(pages_of(lattice, 6), UsageError);
  EXPECT_THROW(by_page({}, lattice.dims, 6), UsageError);
  PagedVertices vertices;
  vertices.from = {0};
  EXPECT_THROW(in_order({}, vertices), std::invalid_argument);
}

/// Words on the way in for a vertex, lattice included.
double words_a_vertex(const std::vector<Beat>& packets, std::size_t vertices) {
  return 4.0 * static_cast<double>(packets.size()) / static_cast<double>(vertices);
}

// Every page that has vertices is sent once, so a vertex takes four words and its share of a little
// more than the lattice.
TEST(LargeLattice, WordsAVertex) {
  const WordCodec codec("fx18");
  const Mesh mesh = Mesh::procedural();
  const Box box = Box::around(mesh.positions());
  std::mt19937_64 random(4);
  for (const int points : {16, 24, 32, 48, 64}) {
    const Index3 dims{points, points, points};
    const auto of_mesh = vertex_beats(box.embed(dims, mesh.positions()), codec);
    const LatticeWords lattice = random_words(codec, {points, points, points}, random);
    const auto scattered = random_beats(codec, lattice.dims, 100000, random);
    const auto pages = pages_of(lattice);
    double words[2] = {};
    std::size_t used = 0;
    for (const bool all : {false, true}) {
      const PagedVertices paged = by_page(all ? scattered : of_mesh, lattice.dims);
      const auto packets = page_packets(pages, paged);
      words[all ? 1 : 0] = words_a_vertex(packets, paged.from.size());
      std::size_t beats = paged.from.size();
      for (std::size_t p = 0; p < pages.size(); ++p) {
        const std::size_t count = paged.of_page[p].size();
        if (count == 0) continue;
        used += all ? 0 : 1;
        beats +=
            1 + pages[p].lattice.points.size() + (count + kPacketVertices - 1) / kPacketVertices;
      }
      EXPECT_EQ(packets.size(), beats);
    }
    std::printf(
        "%d^3 points, %zu pages: %.2f words a vertex for %zu of the mesh (%zu pages), %.2f "
        "for 100,000 anywhere; the lattice alone %.2f\n",
        points, pages.size(), words[0], of_mesh.size(), used, words[1],
        4e-5 * points * points * points);
  }
}

}  // namespace
}  // namespace hwffd
