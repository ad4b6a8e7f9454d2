#include "hwffd/cores/scatter_core_factory.hpp"

#include "Vtranspose_fx17.h"
#include "Vtranspose_fx17_rows.h"
#include "hwffd/cores/verilated_stream_core.hpp"

namespace hwffd::cores {

bool has_scatter_core() { return true; }

std::unique_ptr<StreamCore> make_scatter_core(bool rows, std::uint64_t seed) {
  if (rows) return std::make_unique<VerilatedStreamCore<Vtranspose_fx17_rows>>(seed);
  return std::make_unique<VerilatedStreamCore<Vtranspose_fx17>>(seed);
}

}  // namespace hwffd::cores
