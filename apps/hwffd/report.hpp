#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "geometry.hpp"
#include "hwffd/device/deformer.hpp"
#include "hwffd/lattice/fold.hpp"
#include "stages.hpp"

namespace hwffd::command {

using Json = nlohmann::ordered_json;

/// Writes a report to a file, or "-", standard output.
/// @throws Error if it cannot be written
void write_report(const std::string& path, const Json& report);

/// What `hwffd deform` did.
struct DeformReport {
  const Geometry& geometry;
  const Device& device;
  const std::vector<Stage>& stages;
  const std::vector<StageFolds>& folds;  ///< one a stage; none if nobody asked
  const Deformer::Result& result;
  const std::vector<std::string>& written;
};
Json json_of(const DeformReport& report);
std::string text_of(const DeformReport& report);

Json json_of(const EmbeddingSummary& summary);
/// "7340 vertices: 7200 inside, 140 outside, 0 not converged; worst residual 1.2e-15"
std::string text_of(const EmbeddingSummary& summary);

/// {"verdict": "proved", "text": ..., "volume": ...}
Json json_of(const FoldCheck& check);

/// "4x4x4"
std::string dims_text(const Index3& dims);

}  // namespace hwffd::command
