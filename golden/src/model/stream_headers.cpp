// What a stream model knows of a header before anything of its packet is done.
#include "hwffd/model/stream_model.hpp"

namespace hwffd::model {

/// Whether the core has what a header asks for.
bool StreamModel::known(const Beat& header) const {
  const std::uint32_t asked = header.words[2] >> 8 & 3;
  const bool results = asked == static_cast<std::uint32_t>(Results::kDerivatives)
                           ? has(kDerivativesFeature)
                       : has_determinant(static_cast<Results>(asked)) ? has(kDeterminantFeature)
                                                                      : true;
  switch (static_cast<Opcode>(header.words[0] & 0xFF)) {
    case Opcode::kCoefficients:
      return has(kDerivativesFeature) || (header.words[2] & kDerivativesFollow) == 0;
    case Opcode::kSpans: {
      const std::uint32_t axis = header.words[2] >> 22 & 3;
      return has(kSpansFeature) && axis < 3 && (header.words[0] & ~(kEndsSet | 0xFFU)) == 0 &&
             (header.words[2] & 0x7F3300CCU) == 0 && header.words[3] == 0 &&
             (has(kDerivativesFeature) || (header.words[2] & kDerivativesFollow) == 0);
    }
    case Opcode::kLattice:
      return has(kResidentFeature);
    case Opcode::kVertices:
      return has(kResidentFeature) && results;
    case Opcode::kInterleaved:
      return has(kInterleavedFeature) && results;
    case Opcode::kPage:
    case Opcode::kPoints:
      return has(kPagesFeature) && known_of_page(header);
    case Opcode::kPageVertices:
      return has(kPagesFeature) && known_of_page(header) && results;
    case Opcode::kGrid:
      return has(kGridsFeature) && known_grid(header) && results;
    default:
      return false;
  }
}

/// Whether a header of opcodes 5 to 7 has only flags that the core knows, and no bit that means
/// nothing.
bool StreamModel::known_of_page(const Beat& header) const {
  const auto opcode = static_cast<Opcode>(header.words[0] & 0xFF);
  std::uint32_t flags = has(kFourthFeature) ? kFourthFlag : 0;
  if (opcode != Opcode::kPoints && has(kLargeFeature)) flags |= kLargeFlag;
  if (opcode == Opcode::kPageVertices) flags |= kEveryFlag;
  const bool large = (header.words[0] & kLargeFlag) != 0;
  if (opcode == Opcode::kPageVertices && has(kPackedFeature) && !large) flags |= kPackedFlag;
  if (opcode == Opcode::kPageVertices && has(kMarksFeature)) flags |= kCountFlag | kInterruptFlag;
  if (opcode == Opcode::kPageVertices && known_halves(header)) flags |= kHalfFlag;
  const std::uint32_t second = opcode == Opcode::kPage     ? 0x00FFFFFF   // points an axis
                               : opcode == Opcode::kPoints ? 0x0003FFFF   // place
                                                           : 0x00000303;  // results, mode
  const std::uint32_t third = opcode == Opcode::kPage ? 0x7FFFFFFF : 0x000003FF;
  return (header.words[0] & 0xFFFF0000 & ~flags) == 0 && (header.words[2] & ~second) == 0 &&
         (header.words[3] & ~third) == 0;
}

/// The same of opcode 8; without pages there is no page but 0, and no flag.
bool StreamModel::known_grid(const Beat& header) const {
  std::uint32_t flags = 0xFF;
  if (has(kPagesFeature)) {
    flags |= 0xFF00 | (has(kFourthFeature) ? kFourthFlag : 0) |
             (has(kLargeFeature) ? kLargeFlag : 0) |
             (has(kMarksFeature) ? kCountFlag | kInterruptFlag : 0) |
             (known_halves(header) ? kHalfFlag : 0);
  }
  return (header.words[0] & ~flags) == 0 && (header.words[2] & ~0x300U) == 0;
}

/// Whether results of two vertices a beat are possible: positions, or they and det J, without a
/// fourth component.
bool StreamModel::known_halves(const Beat& header) const {
  return has(kHalvesFeature) && (header.words[0] & kFourthFlag) == 0 &&
         can_be_halved(static_cast<Results>(header.words[2] >> 8 & 3));
}

/// Whether the packet under way has two vertices a beat.
bool StreamModel::packed() const {
  const auto opcode = static_cast<Opcode>(header_.words[0] & 0xFF);
  return has(kPackedFeature) && (header_.words[0] & kPackedFlag) != 0 &&
         (opcode == Opcode::kVertices || opcode == Opcode::kPageVertices);
}

/// Of the header, as they stand in word 0, if it is of opcodes 5 to 8; the others have none.
std::uint32_t StreamModel::flags() const {
  const auto opcode = static_cast<Opcode>(header_.words[0] & 0xFF);
  const bool of_page = opcode >= Opcode::kPage && opcode <= Opcode::kGrid;
  return of_page ? header_.words[0] & 0xFFFF0000 : 0;
}

}  // namespace hwffd::model
