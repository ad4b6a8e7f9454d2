#pragma once

#include <cstdint>

#include "hwffd/tb/axil_driver.hpp"
#include "hwffd/tb/random.hpp"
#include "register_model.hpp"
#include "register_ports.hpp"

namespace hwffd::test {

/// Most of registers that are there, some of what is not; the two low bits are anything.
std::uint32_t random_address(tb::Random& random);

/// To such an address; some strobes are low.
tb::AxiLiteWrite random_write(tb::Random& random);

/// What the hardware does meanwhile, at random: levels that stay a while, pulses of a clock in that
/// share of all.
void disturb(PortValues& inputs, const HardwarePorts& ports, tb::Random& random, double pulses);

}  // namespace hwffd::test
