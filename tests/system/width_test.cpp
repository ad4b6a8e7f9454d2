// Buses of 64 and 256 bits: beats become units of 16 bytes and back, in any rhythm, at full rate,
// and the whole core behind them gives the results of the model.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "Vbus_256.h"
#include "Vbus_64.h"
#include "Vbus_jacobian.h"
#include "Vbus_jet.h"
#include "Vunits_in_256.h"
#include "Vunits_in_64.h"
#include "Vunits_out_256.h"
#include "Vunits_out_64.h"
#include "Vunits_out_two.h"
#include "bad_packets.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packed.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"
#include "page_stimulus.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint32_t kLowHalf = 0x0000FFFF, kBoth = 0xFFFFFFFF;

/// What stands on a bus for a clock: of 64 bits two words, of 256 bits eight.
struct BusBeat {
  std::vector<std::uint32_t> words;
  bool upper = true;
  bool last = false;
  bool user = false;
};

/// An upper half that is left out may be anything.
bool operator==(const BusBeat& a, const BusBeat& b) {
  const auto meant = a.words.begin() + (a.upper ? a.words.size() : a.words.size() / 2);
  return a.words.size() == b.words.size() && std::equal(a.words.begin(), meant, b.words.begin()) &&
         a.upper == b.upper && a.last == b.last && a.user == b.user;
}

/// Packets as such a bus carries them.
std::vector<BusBeat> on_bus(const std::vector<Beat>& units, unsigned width) {
  std::vector<BusBeat> beats;
  bool whole = true;  // of 256 bits: the last beat
  for (const Beat& unit : units) {
    if (width == 64) {
      beats.push_back({{unit.words[0], unit.words[1]}, true, false, false});
      beats.push_back({{unit.words[2], unit.words[3]}, true, unit.last, unit.user});
    } else if (whole) {
      beats.push_back({{unit.words.begin(), unit.words.end()}, false, unit.last, unit.user});
      beats.back().words.resize(8);
      whole = unit.last;
    } else {
      std::copy(unit.words.begin(), unit.words.end(), beats.back().words.begin() + 4);
      beats.back().upper = true;
      beats.back().last = unit.last;
      beats.back().user = unit.user;
      whole = true;
    }
  }
  return beats;
}

/// Words of a port, which is a number up to 64 bits and an array above.
void put(QData& port, const std::vector<std::uint32_t>& words) {
  port = words[0] | std::uint64_t{words[1]} << 32;
}
template <class Wide>
void put(Wide& port, const std::vector<std::uint32_t>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) port[i] = words[i];
}
std::vector<std::uint32_t> get(QData port, std::size_t) {
  return {static_cast<std::uint32_t>(port), static_cast<std::uint32_t>(port >> 32)};
}
template <class Wide>
std::vector<std::uint32_t> get(const Wide& port, std::size_t count) {
  std::vector<std::uint32_t> words;
  for (std::size_t i = 0; i < count; ++i) words.push_back(port[i]);
  return words;
}

/// How often either side waits: 0 is never.
struct Waits {
  double source, sink;
};
const Waits kWaits[] = {{0, 0}, {0.5, 0}, {0, 0.5}, {0.3, 0.3}, {0.8, 0.1}, {0.1, 0.8}};

/// Packets of 1 to 9 units, as many odd as even ones.
std::vector<Beat> any_packets(tb::Random& random, int packets) {
  std::vector<Beat> units;
  for (int packet = 0; packet < packets; ++packet) {
    for (std::uint64_t left = 1 + random.below(9); left > 0; --left) {
      Beat unit;
      for (std::uint32_t& word : unit.words) word = random.word();
      unit.last = left == 1;
      unit.user = unit.last && random.chance(0.5);
      units.push_back(unit);
    }
  }
  return units;
}

