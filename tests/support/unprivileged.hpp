#pragma once

#include <unistd.h>

namespace hwffd {

/// While it lives, a test that root runs is nobody, whom permissions hold. Until then it may
/// prepare a folder that nobody can enter (TempFolder::open_to_all).
class Unprivileged {
 public:
  Unprivileged() : effective_(::geteuid() != 0 || ::seteuid(kNobody) == 0) {}
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;
  ~Unprivileged() {
    if (::getuid() == 0 && ::seteuid(0) != 0) ::_exit(1);
  }

  /// False where root may not become another user.
  bool effective() const { return effective_; }

 private:
  static constexpr uid_t kNobody = 65534;
  bool effective_;
};

}  // namespace hwffd
