// hwffd-engines-words: the recorded commands of a row's format, or the packets with which they
// begin, as every engine reads them, and the answers of the model.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "answers.hpp"
#include "hwffd/model/stream_model.hpp"
#include "program.hpp"
#include "recording.hpp"

namespace {

using namespace hwffd;

/// As many packets as have that many beats, at least; all of them where there are fewer.
std::vector<Beat> beginning(std::vector<Beat> beats, std::size_t wanted) {
  for (std::size_t end = wanted; end < beats.size(); ++end) {
    if (beats[end - 1].last) {
      beats.resize(end);
      break;
    }
  }
  return beats;
}

void write(const std::string& name, std::size_t wanted, const std::filesystem::path& folder) {
  const Configuration& row = find_configuration(name);
  const auto beats = beginning(test::read_recorded_stream("commands", row.format), wanted);
  model::StreamModel model(row);
  const std::vector<Beat> results = model.run(beats);
  std::filesystem::create_directories(folder);
  test::write_stream(folder / "beats.hex", beats);
  engines::write_answers(folder / "model", {results, model.events()});
}

}  // namespace

int main(int argc, char** argv) {
  std::string row;
  std::string folder;
  std::int64_t beats = std::numeric_limits<std::int64_t>::max();
  return run_program("hwffd-engines-words", [&] {
    CLI::App app("Writes recorded commands and the model's answers for `make -C lab engines`.");
    app.add_option("--row", row, "of rtl/configurations.csv")->required();
    app.add_option("--folder", folder, "for beats.hex and model/")->required();
    app.add_option("--beats", beats, "as many at least, up to the end of a packet; or all")
        ->check(CLI::Range(std::int64_t{1}, beats));
    parse_command_line(app, argc, argv);
    write(row, static_cast<std::size_t>(beats), folder);
    return 0;
  });
}
