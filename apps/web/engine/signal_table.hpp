#pragma once

#include <string>
#include <vector>

#include "hwffd/cores/signal.hpp"

namespace hwffd::web {

/// The visible signals of a core, by what tables call them: INSTANCE:NAME, where INSTANCE is the
/// end of the hierarchical name, such as u_encoder:valid_q.
class SignalTable {
 public:
  explicit SignalTable(std::vector<cores::Signal> signals) : signals_(std::move(signals)) {}

  /// All of that name, of which there may be several or none.
  std::vector<cores::Signal> find(const std::string& name) const;
  /// The one of that name. Throws Error where there is none.
  cores::Signal only(const std::string& name) const;
  const std::vector<cores::Signal>& all() const { return signals_; }

 private:
  std::vector<cores::Signal> signals_;
};

}  // namespace hwffd::web
