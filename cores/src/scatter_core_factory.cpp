#include "hwffd/cores/scatter_core_factory.hpp"

#include "Vhwffd_scatter_core.h"
#include "Vhwffd_scatter_rows_core.h"
#include "hwffd/cores/verilated_stream_core.hpp"

namespace hwffd::cores {

bool has_scatter_core() { return true; }

std::unique_ptr<StreamCore> make_scatter_core(bool rows, std::uint64_t seed) {
  if (rows) return std::make_unique<VerilatedStreamCore<Vhwffd_scatter_rows_core>>(seed);
  return std::make_unique<VerilatedStreamCore<Vhwffd_scatter_core>>(seed);
}

}  // namespace hwffd::cores
