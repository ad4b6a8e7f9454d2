#pragma once

#include <functional>
#include <vector>

#include "upset.hpp"

namespace hwffd::upsets {

/// Goes through the traffic once without a fault. At the clock of each upset a copy of the process
/// is made (fork), in which that bit is inverted, and which goes on to the end by itself: so all of
/// the bench is as it was at that clock, and nothing is simulated twice up to it.
class Campaign final : public Trigger {
 public:
  /// @param upsets  in the order of their clocks
  /// @param jobs    copies that run at once
  Campaign(std::vector<Upset> upsets, std::size_t jobs);
  ~Campaign() override;
  Campaign(const Campaign&) = delete;
  Campaign& operator=(const Campaign&) = delete;

  const Upset* due() override;
  void open() override { open_ = true; }
  void close() override { open_ = false; }

  /// Whether this is such a copy. It ends with `report`.
  bool struck() const { return struck_; }
  [[noreturn]] void report(const Verdict& verdict);

  const std::vector<Upset>& upsets() const { return upsets_; }
  /// Of each upset, when all copies have ended. Throws Error where one was never struck, or ended
  /// without a word.
  std::vector<Verdict> verdicts();

 private:
  void read_one();
  void strike();

  std::vector<Upset> upsets_;
  std::size_t jobs_;
  int pipe_[2] = {-1, -1};
  bool open_ = false;
  bool struck_ = false;
  std::uint64_t clock_ = 0;
  std::size_t next_ = 0;
  std::size_t running_ = 0;
  std::vector<Verdict> verdicts_;
  std::vector<bool> reported_;
};

}  // namespace hwffd::upsets
