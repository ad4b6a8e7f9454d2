#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "design.hpp"
#include "hwffd/cores/lanes.hpp"
#include "port_recorder.hpp"
#include "running_core.hpp"
#include "schedule_probes.hpp"
#include "signal_table.hpp"

namespace hwffd::web {

/// What goes through a core again and again: packets of vertices of a lattice that it has, and what
/// must come back.
struct Traffic {
  std::vector<Beat> commands;
  std::vector<Beat> results;  ///< one a vertex, in the order of the mesh or of its rows
};

/// A core in one of its clocks, and what its last clocks were.
struct Snapshot {
  std::uint64_t clock = 0;
  std::vector<std::uint8_t> busy;  ///< of each block of the row's design, 0 or 1
  std::uint64_t vertices = 0;      ///< that have come back
  std::uint64_t mismatches = 0;    ///< words of these
  std::uint64_t first_clock = 0;   ///< of the timeline
  std::vector<cores::Lane> lanes;  ///< with clocks from that one on
  std::map<std::string, std::string> ports;
};

/// Looks inside a core, clock by clock, while vertices go through it without end.
class Inside {
 public:
  static constexpr std::uint64_t kTimeline = 200;          ///< clocks
  static constexpr std::uint64_t kMostClocks = 1'000'000;  ///< at once

  /// The core must outlive this.
  Inside(RunningCore& core, const Configuration& row);

  /// The core is at rest and has functions and lattice: begins with the first vertex of these.
  void begin(Traffic traffic);
  /// Whether commands have been offered since.
  bool begun() const { return next_ != 0 || vertices_ != 0; }
  /// Some clocks. Throws Error unless they are 1 to kMostClocks.
  void run(std::uint64_t clocks);
  /// Until one more vertex has come back. Throws Error if none does.
  void run_vertex();

  void watch(const std::vector<std::string>& names) { recorder_.watch(names); }
  std::string vcd() const { return recorder_.vcd(); }
  Snapshot snapshot() const;
  const SignalTable& signals() const { return signals_; }

 private:
  /// What a block is lit by.
  struct Light {
    std::vector<cores::Signal> signals;
    std::vector<std::string> lanes;  ///< words of their names
    bool on = false;                 ///< by a signal, in the last clock
  };

  void clock();
  void check(const Beat& result);

  RunningCore& core_;
  const Configuration& row_;
  SignalTable signals_;
  ScheduleProbes probes_;
  PortRecorder recorder_;
  std::vector<Light> lights_;
  Traffic traffic_;
  std::size_t next_ = 0;  ///< command
  std::uint64_t vertices_ = 0;
  std::uint64_t mismatches_ = 0;
};

}  // namespace hwffd::web
