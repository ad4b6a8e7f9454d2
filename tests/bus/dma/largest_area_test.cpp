// An area of more than 2^31 bytes: its count reaches its highest bit, which takes a minute or two.
#include <gtest/gtest.h>

#include "dma_bench.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kFirst = 0x10000;
constexpr std::uint64_t kPiece = 65521;  // a prime: no bit of the count is 0 at the end of each
constexpr std::uint64_t kPieces = (std::uint64_t{1} << 27) / kPiece + 2;
constexpr std::uint64_t kResults = kPieces * kPiece;

// Piece by piece, so that neither end has to hold all of it.
TEST(LargestArea, IsCountedToItsEnd) {
  DmaBench bench(small_dma_size(), 1);
  bench.start_results(kFirst, static_cast<std::uint32_t>(kResults * kBeat));
  bench.run(10);
  for (std::uint64_t count = 0; count < kResults; count += kPiece) {
    bench.offer_results(kPiece, kPiece);
    ASSERT_TRUE(bench.run_until_counted(count + kPiece)) << bench.status.result_count << " results";
    ASSERT_EQ(bench.results_in_memory(kFirst + count * kBeat, 0, kPiece), kPiece);
    ASSERT_TRUE(bench.run_until([&] { return bench.memory.quiet(); }, 100));
    bench.memory.forget();
    bench.forget_results();
  }
  EXPECT_EQ(bench.faults(), "");
}

}  // namespace
}  // namespace hwffd::test
