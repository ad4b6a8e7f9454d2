// What a core can do with a packet, from the packet's header alone.
#include <algorithm>
#include <string>

#include "hwffd/driver.hpp"
#include "hwffd/registers.h"
#include "hwffd/stream/packets.hpp"

namespace hwffd {
namespace {

constexpr unsigned kFewestPoints = 4, kSmallPoints = kSmallAxisPoints;

/// What a feature is, and how to do without it.
struct Feature {
  std::uint32_t mask;
  const char* name;
  const char* instead;
  const char* built;  // with which parameter a core has it
};

constexpr Feature kResidentLattices{HWFFD_FEATURES_RESIDENT_MASK, "resident lattices",
                                    "send interleaved vertices", "RESIDENT = 1"};
constexpr Feature kInterleavedVertices{HWFFD_FEATURES_INTERLEAVED_MASK, "interleaved vertices",
                                       "send a lattice and its vertices", "INTERLEAVED = 1"};
constexpr Feature kFunctionDerivatives{HWFFD_FEATURES_DERIVATIVES_MASK, "derivatives",
                                       "send coefficients without theirs", "DERIVATIVES = 1"};
constexpr Feature kResultDerivatives{HWFFD_FEATURES_DERIVATIVES_MASK, "derivatives",
                                     "ask for positions", "DERIVATIVES = 1"};
constexpr Feature kResultDeterminant{HWFFD_FEATURES_DETERMINANT_MASK, "determinant",
                                     "ask for positions", "DETERMINANT = 1"};
constexpr Feature kSeveralPages{HWFFD_FEATURES_PAGES_MASK, "pages",
                                "send whole lattices (opcodes 2, 3)", "PAGED = 1"};
constexpr Feature kPackedVertices{HWFFD_FEATURES_PACKED_MASK, "packed vertices",
                                  "send one vertex a beat", "PACKED = 1"};
constexpr Feature kGrids{HWFFD_FEATURES_GRIDS_MASK, "grids", "send their vertices", "GRIDS = 1"};
constexpr Feature kFunctionSpans{HWFFD_FEATURES_SPANS_MASK, "spans",
                                 "send functions of every cell (opcode 1)", "SPANS above 1"};

/// Flags of a header's word 0 by their bits, from this one on (docs/interface.md section 2).
constexpr unsigned kFirstFlag = 16;
constexpr Feature kFlagged[] = {
    {0, "", "", ""},  // that of its opcode will do
    {HWFFD_FEATURES_FOURTH_MASK, "fourth component", "send it as x of a second lattice",
     "FOURTH = 1"},
    kPackedVertices,
    {HWFFD_FEATURES_LARGE_MASK, "large lattices", "cut the lattice into pages", "AXIS above 32"},
    {HWFFD_FEATURES_MARKS_MASK, "counts a packet", "give each packet a run of its own",
     "MARKS = 1"},
    {HWFFD_FEATURES_MARKS_MASK, "interrupts a packet", "wait for the end of the run", "MARKS = 1"},
    {HWFFD_FEATURES_HALVES_MASK, "results of two vertices a beat", "take a result a beat",
     "HALVES = 1"},
};
/// Which of them opcodes 5 to 9 have.
constexpr std::uint32_t kFlagsOf[] = {0x0A, 0x02, 0x7F, 0x7A, 0x01};

void require(const CoreIdentity& core, const Feature& feature) {
  if ((core.features & feature.mask) == feature.mask) return;
  throw DriverError(std::string("this core has no ") + feature.name + ": " + feature.instead +
                    ", or build it with " + feature.built);
}

void check_results(const CoreIdentity& core, std::uint32_t word) {
  const auto results = static_cast<Results>(word >> 8 & 3);
  if (results == Results::kPosition) return;
  require(core, kResultDerivatives);
  if (has_determinant(results)) require(core, kResultDeterminant);
}

void check_points(const CoreIdentity& core, std::uint32_t word, bool large) {
  const unsigned most = large ? core.points_axis : std::min(core.points_axis, kSmallPoints);
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned points = word >> 8 * axis & 0xFF;
    if (points >= kFewestPoints && points <= most) continue;
    throw DriverError(std::to_string(points) + " points along axis " + "stu"[axis] +
                      ": this core takes " + std::to_string(kFewestPoints) + " to " +
                      std::to_string(most) +
                      (points <= core.points_axis && points > most
                           ? " without flag L of opcode 5"
                           : "; make the lattice smaller, or build with AXIS"));
  }
}

void check_page(const CoreIdentity& core, std::uint32_t word) {
  const unsigned page = word >> 8 & 0xFF;
  if (page < core.pages) return;
  throw DriverError("page " + std::to_string(page) + ": this core has " +
                    std::to_string(core.pages) + ", from 0 on; use one of them, or build with" +
                    " PAGES");
}

void check_spans(const CoreIdentity& core, const PacketHeader& header) {
  const std::uint64_t end = std::uint64_t{header[2] >> 8 & 0xFF} + header[1];
  if (end <= core.spans) return;
  throw DriverError("functions of " + std::to_string(end) + " spans: this core has " +
                    std::to_string(core.spans) + "; send fewer, or build with SPANS");
}

/// Without pages a grid is of the resident lattice, and its header names no page.
void check_grid(const CoreIdentity& core, const PacketHeader& header) {
  require(core, kGrids);
  if ((core.features & HWFFD_FEATURES_PAGES_MASK) != 0) {
    check_page(core, header[0]);
  } else if ((header[0] >> 8) != 0) {
    require(core, kSeveralPages);
  }
  const std::uint64_t vertices =
      std::uint64_t{header[1] & 0xFFFF} * (header[1] >> 16) * (header[3] & 0xFFFF);
  if (vertices == 0) throw DriverError("a grid without a vertex: each count is 1 to 65535");
  if (vertices > std::uint64_t{1} << core.grid_limit) {
    throw DriverError("a grid of " + std::to_string(vertices) + " vertices: this core takes 2^" +
                      std::to_string(core.grid_limit) +
                      "; send it in parts, or build with GRID_LIMIT");
  }
  check_results(core, header[2]);
}

/// Of opcodes 5 to 9; those before have none but P of opcode 3.
void check_flags(const CoreIdentity& core, std::uint32_t word) {
  const unsigned opcode = word & 0xFF;
  const std::uint32_t known = kFlagsOf[opcode - static_cast<unsigned>(Opcode::kPage)];
  for (unsigned flag = 0; flag < 32 - kFirstFlag; ++flag) {
    if ((word >> (kFirstFlag + flag) & 1) == 0) continue;
    if ((known >> flag & 1) == 0) {
      throw DriverError("bit " + std::to_string(kFirstFlag + flag) + " is no flag of opcode " +
                        std::to_string(opcode) + ": clear it");
    }
    require(core, kFlagged[flag]);
  }
}

}  // namespace