/// Runs `offer` and `take`, what both sides do in a clock, until all has come.
template <class Dut, class Offer, class Take>
std::uint64_t run(tb::Sim<Dut>& sim, tb::Random& random, const Waits& waits, std::size_t sent_all,
                  std::size_t got_all, Offer offer, Take take) {
  std::size_t sent = 0, got = 0;
  bool offered = false;
  sim->rst = 1;
  sim.tick();
  sim->rst = 0;
  sim.tick();
  const std::uint64_t start = sim.cycle();
  while (got < got_all) {
    offered = sent < sent_all && (offered || !random.chance(waits.source));
    const bool ready = !random.chance(waits.sink);
    const bool taken = offer(offered, sent, ready);
    got += take(ready, got) ? 1 : 0;
    if (offered && taken) {
      ++sent;
      offered = false;
    }
    sim.tick();
    if (sim.cycle() - start > 100'000) throw std::runtime_error("no end");
  }
  return sim.cycle() - start;
}

template <class Dut>
void to_units(unsigned width, std::uint64_t per_unit, std::uint64_t per_beat) {
  for (const Waits& waits : kWaits) {
    tb::Sim<Dut> sim(1);
    tb::Random random(tb::seed_from_environment(3));
    const std::vector<Beat> units = any_packets(random, 300);
    const std::vector<BusBeat> beats = on_bus(units, width);
    const std::uint64_t clocks = run(
        sim, random, waits, beats.size(), units.size(),
        [&](bool valid, std::size_t at, bool ready) {
          const BusBeat& beat = beats[std::min(at, beats.size() - 1)];
          sim->s_beat_valid = valid;
          put(sim->s_beat_data, beat.words);
          sim->s_beat_upper = beat.upper;
          sim->s_beat_last = beat.last;
          sim->m_unit_ready = ready;
          sim->eval();
          return sim->s_beat_ready != 0;
        },
        [&](bool ready, std::size_t at) {
          if (!ready || sim->m_unit_valid == 0) return false;
          EXPECT_EQ(get(sim->m_unit_data, 4),
                    std::vector<std::uint32_t>(units[at].words.begin(), units[at].words.end()));
          EXPECT_EQ(sim->m_unit_last != 0, units[at].last) << at;
          return true;
        });
    if (waits.source + waits.sink == 0) {
      EXPECT_LE(clocks, std::max(per_unit * units.size(), per_beat * beats.size()) + 3);
    }
    sim.tick();
    EXPECT_NE(sim->idle_o, 0);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(Width, BeatsOf64BitsBecomeUnitsABeatAClock) { to_units<Vunits_in_64>(64, 2, 1); }
TEST(Width, BeatsOf256BitsBecomeUnitsAUnitAClock) { to_units<Vunits_in_256>(256, 1, 1); }

/// Units as they are offered: one by one, or two at once in some packets as long as there are two.
std::vector<std::vector<Beat>> offers(const std::vector<Beat>& units, tb::Random& random,
                                      bool any_two) {
  std::vector<std::vector<Beat>> steps;
  bool two = false, first = true;
  for (std::size_t at = 0; at < units.size(); first = steps.back().back().last) {
    if (first) two = any_two && random.chance(0.5);
    steps.push_back({units[at++]});
    if (two && !steps.back()[0].last) steps.back().push_back(units[at++]);
  }
  return steps;
}

template <class Dut>
void to_beats(unsigned width, std::uint64_t per_offer, bool two = false) {
  for (const Waits& waits : kWaits) {
    tb::Sim<Dut> sim(1);
    tb::Random random(tb::seed_from_environment(4));
    const std::vector<Beat> units = any_packets(random, 300);
    const std::vector<BusBeat> beats = on_bus(units, width);
    const std::vector<std::vector<Beat>> steps = offers(units, random, two);
    ASSERT_EQ(steps.size() < units.size() * 9 / 10, two);
    const std::uint64_t clocks = run(
        sim, random, waits, steps.size(), beats.size(),
        [&](bool valid, std::size_t at, bool ready) {
          const std::vector<Beat>& step = steps[std::min(at, steps.size() - 1)];
          std::vector<std::uint32_t> words(8, 0x5EED5EED);
          for (std::size_t unit = 0; unit < step.size(); ++unit) {
            std::copy(step[unit].words.begin(), step[unit].words.end(), &words[4 * unit]);
          }
          words.resize(two ? 8 : 4);
          sim->s_unit_valid = valid;
          put(sim->s_unit_data, words);
          sim->s_unit_two = step.size() == 2;
          sim->s_unit_last = step.back().last;
          sim->s_unit_user = step.back().user;
          sim->m_beat_ready = ready;
          sim->eval();
          return sim->s_unit_ready != 0;
        },
        [&](bool ready, std::size_t at) {
          if (!ready || sim->m_beat_valid == 0) return false;
          const BusBeat got{get(sim->m_beat_data, width / 32), sim->m_beat_upper != 0,
                            sim->m_beat_last != 0, sim->m_beat_user != 0};
          EXPECT_TRUE(got == beats[at]) << at;
          return true;
        });
    if (waits.source + waits.sink == 0) {
      EXPECT_LE(clocks, per_offer * steps.size() + 3);
    }
    sim.tick();
    EXPECT_NE(sim->idle_o, 0);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(Width, UnitsBecomeBeatsOf64BitsABeatAClock) { to_beats<Vunits_out_64>(64, 2); }
TEST(Width, UnitsBecomeBeatsOf256BitsAUnitAClock) { to_beats<Vunits_out_256>(256, 1); }
TEST(Width, TwoUnitsAtOnceBecomeABeatAClock) { to_beats<Vunits_out_two>(256, 1, true); }

/// The upper half of a low half that ends a packet is 0.
TEST(Width, APacketThatEndsInAHalfUnitEndsAWholeOne) {
  tb::Sim<Vunits_in_64> sim(1);
  sim->rst = 1;
  sim.tick();
  sim->rst = 0;
  sim.tick();
  sim->s_beat_valid = 1;
  sim->s_beat_data = 0x123456789ABCDEF0;
  sim->s_beat_last = 1;
  sim->m_unit_ready = 0;
  sim.tick();
  EXPECT_NE(sim->m_unit_valid, 0);
  EXPECT_NE(sim->m_unit_last, 0);
  EXPECT_EQ(get(sim->m_unit_data, 4), (std::vector<std::uint32_t>{0x9ABCDEF0, 0x12345678, 0, 0}));
}

/// A lattice, all that may be wrong with packets, the lattice again, a grid of it, one without
/// vertices, and as many packed vertices.
std::vector<Beat> expanded_packets(const WordCodec& codec, tb::Random& random,
                                   std::size_t vertices) {
  const LatticeWords lattice = random_lattice(codec, random, {5, 5, 5});
  std::vector<Beat> packets = lattice_packet(lattice);
  for (const BadPacket& bad : bad_packets(codec, random, lattice)) append(packets, bad.packet);
  append(packets, lattice_packet(lattice));
  Grid grid = grid_between({0, 0, 0}, {2, 2, 2}, {static_cast<int>(vertices), 1, 2});
  append(packets, grid_packet(grid));
  grid.count[1] = 0;
  append(packets, grid_packet(grid));
  const PackedVertex vertex{{0x4000, 0x10000, 1}, {1, 0, 1}};
  append(packets, packed_packet(std::vector<PackedVertex>(vertices, vertex)));
  return packets;
}

/// Packets of few vertices that ask for a count, an interrupt, both or neither.
std::vector<Beat> marked_packets(const WordCodec& codec, tb::Random& random, int packets) {
  const LatticeWords lattice = random_lattice(codec, random, {4, 4, 4});
  std::vector<Beat> beats = page_packet(1, lattice);
  for (int packet = 0; packet < packets; ++packet) {
    PageVertices how;
    how.count = packet % 2 != 0;
    how.interrupt = packet / 2 % 2 != 0;
    const auto vertices = random_vertices(codec, random, lattice.dims, random.between(1, 3));
    append(beats, page_vertices_packet(1, vertices, how));
  }
  return beats;
}

/// All of these, some times.
std::vector<Beat> all_packets(const WordCodec& codec, tb::Random& random) {
  std::vector<Beat> units;
  for (int i = 0; i < 4; ++i) {
    append(units, random_packets(codec, random, 25));
    append(units, expanded_packets(codec, random, i + 1));
    append(units, marked_packets(codec, random, 6));
  }
  return units;
}

/// A core behind such a bus.
template <class Dut>
class BusCore {
 public:
  explicit BusCore(unsigned width) : width_(width) {
    context_.randReset(2);
    context_.randSeed(7);
    dut_ = std::make_unique<Dut>(&context_);
    dut_->grid_stop_i = 0;
    reset();
  }
  ~BusCore() { dut_->final(); }

  void reset() {
    dut_->s_axis_tvalid = 0;
    dut_->m_axis_tready = 0;
    dut_->aresetn = 0;
    for (int edge = 0; edge < 3; ++edge) clock();
    dut_->aresetn = 1;
    events_ = {};
  }

  /// Sends all that is sent and compares what comes, until the core is idle or `most` beats have
  /// come; the clocks of these. With `wrong_keep` every bit of tkeep that does not count is noise.
  std::vector<std::uint64_t> run(const std::vector<BusBeat>& sent,
                                 const std::vector<BusBeat>& expected, tb::Random& random,
                                 const Waits& waits, bool wrong_keep = false,
                                 std::size_t most = SIZE_MAX) {
    std::vector<std::uint64_t> clocks;
    std::size_t at = 0;
    bool offered = false;
    const auto ends = [&] {
      if (most != SIZE_MAX) return clocks.size() >= std::min(most, expected.size());
      return clocks.size() == expected.size() && at == sent.size() && dut_->idle_o != 0;
    };
    for (std::uint64_t now = 0; !ends(); ++now) {
      if (now == 2'000'000) {
        ADD_FAILURE() << clocks.size() << " of " << expected.size();
        return clocks;
      }
      offered = at < sent.size() && (offered || !random.chance(waits.source));
      offer(offered, sent[std::min(at, sent.size() - 1)], random, wrong_keep);
      dut_->m_axis_tready = !random.chance(waits.sink);
      dut_->eval();
      if (offered && dut_->s_axis_tready != 0) {
        ++at;
        offered = false;
      }
      if (dut_->m_axis_tready != 0 && dut_->m_axis_tvalid != 0) {
        const BusBeat result{get(dut_->m_axis_tdata, width_ / 32),
                             width_ == 64 || dut_->m_axis_tkeep == static_cast<Keep>(kBoth),
                             dut_->m_axis_tlast != 0, dut_->m_axis_tuser != 0};
        if (clocks.size() >= expected.size() || !(result == expected[clocks.size()])) {
          ADD_FAILURE() << "beat " << clocks.size();
          return clocks;
        }
        clocks.push_back(now);
      }
      count_events();
      clock();
    }
    return clocks;
  }

  /// Since the last reset.
  const model::StreamEvents& events() const { return events_; }

 private:
  using Keep = std::remove_reference_t<decltype(std::declval<Dut&>().s_axis_tkeep)>;

  void offer(bool valid, const BusBeat& beat, tb::Random& random, bool wrong_keep) {
    dut_->s_axis_tvalid = valid;
    put(dut_->s_axis_tdata, beat.words);
    // Only bit 16 of the last beat's counts.
    const std::uint32_t keep = beat.upper ? kBoth : kLowHalf;
    const std::uint32_t noise = beat.last ? random.word() & ~(1U << 16) : random.word();
    dut_->s_axis_tkeep = static_cast<Keep>(wrong_keep ? keep ^ noise : keep);
    dut_->s_axis_tlast = beat.last;
  }
  void count_events() {
    for (int bit = 0; bit < kStreamEvents; ++bit) events_[bit] += dut_->event_o >> bit & 1;
    events_[stream_event(event::kSaturated)] += dut_->second_o >> 1 & 1;
  }
  void clock() {
    dut_->aclk = 0;
    dut_->eval();
    dut_->aclk = 1;
    dut_->eval();
    dut_->aclk = 0;
  }

  unsigned width_;
  VerilatedContext context_;
  std::unique_ptr<Dut> dut_;
  model::StreamEvents events_{};
};

constexpr std::uint32_t kBusFeatures = model::kAllFeatures | model::kGridsFeature |
                                       model::kPackedFeature | model::kPagesFeature |
                                       model::kMarksFeature;

/// Packets of every kind, bad ones among them.
template <class Dut>
void whole_core(unsigned width, bool wrong_keep) {
  for (const Waits& waits : {Waits{0, 0}, Waits{0.3, 0.3}}) {
    const Configuration& row = find_configuration("cg1-fx18-overlapped");
    const WordCodec codec(row.format);
    tb::Random random(tb::seed_from_environment(5));
    model::StreamModel model(row, kBusFeatures);
    const std::vector<Beat> units = all_packets(codec, random);
    const std::vector<BusBeat> expected = on_bus(model.run(units), width);
    ASSERT_GT(expected.size(), 50U);
    ASSERT_GT(std::count_if(expected.begin(), expected.end(),
                            [](const BusBeat& beat) { return beat.user; }),
              4);
    BusCore<Dut> core(width);
    core.run(on_bus(units, width), expected, random, waits, wrong_keep);
    EXPECT_EQ(core.events(), model.events());
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(Width, TheCoreBehind64Bits) { whole_core<Vbus_64>(64, false); }
TEST(Width, TheCoreBehind256Bits) { whole_core<Vbus_256>(256, false); }
TEST(Width, OnlyOneBitOfKeepCounts) { whole_core<Vbus_256>(256, true); }

/// Cores that give two of four results in a clock.
struct JacobianBus {
  using Dut = Vbus_jacobian;
  static constexpr const char* kRow = "jacobian3-fx17-overlapped";
  static constexpr std::uint32_t kFeatures =
      kBusFeatures | model::kFourthFeature | model::kHalvesFeature;
};
struct JetBus {
  using Dut = Vbus_jet;
  static constexpr const char* kRow = HWFFD_JET;  // CMakeLists.txt
  static constexpr std::uint32_t kFeatures =
      kBusFeatures & ~std::uint32_t{model::kDeterminantFeature};
};

template <class Bus>
class TwoResults : public testing::Test {
 protected:
  const Configuration& row_ = find_configuration(Bus::kRow);
  WordCodec codec_{row_.format};
  tb::Random random_{tb::seed_from_environment(6)};
  model::StreamModel model_{row_, Bus::kFeatures};
  BusCore<typename Bus::Dut> core_{256};

  /// What of that many vertices of a page is wanted, behind coefficients and the page.
  std::vector<Beat> vertices(std::size_t count, Results results, bool counted) {
    const LatticeWords lattice = random_lattice(codec_, random_, {4, 6, 5});
    PageVertices how;
    how.results = results;
    how.count = counted;
    std::vector<Beat> units =
        coefficients_packet(watertight_bspline(codec_), codec_, Functions::kDerivativesToo);
    append(units, page_packet(1, lattice));
    append(units,
           page_vertices_packet(1, random_vertices(codec_, random_, lattice.dims, count), how));
    return units;
  }
};
using TwoResultsBuses = testing::Types<JacobianBus, JetBus>;
struct RowName {
  template <class Bus>
  static std::string GetName(int) {
    return find_configuration(Bus::kRow).name;
  }
};
TYPED_TEST_SUITE(TwoResults, TwoResultsBuses, RowName);

// Whatever comes between them, and whoever waits. Every event is told, also where both results of a
// clock have it.
TYPED_TEST(TwoResults, BitsAndEventsAreThoseOfOneByOne) {
  const PageCore has{TypeParam::kFeatures};
  for (const Waits& waits : kWaits) {
    this->core_.reset();
    this->model_.reset();
    PagePackets packets(this->codec_, this->random_, has);
    std::vector<Beat> units = all_packets(this->codec_, this->random_);
    append(units, packets.any(120));
    const std::vector<BusBeat> expected = on_bus(this->model_.run(units), 256);
    ASSERT_GT(expected.size(), 300U);
    this->core_.run(on_bus(units, 256), expected, this->random_, waits);
    EXPECT_EQ(this->core_.events(), this->model_.events());
    EXPECT_GT(this->core_.events()[stream_event(event::kSaturated)], 50U);
    ASSERT_FALSE(this->HasFailure());
  }
}

// Four results of each of some vertices, and perhaps a count behind them, which has no partner.
TYPED_TEST(TwoResults, EveryNumberOfVertices) {
  for (std::size_t count = 1; count <= 9; ++count) {
    for (const bool counted : {false, true}) {
      for (const Waits& waits : kWaits) {
        const std::vector<Beat> units = this->vertices(count, Results::kDerivatives, counted);
        const std::vector<BusBeat> expected = on_bus(this->model_.run(units), 256);
        ASSERT_EQ(expected.size(), 2 * count + (counted ? 1 : 0));
        ASSERT_EQ(expected.back().upper, !counted);
        this->core_.run(on_bus(units, 256), expected, this->random_, waits);
        ASSERT_FALSE(this->HasFailure());
      }
    }
  }
}

// Nothing of what was inside is left, not even a half of a beat.
TYPED_TEST(TwoResults, AResetAtAnyBeat) {
  for (int i = 0; i < 40; ++i) {
    const auto results = i % 3 == 0 ? Results::kPosition : Results::kDerivatives;
    for (const std::size_t most : {std::size_t{this->random_.below(7)}, SIZE_MAX}) {
      this->core_.reset();
      this->model_.reset();
      const std::vector<Beat> units = this->vertices(5, results, i % 2 != 0);
      this->core_.run(on_bus(units, 256), on_bus(this->model_.run(units), 256), this->random_,
                      kWaits[i % 6], false, most);
      ASSERT_FALSE(this->HasFailure());
    }
  }
}

// The clocks of the organization, whatever is wanted, over a thousand vertices.
TYPED_TEST(TwoResults, AVertexTakesThreeClocks) {
  constexpr std::size_t kBefore = 100, kVertices = 1000;
  for (const Results results : {Results::kPosition, Results::kDerivatives, Results::kDeterminant,
                                Results::kDeterminantAlone}) {
    const bool determinant =
        results == Results::kDeterminant || results == Results::kDeterminantAlone;
    if (determinant && (TypeParam::kFeatures & model::kDeterminantFeature) == 0) continue;
    this->core_.reset();
    this->model_.reset();
    const std::vector<Beat> units = this->vertices(kBefore + kVertices + 20, results, true);
    const std::vector<BusBeat> expected = on_bus(this->model_.run(units), 256);
    const std::vector<std::uint64_t> clocks =
        this->core_.run(on_bus(units, 256), expected, this->random_, {0, 0});
    ASSERT_FALSE(this->HasFailure());
    const std::size_t each = results_of(results);
    const auto beat_of = [&](std::size_t vertex) { return clocks.at(vertex * each / 2); };
    EXPECT_EQ(beat_of(kBefore + kVertices) - beat_of(kBefore), 3 * kVertices)
        << "results " << static_cast<int>(results);
  }
}

}  // namespace
}  // namespace hwffd::test
