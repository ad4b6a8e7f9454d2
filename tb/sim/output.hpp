#pragma once

#include <filesystem>
#include <string>

#include "options.hpp"
#include "scene.hpp"

namespace hwffd::sim {

/// Where the run's files go, below the folder of --output.
class Output {
 public:
  /// Makes the folders, before anything is simulated. Throws Error where that fails.
  Output(const Options& options, const Scene& scene);

  /// reports/sim.json
  std::filesystem::path report() const;
  /// sim/<mesh>-<deformation>.obj
  std::filesystem::path mesh(const std::string& deformation) const;
  /// sim/<mesh>-<deformation>.png
  std::filesystem::path picture(const std::string& deformation) const;
  /// sim/<mesh>-<deformation>-<configuration>.fst
  std::filesystem::path waveform(const std::string& deformation,
                                 const std::string& configuration) const;

 private:
  std::string stem(const std::string& deformation) const;

  std::filesystem::path folder_;
  std::string mesh_;
};

}  // namespace hwffd::sim
