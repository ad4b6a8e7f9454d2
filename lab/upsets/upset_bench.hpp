#pragma once

// The core that a program has: its class HWFFD_UPSET_CLASS, of HWFFD_UPSET_HEADER, and whether it
// is hwffd_axi, HWFFD_UPSET_AXI.

#include HWFFD_UPSET_HEADER

#include "scenario.hpp"
#include "upset_core.hpp"

namespace hwffd::upsets {

/// A core in its bench.
struct Bench {
  Bench(const Plan& plan, Trigger& trigger)
      : core(plan.seed, trigger), scenario(make_scenario(core, plan)) {}
#if HWFFD_UPSET_AXI
  UpsetAxiCore<HWFFD_UPSET_CLASS> core;
#else
  UpsetStreamCore<HWFFD_UPSET_CLASS> core;
#endif
  std::unique_ptr<Scenario> scenario;
};

}  // namespace hwffd::upsets
