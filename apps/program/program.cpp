#include "program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kLongestWord = 4096;  // as a path; CLI11 recurses over brackets

}  // namespace

void parse_command_line(CLI::App& app, int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word.size() <= kLongestWord) continue;
    throw UsageError(fmt::format("'{}' has {} characters; give at most {}", excerpt(word),
                                 word.size(), kLongestWord));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    std::exit(app.exit(asked));
  } catch (const CLI::ParseError& error) {
    throw UsageError(excerpt(error.what(), 200) + "; see --help");
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

void show_progress(const std::string& name, double done) {
  if (isatty(fileno(stderr)) == 0) return;
  fmt::print(stderr, "\r\033[K{:<32} {:3.0f} %", name, 100 * done);
  if (done >= 1) fmt::print(stderr, "\r\033[K");
}

}  // namespace hwffd
