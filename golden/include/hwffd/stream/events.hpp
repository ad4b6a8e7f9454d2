// Made from rtl/bus/registers.csv by tools/tables/registers.py; changes here are lost.
#pragma once

namespace hwffd::event {

/// What may go wrong in the core and on its buses: bits of ERROR_STATUS
/// (docs/registers.md). Those up to kSaturated and from kPagePoints on are
/// events of the stream.
enum Code : unsigned {
  kUnknownOpcode = 0,
  kPacketShort = 1,
  kPacketLong = 2,
  kNoCoefficients = 3,
  kNoLattice = 4,
  kLatticeSize = 5,
  kCellOutside = 6,
  kCoordinateNan = 7,
  kCoordinateOutside = 8,
  kSaturated = 9,
  kDmaZero = 10,
  kDmaMisaligned = 11,
  kDmaWrap = 12,
  kDmaWindow = 13,
  kDmaDescriptor = 14,
  kDmaReadResponse = 15,
  kDmaWriteResponse = 16,
  kResultOverflow = 17,
  kDmaRing = 18,
  kTimeoutAr = 19,
  kTimeoutR = 20,
  kTimeoutAw = 21,
  kTimeoutW = 22,
  kTimeoutB = 23,
  kPagePoints = 24,
  kSpanBeyond = 25,
  kNoFourth = 26,
  kGridCount = 27,
  kFunctionsSum = 28,
  kPageOverflowed = 29
};

}  // namespace hwffd::event

namespace hwffd {

/// The bit of event_o: those of the DMA lie between in ERROR_STATUS.
constexpr unsigned stream_event(event::Code code) {
  return code <= event::kSaturated ? code : code - event::kPagePoints + 1 + event::kSaturated;
}

/// Kinds of all of them.
constexpr int kErrors = event::kPageOverflowed + 1;

/// Kinds of events of the stream.
constexpr int kStreamEvents = stream_event(event::kPageOverflowed) + 1;

}  // namespace hwffd
