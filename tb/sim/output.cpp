#include "output.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "hwffd/error.hpp"

namespace hwffd::sim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::string& why) {
  throw Error(
      fmt::format("{}: cannot write there: {}; give a folder that can be written to with "
                  "--output",
                  folder.string(), why));
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail(folder, error.message());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, std::strerror(errno));
}

}  // namespace

Output::Output(const Options& options, const Scene& scene)
    : folder_(options.output), mesh_(fs::path(scene.mesh.name()).stem().string()) {
  make_folder(folder_ / "reports");
  make_folder(folder_ / "sim");
}

fs::path Output::report() const { return folder_ / "reports" / "sim.json"; }

fs::path Output::mesh(const std::string& deformation) const {
  return folder_ / "sim" / (stem(deformation) + ".obj");
}

fs::path Output::picture(const std::string& deformation) const {
  return folder_ / "sim" / (stem(deformation) + ".png");
}

fs::path Output::waveform(const std::string& deformation, const std::string& configuration) const {
  return folder_ / "sim" / fmt::format("{}-{}.fst", stem(deformation), configuration);
}

std::string Output::stem(const std::string& deformation) const {
  std::string name = mesh_ + "-" + deformation;
  for (const char c : {':', '/'}) std::replace(name.begin(), name.end(), c, '-');
  return name;
}

}  // namespace hwffd::sim
