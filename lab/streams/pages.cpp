#include "pages.hpp"

#include <algorithm>
#include <list>
#include <map>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/resident_pages.hpp"

namespace hwffd::streams {
namespace {

constexpr int kStep = 12;  // cells from one page of 16 points to the next
constexpr std::size_t kBatch = 1024;

/// The page of a cell along an axis of so many points, and its own points; the last page of an axis
/// has what is left, 16 points or fewer.
std::pair<int, int> along(int cell, int points) {
  int page = 0;
  while (page < cell / kStep && points - kStep * page > kAxisPoints) ++page;
  const int left = points - kStep * page;
  return {page, left > kAxisPoints ? kStep + 3 : left};
}

/// Beats of batches of vertices of these cells, from how the lattice is cut and which pages were
/// used last alone.
std::uint64_t predicted_beats(const PagesRow& row, const std::vector<VertexBeat>& vertices) {
  using Page = std::array<int, 3>;
  std::uint64_t beats = 1 + kCoefficientBeats;
  std::list<Page> there;  // used last first
  for (std::size_t first = 0; first < vertices.size(); first += row.batch) {
    std::map<Page, std::uint64_t> count;
    std::map<Page, std::uint64_t> points;
    for (std::size_t v = first; v < std::min(first + row.batch, vertices.size()); ++v) {
      Page page{};
      std::uint64_t size = 1;
      for (int a = 0; a < 3; ++a) {
        const auto [number, length] = along(vertices[v].cell[a], row.points);
        page[a] = number;
        size *= static_cast<std::uint64_t>(length);
      }
      ++count[page];
      points[page] = size;
    }
    const std::list<Page> before = there;
    for (const bool resident : {true, false}) {
      for (const auto& [page, some] : count) {
        const bool was = std::find(before.begin(), before.end(), page) != before.end();
        if (was != resident) continue;
        beats += some + (some + kPacketVertices - 1) / kPacketVertices;
        there.remove(page);
        there.push_front(page);
        if (!was) beats += 1 + points[page];
        if (there.size() > static_cast<std::size_t>(row.pages)) there.pop_back();
      }
    }
  }
  return beats;
}

/// Sends batch after batch; what comes back, in the order of the file.
std::vector<Beat> run(PagesRow& row, const Configuration& configuration,
                      const LatticeWords& lattice, const std::vector<VertexBeat>& vertices) {
  const WordCodec codec(configuration.format);
  const PointStore store{kAxisPoints, row.pages};
  model::StreamModel model(configuration,
                           model::kAllFeatures | (row.pages > 0 ? model::kPagesFeature : 0U),
                           kAxisPoints, row.pages > 0 ? row.pages : kPages);
  const auto functions = coefficients_packet(watertight_bspline(codec), codec);
  model.run(functions);
  row.counted = functions.size();
  const std::vector<LatticePage> pages = pages_of(lattice);
  std::optional<ResidentPages> resident;
  if (row.pages > 0) resident.emplace(store);
  std::vector<Beat> results;
  for (std::size_t first = 0; first < vertices.size(); first += row.batch) {
    const auto begin = vertices.begin() + static_cast<std::ptrdiff_t>(first);
    const auto left = std::min(row.batch, vertices.size() - first);
    PagedVertices paged = by_page({begin, begin + static_cast<std::ptrdiff_t>(left)}, lattice.dims);
    const auto packets = resident ? resident->packets(pages, paged) : page_packets(pages, paged);
    row.counted += packets.size();
    append(results, in_order(model.run(packets), paged));
  }
  return results;
}

/// The same in a core that keeps the lattice as one page.
std::vector<Beat> run_whole(const Configuration& configuration, const LatticeWords& lattice,
                            const std::vector<VertexBeat>& vertices) {
  const WordCodec codec(configuration.format);
  PageVertices how;
  how.large = true;
  model::StreamModel model(configuration,
                           model::kAllFeatures | model::kPagesFeature | model::kLargeFeature,
                           kLargeAxisPoints, 1);
  model.run(coefficients_packet(watertight_bspline(codec), codec));
  model.run(page_packet(0, lattice));
  return model.run(page_vertices_packet(0, vertices, how));
}

}  // namespace

std::vector<PagesRow> pages_study(const std::vector<NamedMesh>& meshes,
                                  const std::vector<int>& lattices,
                                  const Configuration& configuration) {
  const WordCodec codec(configuration.format);
  std::vector<PagesRow> rows;
  for (const NamedMesh& mesh : meshes) {
    const Box box = Box::around(mesh.mesh.positions());
    for (const int points : lattices) {
      const Index3 dims{points, points, points};
      const Lattice lattice = Deformation::parse("twist:90").apply(box.lattice(dims));
      const LatticeWords words = lattice_words(lattice, codec, Normalization::of(lattice, codec));
      const auto vertices = vertex_beats(box.embed(dims, mesh.mesh.positions()), codec);
      const std::vector<Beat> whole = run_whole(configuration, words, vertices);
      for (const std::size_t batch : {vertices.size(), kBatch}) {
        for (const int pages : {0, 4, 8, 16}) {
          PagesRow row{mesh.name, vertices.size(), points, pages, batch};
          row.predicted = predicted_beats(row, vertices);
          const std::vector<Beat> results = run(row, configuration, words, vertices);
          for (std::size_t v = 0; v < vertices.size(); ++v) {
            for (std::size_t c = 0; c < 3; ++c) {
              if (results[v].words[c] == whole[v].words[c]) continue;
              ++row.mismatches;
              break;
            }
          }
          rows.push_back(row);
        }
      }
    }
  }
  return rows;
}

}  // namespace hwffd::streams
