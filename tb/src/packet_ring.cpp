#include "hwffd/tb/packet_ring.hpp"

#include <stdexcept>

namespace hwffd::tb {

PacketRing::PacketRing(AxiMemory& memory, Driver& driver, const DescriptorRing& ring,
                       const AddressWindow& buffers)
    : memory_(memory), driver_(driver), ring_(ring), buffers_(buffers), next_(buffers.base) {}

void PacketRing::open() {
  driver_.set_ring(ring_);
  next_ = buffers_.base;
}

std::uint64_t PacketRing::next_descriptor() const {
  return ring_.base + driver_.next_entry() * cores::kAxiBeatBytes;
}

AxiMemory::Range PacketRing::ring_range() const {
  return {ring_.base, ring_.base + (cores::kAxiBeatBytes << ring_.log2_size) - 1};
}

void PacketRing::put(const std::vector<Beat>& packets) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < packets.size(); ++i) {
    if (!packets[i].last && i + 1 != packets.size()) continue;
    put_packet(&packets[first], i + 1 - first);
    first = i + 1;
  }
}

void PacketRing::put_packet(const Beat* beats, std::size_t count) {
  const std::uint64_t bytes = count * cores::kAxiBeatBytes;
  if (bytes > buffers_.limit - next_ + 1) throw std::length_error("PacketRing: buffers are full");
  for (std::size_t i = 0; i < count; ++i) {
    memory_.set_beat(next_ + i * cores::kAxiBeatBytes, beats[i].words);
  }
  put_descriptor(next_, static_cast<std::uint32_t>(bytes));
  next_ += bytes;
}

void PacketRing::put_descriptor(std::uint64_t address, std::uint32_t bytes, std::uint32_t flags) {
  memory_.set_beat(next_descriptor(), {static_cast<std::uint32_t>(address),
                                       static_cast<std::uint32_t>(address >> 32), bytes, flags});
  driver_.push(1);
}

}  // namespace hwffd::tb
