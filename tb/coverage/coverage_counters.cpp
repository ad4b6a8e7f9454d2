// What a Verilated model counts of its lines, branches and toggles, for all models of a process
// together.
//
// Stands in for Verilator's own verilated_cov.cpp, which keeps the counters of each instance and of
// each simulation under their full names: a test makes hundreds of cores, and what is asked is only
// whether a line of a module was ever run. At the end of the process the counters of one place in a
// source are joined and written to $HWFFD_COVERAGE, as lines with tabs: page, line, column,
// comment, further lines, count. The count of a bit is 1 if it has risen and 2 if it has fallen, or
// 3 if both.
//
// Models are compiled in a hurry; what they call at every signal stands here, and is not.
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "counted.hpp"

namespace {

using Place = std::tuple<std::string, int, int, std::string, std::string>;

/// All counters of the process.
class Counters {
 public:
  /// Adds those of a table, unless an earlier instance has.
  void add(const std::uint32_t* counters, const hwffd::Counter* named, std::size_t count) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (known_.insert(named).second) tables_.push_back({counters, named, count});
  }

  void write() const {
    const char* path = std::getenv("HWFFD_COVERAGE");
    if (path == nullptr) return;
    std::FILE* file = std::fopen(path, "w");
    if (file == nullptr) {
      std::fprintf(stderr, "coverage: cannot write %s\n", path);
      std::_Exit(1);
    }
    for (const auto& [place, count] : joined()) {
      const auto& [page, line, column, comment, lines] = place;
      std::fprintf(file, "%s\t%d\t%d\t%s\t%s\t%llu\n", page.c_str(), line, column, comment.c_str(),
                   lines.c_str(), static_cast<unsigned long long>(count));
    }
    std::fclose(file);
  }

 private:
  struct Table {
    const std::uint32_t* counters;
    const hwffd::Counter* named;
    std::size_t count;
  };

  std::map<Place, std::uint64_t> joined() const {
    std::map<Place, std::uint64_t> counts;
    for (const Table& table : tables_) {
      for (std::size_t i = 0; i < table.count; ++i) {
        const hwffd::Counter& counter = table.named[i];
        std::uint64_t& count =
            counts[{counter.page, counter.line, counter.column, counter.comment, counter.lines}];
        const std::uint32_t more = table.counters[counter.index];
        count = std::strncmp(counter.page, "v_toggle/", 9) == 0 ? count | more : count + more;
      }
    }
    return counts;
  }

  std::mutex mutex_;
  std::set<const hwffd::Counter*> known_;
  std::vector<Table> tables_;
};

/// Never destroyed, since models may count until the very end.
Counters& all() {
  static Counters* counters = [] {
    std::atexit([] { all().write(); });
    return new Counters;
  }();
  return *counters;
}

}  // namespace

void hwffd::name_counters(const std::uint32_t* counters, const Counter* named, std::size_t count) {
  all().add(counters, named, count);
}

namespace hwffd {
namespace {

std::uint64_t mask_of(unsigned first, unsigned bits) {
  return ~std::uint64_t{0} >> (64 - bits) << first;
}

}  // namespace

template <class Word>
void settled(std::uint64_t now, Word& before, unsigned first, unsigned bits) {
  const std::uint64_t mask = mask_of(first, bits);
  before = static_cast<Word>((before & ~mask) | (now & mask));
}

template <class Word>
void toggled(std::uint64_t now, Word& before, unsigned first, unsigned bits,
             std::uint32_t* counter) {
  std::uint64_t changed = (now ^ before) & mask_of(first, bits);
  if (changed == 0) return;
  before = static_cast<Word>(before ^ changed);
  for (; changed != 0; changed &= changed - 1) {
    const int bit = __builtin_ctzll(changed);
    counter[bit - static_cast<int>(first)] |= (now >> bit & 1) != 0 ? kRisen : kFallen;
  }
}

template <class Word>
void moved(std::uint64_t now, Word& before, std::uint32_t* counter) {
  if (now != before) *counter |= now > before ? kRisen : kFallen;
  before = static_cast<Word>(now);
}

// Of the words that Verilator makes signals of.
#define HWFFD_COUNTED(Word)                                                              \
  template void settled(std::uint64_t now, Word& before, unsigned first, unsigned bits); \
  template void toggled(std::uint64_t now, Word& before, unsigned first, unsigned bits,  \
                        std::uint32_t* counter);                                         \
  template void moved(std::uint64_t now, Word& before, std::uint32_t* counter);
HWFFD_COUNTED(std::uint8_t)
HWFFD_COUNTED(std::uint16_t)
HWFFD_COUNTED(std::uint32_t)
HWFFD_COUNTED(std::uint64_t)
#undef HWFFD_COUNTED

}  // namespace hwffd
