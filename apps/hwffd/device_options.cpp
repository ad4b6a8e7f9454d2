#include "device_options.hpp"

#include <CLI/CLI.hpp>

namespace hwffd::command {

void add_device_options(CLI::App& app, DeviceChoice& choice) {
  app.add_option("--device", choice.device, "what evaluates: model (default), rtl, reference");
  app.add_option(
      "--org", choice.org,
      "organization: basic (default), cg3, factored/3, ..., or a row of hwffd info, such as "
      "basic-fp32-overlapped-fmac");
  app.add_option("--format", choice.format,
                 "number format: fp32 (default), bfp32, fx18, fx32; a row has its own");
}

}  // namespace hwffd::command
