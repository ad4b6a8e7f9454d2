#include "device_options.hpp"

#include <CLI/CLI.hpp>

namespace hwffd::command {

void add_device_options(CLI::App& app, DeviceChoice& choice) {
  CLI::Option* const device =
      app.add_option("--device", choice.device, "what evaluates: reference (default), model, rtl");
  app.add_option(
         "--org", choice.org,
         "organization of a model or rtl: basic (default), cg3, factored/3, ..., or a row of "
         "hwffd info, such as basic-fp32-overlapped-fmac")
      ->needs(device);
  app.add_option(
         "--format", choice.format,
         "number format of a model or rtl: fp32 (default), bfp32, fx18, fx32; a row has its "
         "own")
      ->needs(device);
}

}  // namespace hwffd::command
