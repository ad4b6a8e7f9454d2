// The boards through their pins: frames in on the serial line, bit by bit, and every returned bit
// against the golden model; frames that are broken off, and noise.
#include <gtest/gtest.h>

#include "Vboard_icebreaker.h"
#include "Vboard_ulx3s.h"
#include "bad_packets.hpp"
#include "frame_model.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "serial_host.hpp"

namespace hwffd::test {
namespace {

struct Ulx3s {
  using Dut = Vboard_ulx3s;
  static constexpr const char* kRow = HWFFD_ULX3S_ROW;
  static constexpr std::uint32_t kFeatures = model::kAllFeatures;
  static constexpr int kAxis = 16;
};

struct Icebreaker {
  using Dut = Vboard_icebreaker;
  static constexpr const char* kRow = HWFFD_ICEBREAKER_ROW;
  static constexpr std::uint32_t kFeatures = model::kResidentFeature;
  static constexpr int kAxis = 4;
};

constexpr int kClocks = HWFFD_BOARD_CLOCKS;       // of a bit
constexpr int kPause = 1 << HWFFD_BOARD_PAUSE_W;  // clocks
constexpr int kResultClocks = 4000;               // at most, from one byte to the next
constexpr std::size_t kMostResults = 64;          // of a frame, by the rule of the README

std::vector<std::uint8_t> frame(const std::vector<Beat>& packet) {
  std::vector<std::uint8_t> bytes = {static_cast<std::uint8_t>(packet.size()),
                                     static_cast<std::uint8_t>(packet.size() >> 8)};
  for (const Beat& beat : packet) {
    for (int place = 0; place < 16; ++place) {
      bytes.push_back(static_cast<std::uint8_t>(beat.words[place / 4] >> (8 * (place % 4))));
    }
  }
  return bytes;
}

std::vector<Beat> read_results(const std::vector<std::uint8_t>& bytes) {
  std::vector<Beat> results(bytes.size() / 16);
  for (std::size_t at = 0; at < results.size() * 16; ++at) {
    results[at / 16].words[at % 16 / 4] |= static_cast<std::uint32_t>(bytes[at]) << (8 * (at % 4));
  }
  for (Beat& result : results) {
    result.last = (result.words[3] >> 31) != 0;
    result.words[3] &= 0x7fffffff;
  }
  return results;
}

/// A board, the models of its line and of its core, and what was compared.
template <class Board>
class BoardTest : public ::testing::Test {
 protected:
  BoardTest()
      : row_(find_configuration(Board::kRow)),
        codec_(row_.format),
        host_(1, kClocks),
        model_(row_, Board::kFeatures, Board::kAxis) {}

  void send_bytes(const std::vector<std::uint8_t>& bytes) {
    for (std::uint8_t byte : bytes) {
      host_.send(byte);
      frames_.byte(byte);
    }
  }
  void send(const std::vector<Beat>& packet) { send_bytes(frame(packet)); }
  void send_bad(std::uint8_t byte) {
    host_.send(byte, false);
    frames_.error();
  }
  void send_break() {
    host_.level(false, 20 * kClocks);
    host_.level(true, kClocks);
    frames_.error();
  }
  void pause() {
    host_.level(true, kPause + 2 * kClocks);
    frames_.pause();
  }
  void load() {
    send(coefficients_packet(watertight_bspline(codec_), codec_));
    lattice_ = random_lattice(codec_, random_, {4, 4, 4});
    send(lattice_packet(lattice_));
  }
  std::vector<Beat> vertices(std::size_t count) {
    return vertices_packet(random_vertices(codec_, random_, lattice_.dims, count, true));
  }

  /// Waits for the results of all that was sent, and compares every bit of them.
  void compare() {
    const std::vector<Beat> expected = model_.run(frames_.take());
    host_.wait(16 * expected.size(), kResultClocks);
    host_.level(true, kResultClocks);  // nothing more comes
    const std::vector<std::uint8_t> bytes = host_.take_bytes();
    ASSERT_EQ(bytes.size(), 16 * expected.size());
    const std::vector<Beat> results = read_results(bytes);
    for (std::size_t at = 0; at < expected.size(); ++at) {
      ASSERT_EQ(results[at].words, expected[at].words) << "result " << at;
      ASSERT_EQ(results[at].last, expected[at].last) << "result " << at;
    }
    EXPECT_EQ(host_.framing_errors(), 0);
    compared_ += expected.size();
  }

  /// Whole frames, as a proof that nothing hangs and nothing is out of step.
  void still_works() {
    send(vertices(3));
    const std::size_t before = compared_;
    compare();
    ASSERT_EQ(compared_, before + 3);
  }

