// What a Verilated model counts of its lines, branches and toggles, for all models of a process
// together.
//
// Stands in for Verilator's own verilated_cov.cpp, which keeps the counters of each instance and of
// each simulation under their full names: a test makes hundreds of cores, and what is asked is only
// whether a line of a module was ever run. Counters are one set a class (cmake/verilate.sh makes
// them so); at the end of the process those of one place in a source are added and written to
// $HWFFD_COVERAGE, as lines with tabs: page, line, column, comment, further lines, count.
// SPDX-License-Identifier: Apache-2.0
#include <verilated.h>
#include <verilated_cov.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string>
#include <tuple>
#include <unordered_map>

namespace {

using Place = std::tuple<std::string, int, int, std::string, std::string>;

/// All counters of the process.
class Counters {
 public:
  /// Adds a counter, unless an earlier instance has; `place` makes what is kept of it.
  template <class MakePlace>
  void add(const std::uint32_t* counter, MakePlace place) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (places_.find(counter) == places_.end()) places_.emplace(counter, place());
  }

  void write() const {
    const char* path = std::getenv("HWFFD_COVERAGE");
    if (path == nullptr) return;
    std::map<Place, std::uint64_t> sums;
    for (const auto& [counter, place] : places_) sums[place] += *counter;
    std::FILE* file = std::fopen(path, "w");
    if (file == nullptr) {
      std::fprintf(stderr, "coverage: cannot write %s\n", path);
      std::_Exit(1);
    }
    for (const auto& [place, count] : sums) {
      const auto& [page, line, column, comment, lines] = place;
      std::fprintf(file, "%s\t%d\t%d\t%s\t%s\t%llu\n", page.c_str(), line, column, comment.c_str(),
                   lines.c_str(), static_cast<unsigned long long>(count));
    }
    std::fclose(file);
  }

 private:
  std::mutex mutex_;
  std::unordered_map<const std::uint32_t*, Place> places_;
};

/// Never destroyed, since models may count until the very end.
Counters& counters() {
  static Counters* all = [] {
    std::atexit([] { counters().write(); });
    return new Counters;
  }();
  return *all;
}

}  // namespace

/// The counter that a model inserts next.
class VerilatedCovImp final : public VerilatedCovContext {
 public:
  VerilatedCovImp() = default;
  ~VerilatedCovImp() override = default;
  const std::uint32_t* next = nullptr;
};

void VerilatedCovContext::_inserti(uint32_t* itemp) VL_MT_SAFE { impp()->next = itemp; }

void VerilatedCovContext::_insertf(const char* /*filename*/, int /*lineno*/) VL_MT_SAFE {}

#define PAIR(n) const char *key##n, const char *value##n
void VerilatedCovContext::_insertp(PAIR(0), PAIR(1), const char* /*key2*/, int line,
                                   const char* /*key3*/, int column, const char* /*key4*/,
                                   const std::string& /*hierarchy*/, PAIR(5), PAIR(6),
                                   PAIR(7)) VL_MT_SAFE {
  static_cast<void>(std::tie(key0, value0, key1, value1, key5, key6, key7));
  counters().add(impp()->next, [=] { return Place{value5, line, column, value6, value7}; });
}
#undef PAIR

VerilatedCovContext* VerilatedContext::coveragep() VL_MT_SAFE {
  if (!m_coveragep) m_coveragep.reset(new VerilatedCovImp);
  return static_cast<VerilatedCovContext*>(m_coveragep.get());
}