void check_packet(const CoreIdentity& core, const PacketHeader& header) {
  const auto opcode = static_cast<Opcode>(header[0] & 0xFF);
  const bool large = (header[0] & kLargeFlag) != 0;
  const bool packed = (header[0] & kPackedFlag) != 0;
  if (opcode >= Opcode::kPage && opcode <= Opcode::kSpans) check_flags(core, header[0]);
  if (packed && large) throw DriverError("packed vertices of a large lattice: send P or L");
  const bool half =
      opcode >= Opcode::kPageVertices && opcode <= Opcode::kGrid && (header[0] & kHalfFlag) != 0;
  const bool fits =
      can_be_halved(static_cast<Results>(header[2] >> 8 & 3)) && (header[0] & kFourthFlag) == 0;
  if (half && !fits) throw DriverError("H is of positions, or of them and det J: clear it");
  switch (opcode) {
    case Opcode::kCoefficients:
      if ((header[2] >> 31) != 0) require(core, kFunctionDerivatives);
      return;
    case Opcode::kLattice:
      require(core, kResidentLattices);
      return check_points(core, header[2], false);
    case Opcode::kVertices:
      require(core, kResidentLattices);
      if (packed) require(core, kPackedVertices);
      return check_results(core, header[2]);
    case Opcode::kInterleaved:
      require(core, kInterleavedVertices);
      return check_results(core, header[2]);
    case Opcode::kPage:
      require(core, kSeveralPages);
      check_page(core, header[0]);
      return check_points(core, header[2], large);
    case Opcode::kPoints:
      require(core, kSeveralPages);
      return check_page(core, header[0]);
    case Opcode::kPageVertices:
      require(core, kSeveralPages);
      check_page(core, header[0]);
      return check_results(core, header[2]);
    case Opcode::kGrid:
      return check_grid(core, header);
    case Opcode::kSpans:
      require(core, kFunctionSpans);
      if ((header[2] >> 31) != 0) require(core, kFunctionDerivatives);
      return check_spans(core, header);
    default:
      throw DriverError("opcode " + std::to_string(header[0] & 0xFF) + ": 1 to " +
                        std::to_string(kOpcodes) + " are known");
  }
}

}  // namespace hwffd
