#pragma once

#include <vector>

#include "hwffd/cores/evaluator_core.hpp"
#include "recording.hpp"

namespace hwffd::test {

/// What the row's model makes of a stream of commands.
Recording model_answers(const Configuration& row, const std::vector<Beat>& commands);

/// What it makes of a recording of a read port.
Recording model_answers_at_read_port(const Configuration& row, const std::vector<Beat>& beats);

/// The same of results that an evaluator gave.
Recording answers_of(const Configuration& row,
                     const std::vector<cores::EvaluatorCore::Result>& results);

}  // namespace hwffd::test
