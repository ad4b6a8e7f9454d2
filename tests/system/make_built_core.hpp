#pragma once

#include <cstdint>
#include <memory>

#include "hwffd/cores/verilated_stream_core.hpp"

namespace hwffd::test {

template <class Dut>
std::unique_ptr<cores::StreamCore> make_built_core(std::uint64_t seed) {
  return std::make_unique<cores::VerilatedStreamCore<Dut>>(seed);
}

}  // namespace hwffd::test
