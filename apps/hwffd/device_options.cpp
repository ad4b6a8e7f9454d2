#include "device_options.hpp"

#include <CLI/CLI.hpp>

namespace hwffd::command {

void add_device_options(CLI::App& app, DeviceChoice& choice) {
  CLI::Option* const device =
      app.add_option("--device", choice.device,
                     "what evaluates: reference (default), model, rtl, or a board behind a serial "
                     "line, such as serial:/dev/ttyUSB0, a core under Linux, uio:0, or one that a "
                     "process serves, socket:PATH");
  app.add_option(
         "--org", choice.org,
         "organization of a model, rtl or board: basic (default; of a board what it has as it "
         "comes), cg3, factored/3, ..., or a row of hwffd info, such as basic-fp32-overlapped-fmac")
      ->needs(device);
  app.add_option("--format", choice.format,
                 "number format of a model, rtl or board: fp32 (default), bfp32, fx16, fx17, fx18, "
                 "fx32; a row "
                 "has its own")
      ->needs(device);
}

}  // namespace hwffd::command
