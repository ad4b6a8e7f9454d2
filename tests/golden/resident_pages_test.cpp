// Lattices larger than a page in cores with pages: the bits are those of the same packets by
// opcodes 2 and 3, and no page is sent that is there.
#include "hwffd/stream/resident_pages.hpp"

#include <gtest/gtest.h>

#include "hwffd/model/stream_model.hpp"
#include "random_lattice.hpp"

namespace hwffd {
namespace {

/// A core with pages and what is known of it.
class Core {
 public:
  Core(const Configuration& row, const PointStore& store)
      : codec_(row.format),
        store_(store),
        model_(row, features_of(store), store.axis_points, store.pages),
        pages_(store) {
    model_.run(coefficients_packet(watertight_bspline(codec_), codec_, Functions::kDerivativesToo));
  }

  /// Results in the order of the vertices.
  std::vector<Beat> run(const LatticeWords& lattice, const std::vector<VertexBeat>& vertices,
                        OutsideMode mode = OutsideMode::kClamp,
                        Results results = Results::kPosition) {
    PagedVertices paged = by_page(vertices, lattice.dims, store_.axis_points);
    const auto pages = pages_of(lattice, store_.axis_points);
    const auto packets = pages_.packets(pages, paged, mode, results);
    beats_ = packets.size();
    return in_order(model_.run(packets), paged, results);
  }
  void reset() {
    model_.reset();
    pages_.forget();
    model_.run(coefficients_packet(watertight_bspline(codec_), codec_, Functions::kDerivativesToo));
  }
  std::size_t loads() const { return pages_.loads(); }
  std::size_t beats() const { return beats_; }
  const model::StreamEvents& events() const { return model_.events(); }

 private:
  static std::uint32_t features_of(const PointStore& store) {
    return model::kAllFeatures | model::kPagesFeature |
           (store.axis_points > kSmallAxisPoints ? model::kLargeFeature : 0U);
  }

  WordCodec codec_;
  PointStore store_;
  model::StreamModel model_;
  ResidentPages pages_;
  std::size_t beats_ = 0;
};

/// The same by opcodes 2 and 3, in a core without pages.
std::vector<Beat> by_buffers(const Configuration& row, const LatticeWords& lattice,
                             const std::vector<VertexBeat>& vertices, OutsideMode mode,
                             Results results) {
  const WordCodec codec(row.format);
  model::StreamModel model(row);
  model.run(coefficients_packet(watertight_bspline(codec), codec, Functions::kDerivativesToo));
  const PagedVertices paged = by_page(vertices, lattice.dims);
  const auto packets = page_packets(pages_of(lattice), paged, mode, results);
  return in_order(model.run(packets), paged, results);
}

// Vertices stray, too: the status of a result is the same. Tags lose two bits where a page has more
// than 32 points along an axis, so those are compared without.
TEST(ResidentPages, GiveTheBeatsOfOpcodesTwoAndThree) {
  const Dims dims{40, 23, 33};
  for (const char* name : {"basic-fx18-overlapped", "basic-bfp32-overlapped"}) {
    const Configuration& row = find_configuration(name);
    const WordCodec codec(row.format);
    std::mt19937_64 random(1);
    const LatticeWords lattice = random_words(codec, dims, random);
    for (const auto results : {Results::kPosition, Results::kDerivatives}) {
      const auto vertices = random_beats(codec, dims, 1500, random);
      const auto expected = by_buffers(row, lattice, vertices, OutsideMode::kClamp, results);
      for (const PointStore& store :
           {PointStore{16, 1}, PointStore{16, 2}, PointStore{16, 5}, PointStore{16, 64},
            PointStore{13, 3}, PointStore{32, 2}, PointStore{64, 1}}) {
        Core core(row, store);
        for (int again = 0; again < 2; ++again) {
          auto got = core.run(lattice, vertices, OutsideMode::kClamp, results);
          ASSERT_EQ(got.size(), expected.size());
          for (std::size_t r = 0; r < got.size(); ++r) {
            const std::uint32_t tag = store.axis_points > 32 ? kLargeTagMask : kTagMask;
            EXPECT_EQ(got[r].words[3] & tag, expected[r].words[3] & tag);
            got[r].words[3] |= expected[r].words[3] & kTagMask;
            ASSERT_EQ(got[r], expected[r])
                << name << " " << store.axis_points << " " << store.pages;
          }
        }
        for (const std::uint64_t count : core.events()) EXPECT_EQ(count, 0U);
      }
    }
  }
}

// A batch that comes again loads what does not fit, and no more; a change of a point loads its
// pages.
TEST(ResidentPages, SendNoPageThatIsThere) {
  const Dims dims{40, 16, 16};  // three pages along s
  const Configuration& row = find_configuration("basic-fx18-overlapped");
  const WordCodec codec(row.format);
  std::mt19937_64 random(2);
  LatticeWords lattice = random_words(codec, dims, random);
  const auto vertices = random_beats(codec, dims, 400, random);
  ASSERT_EQ(pages_of(lattice).size(), 3U);
  const std::size_t again[] = {3, 1, 0, 0};  // with 1 page it is the last one that stays
  for (int pages = 1; pages <= 4; ++pages) {
    Core core(row, {16, pages});
    core.run(lattice, vertices);
    EXPECT_EQ(core.loads(), 3U) << pages;
    for (std::size_t round = 1; round < 4; ++round) {
      core.run(lattice, vertices);
      EXPECT_EQ(core.loads(), 3 + round * (pages == 1 ? 2 : again[pages - 1])) << pages;
    }
  }
  Core core(row, {16, 4});
  core.run(lattice, vertices);
  const std::size_t all = core.beats();
  core.run(lattice, vertices);
  EXPECT_EQ(core.beats() + 3 + 2 * 16 * 16 * 15 + 16 * 16 * 16, all);
  lattice.points[0][0] ^= 0x10000000;  // of the first page only
  core.run(lattice, vertices);
  EXPECT_EQ(core.loads(), 4U);
  lattice.exponent += 1;
  core.run(lattice, vertices);
  EXPECT_EQ(core.loads(), 7U);
  core.reset();
  core.run(lattice, vertices);
  EXPECT_EQ(core.loads(), 10U);
}

// Vertices of one page touch no other.
TEST(ResidentPages, LoadNothingThatNoVertexIsOf) {
  const Dims dims{40, 40, 16};
  const Configuration& row = find_configuration("basic-fx18-overlapped");
  const WordCodec codec(row.format);
  std::mt19937_64 random(3);
  const LatticeWords lattice = random_words(codec, dims, random);
  Core core(row, {16, 2});
  core.run(lattice, random_beats(codec, dims, 50, random, false, 12));
  EXPECT_EQ(core.loads(), 1U);
  EXPECT_EQ(core.run(lattice, {}).size(), 0U);
  EXPECT_EQ(core.loads(), 1U);
}

TEST(ResidentPages, WantACoreWithPages) {
  EXPECT_THROW(ResidentPages({16, 0}), std::invalid_argument);
  EXPECT_THROW(ResidentPages({16, 257}), std::invalid_argument);
}

}  // namespace
}  // namespace hwffd
