#include "hwffd/tb/throttle.hpp"

#include <stdexcept>

namespace hwffd::tb {

Throttle Throttle::always() { return {Kind::kAlways, 0}; }

Throttle Throttle::gaps(std::uint64_t k) {
  if (k < 2) throw std::invalid_argument("Throttle: gaps need k of at least 2");
  return runs({k - 1, k - 1}, {1, 1}, 0);
}

Throttle Throttle::sparse(std::uint64_t k) {
  if (k < 2) throw std::invalid_argument("Throttle: sparse needs k of at least 2");
  return runs({1, 1}, {k - 1, k - 1}, 0);
}

Throttle Throttle::bernoulli(double p, std::uint64_t seed) {
  if (!(p > 0.0 && p <= 1.0)) throw std::invalid_argument("Throttle: probability not in (0, 1]");
  Throttle throttle(Kind::kBernoulli, seed);
  throttle.probability_ = p;
  return throttle;
}

Throttle Throttle::runs(Length willing, Length unwilling, std::uint64_t seed) {
  for (const Length& length : {willing, unwilling}) {
    if (length.least < 1 || length.most < length.least) {
      throw std::invalid_argument("Throttle: a run needs 1 <= least <= most");
    }
  }
  Throttle throttle(Kind::kRuns, seed);
  throttle.on_length_ = willing;
  throttle.off_length_ = unwilling;
  return throttle;
}

void Throttle::turn() {
  on_ = !on_;
  const Length& length = on_ ? on_length_ : off_length_;
  left_ = length.least == length.most ? length.least : random_.between(length.least, length.most);
}

const std::vector<std::string>& throttle_names() {
  static const std::vector<std::string> names = {"always",    "gaps",   "sparse",
                                                 "bernoulli", "bursts", "long_stall"};
  return names;
}

Throttle make_throttle(const std::string& name, std::uint64_t seed) {
  if (name == "always") return Throttle::always();
  if (name == "gaps") return Throttle::gaps(4);
  if (name == "sparse") return Throttle::sparse(4);
  if (name == "bernoulli") return Throttle::bernoulli(0.5, seed);
  if (name == "bursts") return Throttle::runs({1, 16}, {1, 16}, seed);
  if (name == "long_stall") return Throttle::runs({100, 300}, {200, 500}, seed);
  throw std::invalid_argument("make_throttle: unknown throttle \"" + name + "\"");
}

AxiThrottles AxiThrottles::make(const std::string& name, std::uint64_t seed) {
  Random random(derive_seed(seed, 5));
  std::uint64_t index = 0;
  AxiThrottles throttles;
  for (Throttle* channel :
       {&throttles.aw, &throttles.w, &throttles.b, &throttles.ar, &throttles.r}) {
    const std::string kind = name == "mixed" ? random.pick(throttle_names()) : name;
    *channel = make_throttle(kind, derive_seed(seed, index++));
  }
  return throttles;
}

}  // namespace hwffd::tb
