#pragma once

#include <string>
#include <vector>

namespace hwffd {

/// One row of rtl/configurations.csv: one build of `hwffd_stream`.
struct Configuration {
  const char* name;
  const char* org;          ///< organization, e.g. "basic"
  int n;                    ///< control points an organization takes in one clock
  const char* format;       ///< "fp32", "bfp32", or "fx" and the width of a word, e.g. "fx18"
  const char* schedule;     ///< "overlapped" or "paper"
  const char* evaluator;    ///< "pipelined", "iterative", or "powers", the B-spline wired in
  int mul_latency;          ///< clocks of a multiplier
  int add_latency;          ///< clocks of an adder
  int fma_latency;          ///< clocks of a fused multiply-add; 0: multiply and add are separate
  int convert_latency;      ///< clocks of a conversion between kinds of number
  const char* tier;         ///< smallest tier that verilates it: "sim", "cover", "test" or "all"
  const char* stream_tier;  ///< and smallest that has it with its streams, or "none"
};

/// Whether vertices follow each other before the one in front has ended; else the paper's schedule.
inline bool overlaps(const Configuration& row) { return row.schedule == std::string("overlapped"); }

/// Whether the evaluator has the B-spline wired in, so that what is loaded is ignored.
inline bool wired_in(const Configuration& row) { return row.evaluator == std::string("powers"); }

/// Every row of the table, in its order, whatever tier this build is.
const std::vector<Configuration>& configurations();

/// The row of that name. Throws std::invalid_argument, which lists the names.
const Configuration& find_configuration(const std::string& name);

/// One row of rtl/gone.csv: an organization or an evaluator that no core has any more.
struct Gone {
  const char* name;
  const char* text;  ///< "cg2 went with 0.3.0: take cg1"
};

/// Every row of the table, in its order.
const std::vector<Gone>& gone_names();

/// That text for the name of an organization that went, or of a row that had what went; else empty.
std::string gone_text(const std::string& name);

}  // namespace hwffd
