#include "answers.hpp"

#include <fmt/format.h>

#include "hwffd/atomic_file.hpp"
#include "recording.hpp"

namespace hwffd::engines {

void write_answers(const std::filesystem::path& folder, const Answers& answers) {
  std::filesystem::create_directories(folder);
  test::write_stream(folder / "results.txt", answers.results);
  write_files({{folder / "events.txt", fmt::format("{}\n", fmt::join(answers.events, " "))}});
}

}  // namespace hwffd::engines
