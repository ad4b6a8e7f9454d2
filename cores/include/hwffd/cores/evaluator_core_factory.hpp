#pragma once

#include <cstdint>
#include <memory>

#include "hwffd/cores/evaluator_core.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::cores {

/// Whether this build (its tier) has the evaluator of a configuration behind its read port.
bool has_evaluator_core(const Configuration& configuration);

/// The evaluator of a configuration, its registers at random values drawn from the seed. Throws
/// std::invalid_argument where `has_evaluator_core` is false.
std::unique_ptr<EvaluatorCore> make_evaluator_core(const Configuration& configuration,
                                                   std::uint64_t seed);

}  // namespace hwffd::cores
