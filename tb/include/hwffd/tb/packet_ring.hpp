#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hwffd/driver.hpp"
#include "hwffd/stream/beat.hpp"
#include "hwffd/tb/axi_memory.hpp"

namespace hwffd::tb {

/// Command packets in memory and the descriptors that name them: steps 3 and 5 of docs/registers.md
/// section 4, as software does them.
class PacketRing {
 public:
  /// @param buffers  where packets may lie, each behind the one before it
  PacketRing(AxiMemory& memory, Driver& driver, const DescriptorRing& ring,
             const AddressWindow& buffers);

  /// Gives the core the ring, empty; after each reset.
  void open();
  /// Puts each packet (up to its tlast) into memory and a descriptor for it into the ring. The last
  /// packet need not have a tlast: a descriptor ends it anyway. Throws as Driver::push does.
  void put(const std::vector<Beat>& packets);
  /// Puts a descriptor as it is.
  void put_descriptor(std::uint64_t address, std::uint32_t bytes, std::uint32_t flags = 0);
  /// Where the next packet will lie.
  std::uint64_t next_buffer() const { return next_; }
  void set_next_buffer(std::uint64_t address) { next_ = address; }
  /// Where the next descriptor will lie.
  std::uint64_t next_descriptor() const;
  /// First and last byte of the ring.
  AxiMemory::Range ring_range() const;

 private:
  void put_packet(const Beat* beats, std::size_t count);

  AxiMemory& memory_;
  Driver& driver_;
  DescriptorRing ring_;
  AddressWindow buffers_;
  std::uint64_t next_;
};

}  // namespace hwffd::tb
