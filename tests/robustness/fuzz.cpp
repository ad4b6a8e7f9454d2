// Inputs from outside for one reader, as fuzz.py sends them: says its corpus, then answers each
// input. A block is the number of its bytes on a line, and the bytes.
#include "fuzz.hpp"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

/// For an input: of the processor, then the program ends by SIGPROF; of the clock, by SIGALRM.
constexpr int kSeconds = 20;
constexpr unsigned kPatience = 300;

void set_timers(int seconds, unsigned patience) {
  const itimerval timer{{0, 0}, {seconds, 0}};
  ::setitimer(ITIMER_PROF, &timer, nullptr);
  ::alarm(patience);
}

/// Past all buffers, which a process that an input makes would have, too.
void say(const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t bytes = ::write(STDOUT_FILENO, text.data() + written, text.size() - written);
    if (bytes < 0) throw std::runtime_error("nobody listens");
    written += static_cast<std::size_t>(bytes);
  }
}

std::string block(const std::string& text) { return fmt::format("{}\n{}", text.size(), text); }

/// What becomes of an input: "valid", "refused" or "fault", and what the reader said.
std::string answer(const Target& target, const std::string& input) {
  try {
    target.read(input);
    return "valid " + block("");
  } catch (const Error& error) {
    return "refused " + block(error.what());
  } catch (const std::exception& error) {
    return "fault " + block(std::string("another exception: ") + error.what());
  } catch (...) {
    return "fault " + block("something thrown that is no exception");
  }
}

/// Throws what the name of a fault says, to see it found.
void planted(const std::string& fault) {
  struct TwoLines : Error {
    TwoLines() : Error("two lines") {}
    const char* what() const noexcept override { return "two\nlines"; }
  };
  if (fault == "empty") throw Error("");
  if (fault == "lines") throw TwoLines();
  if (fault == "accent") throw Error("caf\xc3\xa9");
  if (fault == "long") throw Error(std::string(501, 'x'));
  if (fault == "exception") throw std::out_of_range("at");
  if (fault == "number") throw 1;
  if (fault == "abort") std::abort();
  if (fault == "time") set_timers(1, 0);
  for (volatile bool endless = fault == "time"; endless;) {
  }
  expect(fault != "expect", "broken");
}

int serve(const std::string& name) {
  std::vector<Target> all = targets();
  all.push_back({"planted", {"text"}, planted});
  for (const Target& target : all) {
    if (name != target.name) continue;
    say(fmt::format("{}\n", target.corpus.size()));
    for (const std::string& seed : target.corpus) say(block(seed));
    std::size_t size = 0;
    while (std::cin >> size) {
      std::string input(size, '\0');
      std::cin.get();
      std::cin.read(input.data(), static_cast<std::streamsize>(size));
      set_timers(kSeconds, kPatience);
      say(answer(target, input));
      set_timers(0, 0);
    }
    return 0;
  }
  fmt::print(stderr, "no target {}\n", name);
  return 2;
}

}  // namespace

void expect(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

}  // namespace hwffd

int main(int argc, char** argv) {
  try {
    return hwffd::serve(argc > 1 ? argv[1] : "");
  } catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 1;
  }
}
