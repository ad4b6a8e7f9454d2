#pragma once

#include <string>
#include <vector>

#include "run.hpp"

namespace hwffd::sim {

/// One line of the table; `header` is the line above.
std::string table_header();
std::string table_line(const RunResult& result, const std::string& stream);
/// The line below it where there was a bus.
std::string bus_line(const tb::BusUtilisation& bus);

/// Why a run is no good: what its bench said, or that nothing was compared, results differ from the
/// model or positions are no numbers; empty if all is well.
std::string faults(const RunResult& result);

/// build/reports/sim.json: model, vertices, and one entry a run.
std::string json_report(const Scene& scene, const Options& options,
                        const std::vector<RunResult>& results);

}  // namespace hwffd::sim
