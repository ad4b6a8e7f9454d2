#include "signal_table.hpp"

#include <fmt/format.h>

#include "hwffd/error.hpp"

namespace hwffd::web {
namespace {

bool is_end(const std::string& instance, const std::string& end) {
  if (instance.size() < end.size()) return false;
  const std::size_t start = instance.size() - end.size();
  return instance.compare(start, end.size(), end) == 0 &&
         (start == 0 || instance[start - 1] == '.');
}

}  // namespace

std::vector<cores::Signal> SignalTable::find(const std::string& name) const {
  const std::size_t colon = name.find(':');
  std::vector<cores::Signal> matches;
  for (const cores::Signal& signal : signals_) {
    if (signal.name == name.substr(colon + 1) && is_end(signal.instance, name.substr(0, colon))) {
      matches.push_back(signal);
    }
  }
  return matches;
}

cores::Signal SignalTable::only(const std::string& name) const {
  const std::vector<cores::Signal> matches = find(name);
  if (!matches.empty()) return matches.front();
  throw Error(
      fmt::format("signal {}: the core does not show it; name it in cores/rtl/ffd_page.vlt", name));
}

}  // namespace hwffd::web
