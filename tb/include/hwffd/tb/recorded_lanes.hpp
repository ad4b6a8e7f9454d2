#pragma once

#include "hwffd/cores/lanes.hpp"
#include "hwffd/tb/schedule_recorder.hpp"

namespace hwffd::tb {

/// A recorded schedule as cores::lanes_of takes it, from a core at rest to its last result.
cores::Schedule schedule_of(const ScheduleRecorder& recorded);

/// Clocks from where an evaluator asks ffd_bench_evaluator for points to where they are there.
int bench_read_latency(const Configuration& row);

}  // namespace hwffd::tb
