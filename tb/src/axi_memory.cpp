#include "hwffd/tb/axi_memory.hpp"

#include <algorithm>
#include <bitset>
#include <utility>

namespace hwffd::tb {

void AxiMemory::fail_read(std::uint64_t burst, std::uint64_t beat, cores::AxiResponse response) {
  failing_reads_.push_back({false, reads_.size() + burst, beat, response});
}

void AxiMemory::fail_write(std::uint64_t burst, cores::AxiResponse response) {
  failing_writes_.push_back({false, writes_.size() + burst, 0, response});
}

void AxiMemory::fail_read_at(std::uint64_t address, std::uint64_t beat,
                             cores::AxiResponse response) {
  failing_reads_.push_back({true, address, beat, response});
}

void AxiMemory::misplace_last(std::uint64_t burst, std::uint64_t beat) {
  misplaced_[reads_.size() + burst] = beat;
}

void AxiMemory::lengthen_read_at(std::uint64_t address, std::uint64_t beats) {
  surplus_[address] = beats;
}

void AxiMemory::fail_nothing() {
  failing_reads_.clear();
  failing_writes_.clear();
  misplaced_.clear();
  surplus_.clear();
}

void AxiMemory::answer_unasked(cores::AxiResponse response, bool last) {
  cores::AxiReadChannel beat;
  beat.valid = true;
  for (std::uint32_t& word : beat.data) word = random_.word();
  beat.response = response;
  beat.last = last;
  unasked_queue_.push_back(beat);
}

void AxiMemory::forget_open() {
  read_queue_.clear();
  write_queue_.clear();
  answer_queue_.clear();
  data_queue_.clear();
  unasked_queue_.clear();
  unasked_ = false;
  r_ = {};
  b_ = {};
}

std::uint8_t AxiMemory::guard(std::uint64_t address) const {
  return static_cast<std::uint8_t>(derive_seed(seed_, address) >> 24);
}

std::uint8_t AxiMemory::byte(std::uint64_t address) const {
  const auto page = pages_.find(address / kPage);
  return page == pages_.end() ? guard(address) : page->second[address % kPage];
}

void AxiMemory::set_byte(std::uint64_t address, std::uint8_t value) {
  const auto [page, fresh] = pages_.try_emplace(address / kPage);
  if (fresh) {
    const std::uint64_t first = address / kPage * kPage;
    for (std::uint64_t i = 0; i < kPage; ++i) page->second[i] = guard(first + i);
  }
  page->second[address % kPage] = value;
}

cores::AxiData AxiMemory::beat(std::uint64_t address) const {
  cores::AxiData data{};
  for (unsigned i = 0; i < cores::kAxiBeatBytes; ++i) {
    data[i / 4] |= std::uint32_t{byte(address + i)} << (8 * (i % 4));
  }
  return data;
}

void AxiMemory::set_beat(std::uint64_t address, const cores::AxiData& data) {
  for (unsigned i = 0; i < cores::kAxiBeatBytes; ++i) {
    set_byte(address + i, static_cast<std::uint8_t>(data[i / 4] >> (8 * (i % 4))));
  }
}

std::uint64_t AxiMemory::changed_outside(const std::vector<Range>& ranges) const {
  std::uint64_t changed = 0;
  for (const auto& [number, bytes] : pages_) {
    for (std::uint64_t i = 0; i < kPage; ++i) {
      const std::uint64_t address = number * kPage + i;
      if (bytes[i] == guard(address)) continue;
      changed += std::none_of(ranges.begin(), ranges.end(), [&](const Range& range) {
        return range.first <= address && address <= range.second;
      });
    }
  }
  return changed;
}

bool AxiMemory::quiet() const {
  return read_queue_.empty() && write_queue_.empty() && answer_queue_.empty() &&
         data_queue_.empty();
}

void AxiMemory::forget() {
  pages_.clear();
  reads_.clear();
  writes_.clear();
}

void AxiMemory::drive(cores::AxiPins& pins, std::uint64_t cycle) {
  pins.ar.ready = throttles_.ar.willing() && (ar_waits_ || !ready_waits_);
  pins.aw.ready = throttles_.aw.willing() && (aw_waits_ || !ready_waits_);
  pins.w.ready = throttles_.w.willing() && (w_waits_ || !ready_waits_);

  const bool read_willing = throttles_.r.willing();
  if (!r_.valid && read_willing && !read_queue_.empty() && read_queue_.front().due <= cycle) {
    const Open& open = read_queue_.front();
    r_.valid = true;
    r_.data = read_beat(open);
    r_.last = open.done == open.marked;
    r_.response = open.done == open.failing_beat ? open.response : std::uint8_t{cores::kAxiOkay};
  }
  if (!r_.valid && read_queue_.empty() && !unasked_queue_.empty()) {
    r_ = unasked_queue_.front();
    unasked_queue_.pop_front();
    unasked_ = true;
  }
  if (!r_.valid) {  // idle data is garbage
    for (std::uint32_t& word : r_.data) word = random_.word();
    r_.last = random_.chance(0.5);
    r_.response = static_cast<std::uint8_t>(random_.below(4));
  }
  const bool answer_willing = throttles_.b.willing();
  if (!b_.valid && answer_willing && !answer_queue_.empty() && answer_queue_.front().due <= cycle) {
    b_.valid = true;
    b_.response = answer_queue_.front().response;
  }
  if (!b_.valid) b_.response = static_cast<std::uint8_t>(random_.below(4));

  const bool rready = pins.r.ready, bready = pins.b.ready;
  pins.r = r_;
  pins.b = b_;
  pins.r.ready = rready;
  pins.b.ready = bready;
}

AxiMemory::Open AxiMemory::open(const cores::AxiAddressChannel& channel, std::uint64_t cycle,
                                std::vector<Burst>& log, std::vector<Failure>& failures) {
  const std::uint64_t bytes = std::uint64_t{1} << channel.size;
  Open open{channel.address / bytes * bytes,
            bytes,
            channel.len + std::uint64_t{1},
            due(cycle),
            kNever,
            cores::kAxiOkay,
            channel.len,
            log.size()};
  for (const Failure& failure : failures) {
    if (failure.burst == (failure.by_address ? channel.address : log.size())) {
      const std::uint64_t at = failure.beat * cores::kAxiBeatBytes + failure.beat % 2 * 8;
      open.failing_beat = (channel.address + at - open.address) / bytes;
      open.response = failure.response;
    }
  }
  const std::uint64_t span = open.address + open.beats * bytes - channel.address;
  log.push_back({channel.address, span / cores::kAxiBeatBytes, cycle, channel.cache, channel.prot,
                 channel.id});
  return open;
}

cores::AxiBusData AxiMemory::read_beat(const Open& open) const {
  cores::AxiBusData data{};
  for (std::uint64_t i = 0; i < open.bytes; ++i) {
    data[i / 4] |= std::uint32_t{byte(open.address + open.done * open.bytes + i)} << (8 * (i % 4));
  }
  return data;
}

void AxiMemory::write_beat(const Open& open, std::uint64_t beat,
                           const cores::AxiWriteChannel& data) {
  for (std::uint64_t i = 0; i < open.bytes; ++i) {
    if ((data.strobe >> i & 1) == 0) continue;
    set_byte(open.address + beat * open.bytes + i,
             static_cast<std::uint8_t>(data.data[i / 4] >> (8 * (i % 4))));
  }
}

void AxiMemory::commit(std::uint64_t cycle) {
  while (!write_queue_.empty() && data_queue_.size() >= write_queue_.front().beats) {
    Open open = write_queue_.front();
    write_queue_.pop_front();
    std::uint64_t bytes = 0;
    for (std::uint64_t i = 0; i < open.beats; ++i) {
      if (open.response == cores::kAxiOkay) write_beat(open, i, data_queue_.front());
      bytes += std::bitset<32>(data_queue_.front().strobe).count();
      data_queue_.pop_front();
    }
    writes_[open.number].beats = bytes / cores::kAxiBeatBytes;
    open.due = due(cycle);
    if (!early_) answer_queue_.push_back(open);
  }
}

void AxiMemory::observe(const cores::AxiPins& pins, std::uint64_t cycle) {
  if (pins.r.valid && pins.r.ready) {
    r_.valid = false;
    if (!std::exchange(unasked_, false)) {
      ++read_beats_;
      if (++read_queue_.front().done == read_queue_.front().beats) read_queue_.pop_front();
    }
  }
  if (pins.b.valid && pins.b.ready) {
    b_.valid = false;
    answer_queue_.pop_front();
  }
  if (pins.ar.valid && pins.ar.ready) {
    const auto misplaced = misplaced_.find(reads_.size());
    const auto surplus = surplus_.find(pins.ar.address);
    read_queue_.push_back(open(pins.ar, cycle, reads_, failing_reads_));
    Open& read = read_queue_.back();
    if (misplaced != misplaced_.end()) read.marked = misplaced->second;
    if (surplus != surplus_.end()) {
      read.beats += surplus->second;
      read.marked = read.beats - 1;
    }
  }
  if (pins.aw.valid && pins.aw.ready) {
    write_queue_.push_back(open(pins.aw, cycle, writes_, failing_writes_));
    if (early_) answer_queue_.push_back(write_queue_.back());
  }
  if (pins.w.valid && pins.w.ready) {
    ++write_beats_;
    data_queue_.push_back(pins.w);
  }
  ar_waits_ = pins.ar.valid && !pins.ar.ready;
  aw_waits_ = pins.aw.valid && !pins.aw.ready;
  w_waits_ = pins.w.valid && !pins.w.ready;
  commit(cycle);
}

}  // namespace hwffd::tb
