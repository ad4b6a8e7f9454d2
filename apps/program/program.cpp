#include "program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>

#include "hwffd/error.hpp"

namespace hwffd {

void parse_command_line(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    std::exit(app.exit(help));
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; see --help");
  }
}

int run_program(const std::string& name, const std::function<int()>& body) {
  try {
    return body();
  } catch (const Error& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return error.exit_status();
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", name, error.what());
    return 1;
  }
}

void show_rows_done(std::size_t done, std::size_t all) {
  if (isatty(fileno(stderr)) == 0) return;
  fmt::print(stderr, "\r\033[K[{}/{}] rows", done, all);
  if (done == all) fmt::print(stderr, "\r\033[K");
}

}  // namespace hwffd
