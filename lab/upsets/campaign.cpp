#include "campaign.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "hwffd/error.hpp"

namespace hwffd::upsets {
namespace {

constexpr unsigned kSeconds = 120;  // of a copy; its watchdogs count clocks and end long before

struct Message {
  std::size_t number;
  Verdict verdict;
};

}  // namespace

Campaign::Campaign(std::vector<Upset> upsets, std::size_t jobs)
    : upsets_(std::move(upsets)),
      jobs_(jobs),
      verdicts_(upsets_.size()),
      reported_(upsets_.size(), false) {
  if (upsets_.empty()) throw Error("0 flips were asked for");
  if (pipe(pipe_) != 0) throw Error("no pipe");
}

Campaign::~Campaign() {
  for (int end : pipe_) {
    if (end >= 0) ::close(end);
  }
}

void Campaign::read_one() {
  int status = 0;
  wait(&status);
  --running_;
  // A copy that a signal has ended says nothing, and verdicts() will miss it.
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return;
  Message message;
  if (read(pipe_[0], &message, sizeof message) != sizeof message) throw Error("a run said nothing");
  verdicts_[message.number] = message.verdict;
  reported_[message.number] = true;
}

void Campaign::strike() {
  if (running_ == jobs_) read_one();
  std::fflush(nullptr);
  const pid_t copy = fork();
  if (copy < 0) throw Error("no copy of the process could be made");
  struck_ = copy == 0;
  if (struck_) {
    alarm(kSeconds);
    return;
  }
  ++running_;
  ++next_;
}

const Upset* Campaign::due() {
  if (!open_ || struck_) return nullptr;
  while (next_ < upsets_.size() && upsets_[next_].clock == clock_) {
    strike();
    if (struck_) return &upsets_[next_];
  }
  ++clock_;
  return nullptr;
}

void Campaign::report(const Verdict& verdict) {
  const Message message{next_, verdict};
  const bool whole = write(pipe_[1], &message, sizeof message) == sizeof message;
  _exit(whole ? 0 : 1);
}

std::vector<Verdict> Campaign::verdicts() {
  while (running_ != 0) read_one();
  for (std::size_t i = 0; i < reported_.size(); ++i) {
    if (!reported_[i]) throw Error("flip " + std::to_string(i) + " was not made");
  }
  return verdicts_;
}

}  // namespace hwffd::upsets
