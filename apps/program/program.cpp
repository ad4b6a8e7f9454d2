#include "program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <utility>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kLongestWord = 4096;  // as a path; CLI11 recurses over brackets
constexpr std::size_t kLongestReason = 160;

/// Sees that all which was printed has left, as nobody does after main().
void flush_standard_output() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw Error("standard output: cannot be written; check that it is open and has room");
}

/// Puts something in the place of standard streams that are closed, so that no file opened later
/// gets their numbers and their text. It is open in the other direction: writing still fails.
void hold_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

/// One line on standard error, which may be closed.
void complain(const std::string& name, const char* what) {
  std::fputs(fmt::format("{}: {}\n", name, what).c_str(), stderr);
}

void show_done(const std::string& name, double done, const std::string& rate) {
  if (isatty(fileno(stderr)) == 0) return;
  fmt::print(stderr, "\r\033[K{:<32} {:3.0f} %{}", name, 100 * done, rate);
  if (done >= 1) fmt::print(stderr, "\r\033[K");
}

/// "1.3 M": three digits at most, so that it can be read while it changes.
std::string in_short(double number) {
  const char* unit = "";
  for (const char* larger : {" k", " M", " G"}) {
    if (number < 1000) break;
    number /= 1000;
    unit = larger;
  }
  return fmt::format("{:.{}f}{}", number, number < 10 ? 1 : 0, unit);
}

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
    const int status = app.exit(asked);
    flush_standard_output();
    std::exit(status);
  } catch (const CLI::ParseError& error) {
    throw UsageError(excerpt(error.what(), kLongestReason) + "; see --help");
  }
}

void write_standard_output(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  flush_standard_output();
}

int run_program(const std::string& name, const std::function<int()>& body) {
  hold_standard_streams();
  try {
    const int status = body();
    flush_standard_output();
    return status;
  } catch (const Error& error) {
    complain(name, error.what());
    return error.exit_status();
  } catch (const std::exception& error) {
    complain(name, error.what());
    return 1;
  }
}

int conclude(const std::string& faults) {
  std::fflush(stdout);  // the report first
  fmt::print(stderr, "{}", faults);
  return faults.empty() ? 0 : 1;
}

void show_rows_done(std::size_t done, std::size_t all) {
  if (isatty(fileno(stderr)) == 0) return;
  fmt::print(stderr, "\r\033[K[{}/{}] rows", done, all);
  if (done == all) fmt::print(stderr, "\r\033[K");
}

void show_progress(const std::string& name, double done) { show_done(name, done, ""); }

RatedProgress::RatedProgress(std::string name, double count, std::string things)
    : name_(std::move(name)),
      count_(count),
      things_(std::move(things)),
      begun_(std::chrono::steady_clock::now()) {}

void RatedProgress::operator()(double done) const {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begun_;
  const double rate = count_ * done / seconds.count();
  show_done(name_, done, fmt::format(", {} {}/s", in_short(rate), things_));
}

}  // namespace hwffd