  const Configuration& row_;
  WordCodec codec_;
  tb::Random random_{7};
  SerialHost<typename Board::Dut> host_;
  FrameModel frames_;
  model::StreamModel model_;
  LatticeWords lattice_;
  std::size_t compared_ = 0;
};

using Boards = ::testing::Types<Ulx3s, Icebreaker>;

class BoardName {
 public:
  template <class Board>
  static std::string GetName(int) {
    return std::is_same_v<Board, Ulx3s> ? "ulx3s" : "icebreaker";
  }
};
TYPED_TEST_SUITE(BoardTest, Boards, BoardName);

TYPED_TEST(BoardTest, EveryBitOfEveryResult) {
  for (int lattice = 0; lattice < 3; ++lattice) {
    this->load();
    for (int frames = 0; frames < 2; ++frames) {
      this->send(this->vertices(kMostResults));
      ASSERT_NO_FATAL_FAILURE(this->compare());
    }
  }
  EXPECT_EQ(this->compared_, 6 * kMostResults);
  this->RecordProperty("results", static_cast<int>(this->compared_));
}

// Coefficients of every kind, and packets of every kind, good and bad, whole frames all of them.
TYPED_TEST(BoardTest, AnyPackets) {
  this->load();
  for (int round = 0; round < 6; ++round) {
    this->send(coefficients_packet(random_coefficients(this->codec_, this->random_)));
    this->send(this->vertices(8));
    ASSERT_NO_FATAL_FAILURE(this->compare());
    std::vector<Beat> packet;
    for (const Beat& beat : random_packets(this->codec_, this->random_, 4)) {
      packet.push_back(beat);
      if (!beat.last) continue;
      this->send(packet);
      packet.clear();
      ASSERT_NO_FATAL_FAILURE(this->compare());
    }
  }
  this->load();
  for (const BadPacket& bad : bad_packets(this->codec_, this->random_, this->lattice_)) {
    this->send(bad.packet);
    this->send(this->vertices(1));
    ASSERT_NO_FATAL_FAILURE(this->compare()) << bad.name;
  }
  EXPECT_GT(this->compared_, 48U);
}

// A frame of vertices that ends after each number of bytes up to its second beat.
TYPED_TEST(BoardTest, FrameBrokenOffByAPause) {
  this->load();
  const std::vector<std::uint8_t> whole = frame(this->vertices(3));
  for (std::size_t bytes = 1; bytes <= 2 + 16 * 2 + 1; ++bytes) {
    this->send_bytes({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes)});
    this->pause();
    ASSERT_NO_FATAL_FAILURE(this->compare()) << bytes << " bytes";
    ASSERT_NO_FATAL_FAILURE(this->still_works()) << bytes << " bytes";
  }
  EXPECT_GE(this->compared_, 3U * 35);
}

TYPED_TEST(BoardTest, FrameBrokenOffByABadCharacter) {
  this->load();
  const std::vector<std::uint8_t> whole = frame(this->vertices(3));
  for (std::size_t bytes : {0, 1, 2, 17, 18, 19, 34, 40}) {
    for (bool with_break : {false, true}) {
      this->send_bytes({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes)});
      if (with_break) {
        this->send_break();
      } else {
        this->send_bad(0x5a);
      }
      this->send_bytes(whole);  // not heard: no pause yet
      this->pause();
      ASSERT_NO_FATAL_FAILURE(this->compare()) << bytes << " bytes";
      ASSERT_NO_FATAL_FAILURE(this->still_works()) << bytes << " bytes";
    }
  }
  EXPECT_GE(this->compared_, 3U * 16);
}

// Loads that are broken off: the old lattice and the old coefficients stay.
TYPED_TEST(BoardTest, LoadsBrokenOff) {
  this->load();
  const std::vector<Beat> loads[] = {
      lattice_packet(random_lattice(this->codec_, this->random_, {4, 4, 4})),
      coefficients_packet(random_coefficients(this->codec_, this->random_))};
  for (const std::vector<Beat>& packet : loads) {
    const std::vector<std::uint8_t> whole = frame(packet);
    for (std::size_t bytes : {std::size_t{3}, std::size_t{60}, whole.size() - 1}) {
      this->send_bytes({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(bytes)});
      this->pause();
      ASSERT_NO_FATAL_FAILURE(this->still_works());
    }
    this->send(packet);
    ASSERT_NO_FATAL_FAILURE(this->still_works());
  }
}

TYPED_TEST(BoardTest, NoiseOnTheLine) {
  this->load();
  for (int round = 0; round < 12; ++round) {
    for (std::uint64_t bytes = this->random_.between(1, 50); bytes > 0; --bytes) {
      const auto byte = static_cast<std::uint8_t>(this->random_.below(256));
      if (this->random_.chance(0.05)) {
        this->send_bad(byte);
      } else {
        this->send_bytes({byte});
      }
    }
    this->host_.level(false, 1);  // too short for a start bit
    this->pause();
    ASSERT_NO_FATAL_FAILURE(this->compare());
    ASSERT_NO_FATAL_FAILURE(this->still_works());
  }
}

// More than the rule allows: results are lost to a full core, but never the step.
TYPED_TEST(BoardTest, TooManyAtOnce) {
  this->load();
  ASSERT_NO_FATAL_FAILURE(this->still_works());
  const auto many = random_vertices(this->codec_, this->random_, this->lattice_.dims, 200);
  const auto packet = vertices_packet(many, OutsideMode::kClamp, Results::kDerivatives);
  for (std::uint8_t byte : frame(packet)) this->host_.send(byte);
  this->host_.level(true, 160 * 160 * kClocks);  // all that a core can hold
  const std::size_t bytes = this->host_.take_bytes().size();
  if ((TypeParam::kFeatures & model::kDerivativesFeature) != 0) {
    EXPECT_GT(bytes, 0U);
    EXPECT_LT(bytes, 16 * 4 * many.size());
  } else {
    EXPECT_EQ(bytes, 0U);  // derivatives are refused
  }
  this->pause();
  this->load();
  ASSERT_NO_FATAL_FAILURE(this->still_works());
}

}  // namespace
}  // namespace hwffd::test
