#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/model/organizations.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"
#include "hwffd/tb/throttle.hpp"

namespace hwffd::test {

/// Bits of a port, whatever Verilator has made of it.
template <class Port>
void put_bits(Port& port, int at, int width, std::uint64_t value) {
  const auto mask = static_cast<Port>(((std::uint64_t{1} << width) - 1) << at);
  port = static_cast<Port>((port & static_cast<Port>(~mask)) |
                           (static_cast<Port>(value << at) & mask));
}
template <std::size_t Words>
void put_bits(VlWide<Words>& port, int at, int width, std::uint64_t value) {
  for (int bit = 0; bit < width; ++bit) {
    std::uint32_t& word = port.at((at + bit) / 32);
    const std::uint32_t mask = std::uint32_t{1} << ((at + bit) % 32);
    word = (value >> bit & 1) != 0 ? word | mask : word & ~mask;
  }
}

/// A layer's sum as the core expands it, in whole numbers that never overflow
/// (docs/numerics.md section 11, Rows).
template <int Width>
class WideExpansion {
 public:
  using Whole = __int128;
  /// C_0 to C_2 of an axis, in units of 2^-(Width-2).
  using Cumulative = std::array<std::int64_t, 3>;

  /// Parts of the four banks of an axis.
  std::array<std::int64_t, 4> expand(const Cumulative& cumulative, std::int64_t sum, bool to_one) {
    std::array<std::int64_t, 4> shares;
    for (int b = 0; b < 3; ++b) {
      const Whole half = Whole{1} << (Width - 3);
      shares[b] = saturate((Whole{cumulative[b]} * sum + half) >> (Width - 2));
    }
    shares[3] = to_one ? sum : 0;
    std::array<std::int64_t, 4> parts = shares;
    for (int b = 1; b < 4; ++b) parts[b] = saturate(Whole{shares[b]} - shares[b - 1]);
    return parts;
  }
  bool saturated() const { return saturated_; }

  /// Modulo 2^35.
  static std::int64_t wrapped(std::int64_t sum) {
    const std::uint64_t top = static_cast<std::uint64_t>(sum) << (64 - model::kScatterSumBits);
    return static_cast<std::int64_t>(top) >> (64 - model::kScatterSumBits);
  }

 private:
  std::int64_t saturate(Whole value) {
    constexpr Whole kMost = (Whole{1} << (model::kScatterSumBits - 1)) - 1;
    const Whole within = std::clamp(value, -kMost - 1, kMost);
    saturated_ |= within != value;
    return static_cast<std::int64_t>(within);
  }
  bool saturated_ = false;
};

/// ffd_scatter_core beside its model: every word of a collect, and of every vertex when it has
/// added, and whether it saturated; with rows, when each has left, and how many layers saturated.
/// `Setup` is a verilated core and its parameters.
template <class Setup>
class ScatterCoreBench {
 public:
  static constexpr int kWidth = Setup::kWidth;
  static constexpr int kPages = Setup::kPages;
  using F = Fixed<kWidth>;
  using Functions = std::array<AxisWords, 3>;

  /// Clocks from a vertex to where it has added.
  static constexpr int kAdded = (Setup::kPowers ? 0 : 1) + 1 +
                                3 * (Setup::kMul + Setup::kAdd)        // weights
                                + 1 + 2 * Setup::kAdd                  // of an axis, cumulated
                                + 3 * (Setup::kMul + 2 * Setup::kAdd)  // parts
                                + 5;

  struct Vertex {
    model::GradientWords words;
    int bank = 0;  ///< of functions
    int page = 0;
    bool saturated = false;  ///< says whoever sends it
    bool last = true;        ///< of its row
  };

  explicit ScatterCoreBench(std::uint64_t seed) : sim_(seed), random_(seed) {
    Configuration row = find_configuration(Setup::kPowers ? "affine-fx17-overlapped-powers"
                                                          : "affine-fx17-overlapped");
    format_ = "fx" + std::to_string(kWidth);
    row.format = format_.c_str();
    for (auto& model : models_) model = model::make_scatter_model(row);
    for (int page = 0; page < kPages; ++page) redraw(page);
    reset(3);
  }

  /// A reset of so many clocks, at any moment: nothing is inside, all sums are zero.
  void reset(int clocks) {
    sim_->rst = 1;
    for (int i = 0; i < clocks; ++i) sim_.tick();
    clock_ += clocks;
    sim_->rst = 0;
    sim_->begin_i = 0;
    sim_->s_vertex_valid = 0;
    sim_->s_collect_valid = 0;
    vertex_.reset();
    due_.clear();
    row_.clear();
    rows_.clear();
    planned_.clear();
    expected_layers_ = saturated_layers_;
    words_.clear();
    inside_ = {};
    collected_ = -1;
    for (int page = 0; page < kPages; ++page) redraw(page);
  }

  /// Functions of a bank; only while no vertex of that bank is inside.
  void load(int bank, const Functions& functions) {
    for (int axis = 0; axis < 3; ++axis) {
      models_[bank]->load(axis, functions[axis]);
      model::CoefficientBank<F>& entries = functions_[bank];
      for (int l = 0; l < 4; ++l) {
        const AxisWords& words = functions[axis];
        entries.load(axis, l, words.degree, words.shift, words.word[l]);
        entries.load_derivative(axis, l, words.degree, words.derivative.shift,
                                words.derivative.word[l]);
        load_entry(axis, 4 * bank + l, entries.entry[axis][l]);
        load_entry(axis, 8 + 4 * bank + l, entries.derivative[axis][l]);
      }
    }
  }

  // ---- what happens in the next clock

  bool offering() const { return vertex_.has_value(); }
  /// A vertex, which stays until it is taken.
  void offer(const Vertex& vertex) {
    vertex_ = vertex;
    sim_->s_vertex_valid = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const bool derivative = axis == vertex.words.derivative;
      number(sim_->s_vertex_coordinates, axis, F::coordinate(vertex.words.local[axis]));
      number(sim_->s_vertex_gradient, axis, F::point(vertex.words.gradient[axis]));
      put_bits(sim_->s_vertex_cell, axis * Setup::kAxisBits, Setup::kAxisBits,
               static_cast<std::uint64_t>(vertex.words.cell[axis]));
      put_bits(sim_->s_vertex_bank, 2 * axis, 2,
               static_cast<std::uint64_t>(vertex.bank) + (derivative ? 2 : 0));
    }
    sim_->s_vertex_along = static_cast<std::uint8_t>(vertex.words.derivative + 1);
    sim_->s_vertex_page = static_cast<std::uint8_t>(vertex.page);
    sim_->s_vertex_saturated = vertex.saturated;
    sim_->s_vertex_last = vertex.last;
  }

  /// A vertex or, of a core with rows, a row of some, of which none is offered yet.
  void plan(int page) {
    if constexpr (Setup::kRows) {
      for (const Vertex& vertex : draw_row(page)) planned_.push_back(vertex);
    } else {
      planned_.push_back(draw(page));
    }
  }
  void plan(const std::vector<Vertex>& vertices) {
    planned_.insert(planned_.end(), vertices.begin(), vertices.end());
  }
  bool planned() const { return !planned_.empty(); }
  std::size_t planned_count() const { return planned_.size(); }
  void offer_planned() {
    offer(planned_.front());
    planned_.pop_front();
  }
  /// Whether no vertex of a page is inside or offered, and no collect of it under way.
  bool free(int page) const {
    return inside_[page] == 0 && collected_ != page && !(vertex_ && vertex_->page == page) &&
           (planned_.empty() || planned_.front().page != page);
  }
  bool may_begin(int page) { return free(page) && sim_->sweeping_o == 0; }
  bool may_collect(int page) { return free(page) && collected_ < 0; }
  bool collected(int page) const { return collected_ == page; }
  void begin(int page) {
    sim_->begin_i = 1;
    sim_->begin_page_i = static_cast<std::uint8_t>(page);
    pages_[page]->begin();
    redraw(page);
  }
  void collect(int page, int shift) {
    collected_ = page;
    sim_->s_collect_valid = 1;
    sim_->s_collect_page = static_cast<std::uint8_t>(page);
    sim_->s_collect_shift = static_cast<std::uint8_t>(shift);
    for (int axis = 0; axis < 3; ++axis) {
      put_bits(sim_->s_collect_tops, axis * Setup::kAxisBits, Setup::kAxisBits,
               static_cast<std::uint64_t>(dims_[page][axis] - 1));
    }
  }

  /// One clock, in which words of a collect are taken or not.
  void clock(bool takes = true) {
    sim_->m_word_ready = takes;
    watch();
    const bool enters = sim_->s_vertex_valid != 0 && sim_->s_vertex_ready != 0;
    const bool collects = sim_->s_collect_valid != 0 && sim_->s_collect_ready != 0;
    if (enters) enter();
    if (collects) expect_words();
    if (takes && sim_->m_word_valid != 0) take_word();
    sim_.tick();
    ++clock_;
    sim_->begin_i = 0;
    if (enters) sim_->s_vertex_valid = 0;
    if (collects) sim_->s_collect_valid = 0;
    if (collected_ >= 0 && sim_->s_collect_valid == 0 && sim_->collecting_o == 0) {
      redraw(collected_);
      collected_ = -1;
    }
    entered_ = enters;
  }

  bool entered() const { return entered_; }  ///< a vertex, in the last clock
  bool idle() { return sim_->idle_o != 0 && !offering() && sim_->s_collect_valid == 0; }
  bool sweeping() { return sim_->sweeping_o != 0; }
  bool ready() { return sim_->s_vertex_ready != 0; }
  std::uint64_t clocks() const { return clock_; }

  /// Until nothing is inside.
  void drain(tb::Throttle sink = tb::Throttle::always()) {
    const std::uint64_t limit = clock_ + 1'000'000;
    while (!idle()) {
      clock(sink.willing());
      if (clock_ > limit) throw std::runtime_error("it never becomes idle");
    }
  }

  // ---- what to send

  const std::array<int, 3>& dims(int page) const { return dims_[page]; }
  /// A lattice of a page that is zero.
  void resize(int page, const std::array<int, 3>& dims) {
    dims_[page] = dims;
    pages_[page] = std::make_unique<model::ScatterPage>(kWidth, dims);
  }

  /// Anywhere in the page, or in the cell of the one before; now and then on a face or as large as
  /// can be.
  Vertex draw(int page) {
    Vertex vertex;
    vertex.page = page;
    vertex.bank = random_.chance(0.5) ? 1 : 0;
    vertex.words.derivative = static_cast<int>(random_.below(4)) - 1;
    vertex.saturated = random_.chance(0.02);
    const bool again = random_.chance(0.5);
    const auto size = static_cast<unsigned>(random_.below(31));
    for (int axis = 0; axis < 3; ++axis) {
      const auto cells = static_cast<std::uint64_t>(dims_[page][axis] - 3);
      int& cell = last_cell_[page][axis];
      if (!again || cell >= static_cast<int>(cells)) cell = static_cast<int>(random_.below(cells));
      vertex.words.cell[axis] = cell;
      vertex.words.local[axis] = static_cast<std::uint32_t>(random_.below(0x80000001));
      if (random_.chance(0.1)) vertex.words.local[axis] = random_.chance(0.5) ? 0 : 0x80000000;
      const auto bits = static_cast<std::int32_t>(random_.word());
      vertex.words.gradient[axis] = static_cast<std::uint32_t>(bits >> size);
      if (random_.chance(0.05)) vertex.words.gradient[axis] = 0x80000000;
      if (random_.chance(0.02)) vertex.words.gradient[axis] = 0x7FFFFFFF;
    }
    return vertex;
  }

  /// Of the same t and u, in one direction along s, some cells further or none from one to the
  /// next.
  std::vector<Vertex> draw_row(int page) {
    std::vector<Vertex> row(random_.between(1, random_.chance(0.3) ? 40 : 6));
    const Vertex first = draw(page);
    const auto cells = dims_[page][0] - 3;
    const int direction = random_.chance(0.5) ? 1 : -1;
    const auto furthest = random_.below(6);
    int cell = first.words.cell[0];
    for (Vertex& vertex : row) {
      vertex = draw(page);
      const std::uint32_t s = vertex.words.local[0];
      const auto gradient = vertex.words.gradient;
      const bool saturated = vertex.saturated;
      vertex = first;
      vertex.words.local[0] = s;
      vertex.words.gradient = gradient;
      vertex.saturated = saturated;
      vertex.last = false;
      vertex.words.cell[0] = cell;
      if (random_.chance(0.5)) cell += direction * static_cast<int>(random_.below(furthest + 1));
      cell = std::clamp(cell, 0, cells - 1);
    }
    row.back().last = true;
    return row;
  }

  // ---- what was found

  std::uint64_t checked_words() const { return checked_words_; }  ///< points of collects
  std::uint64_t checked_vertices() const { return checked_vertices_; }
  std::uint64_t saturated_vertices() const { return saturated_vertices_; }
  std::uint64_t saturated_words() const { return saturated_words_; }
  std::uint64_t checked_rows() const { return checked_rows_; }
  std::uint64_t saturated_layers() const { return saturated_layers_; }
  std::uint64_t mismatches() const { return mismatches_; }
  const std::string& first_mismatch() const { return first_mismatch_; }

  /// Adds 1 to what the model expects of the next point: a fault that must be found.
  void plant() { planted_ = true; }

 private:
  struct Due {
    std::uint64_t clock;
    int page;
    bool saturated;
  };
  struct Word {
    model::ResultWords words;
    bool last;
  };

  void redraw(int page) {
    // Now and then of any size; small ones are read out more often.
    const int most = random_.chance(0.2) ? Setup::kAxis : std::min(Setup::kAxis, 7);
    std::array<int, 3> dims{};
    for (int& points : dims) {
      points = static_cast<int>(random_.between(4, static_cast<std::uint64_t>(most)));
    }
    resize(page, dims);
  }

  template <class Port>
  void number(Port& port, int place, const typename F::Number& value) {
    put_bits(port, (kWidth + 1) * place, kWidth, static_cast<std::uint64_t>(value.value));
    put_bits(port, (kWidth + 1) * place + kWidth, 1, value.saturated ? 1 : 0);
  }

  void load_entry(int axis, int address, const typename model::CoefficientBank<F>::Entry& entry) {
    sim_->load_i = 1;
    sim_->load_axis_i = static_cast<std::uint8_t>(axis);
    sim_->load_address_i = static_cast<std::uint8_t>(address);
    for (int power = 0; power < 4; ++power) {
      number(sim_->load_entry_i, power, entry.coefficient[power]);
    }
    put_bits(sim_->load_entry_i, 4 * (kWidth + 1), 2, static_cast<std::uint64_t>(entry.shift));
    clock();
    sim_->load_i = 0;
  }

  void enter() {
    const Vertex& vertex = *vertex_;
    if constexpr (Setup::kRows) {
      if (row_.empty()) ++inside_[vertex.page];
      row_.push_back(vertex);
      due_.push_back({0, vertex.page, along_s(vertex).second});
      if (vertex.last) end_row();
    } else {
      const model::VertexParts parts = models_[vertex.bank]->parts(vertex.words);
      pages_[vertex.page]->add(vertex.words.cell, parts);
      due_.push_back({clock_ + kAdded, vertex.page, parts.saturated || vertex.saturated});
      ++inside_[vertex.page];
    }
    vertex_.reset();
  }

  std::array<model::CumulativeWeights<F>, 3> cumulative_of(const Vertex& vertex) const {
    model::LocalVertex<F> local;
    local.cell = vertex.words.cell;
    local.derivative = vertex.words.derivative;
    for (int axis = 0; axis < 3; ++axis)
      local.local[axis] = F::coordinate(vertex.words.local[axis]);
    return model::cumulative_of<F>(local, functions_[vertex.bank], Setup::kPowers);
  }

  /// What a vertex of a row adds to the sums of its four layers, and whether it saturated.
  using AlongS = std::array<std::array<std::int64_t, 4>, 3>;  ///< of a component and a bank
  std::pair<AlongS, bool> along_s(const Vertex& vertex) const {
    const auto cumulative = cumulative_of(vertex)[0];
    AlongS result;
    bool saturated = vertex.saturated;
    for (int c = 0; c < 3; ++c) {
      const auto parts = model::expanded<model::RoundedParts<F>>(
          cumulative, F::point(vertex.words.gradient[c]), vertex.words.derivative != 0);
      for (int b = 0; b < 4; ++b) {
        result[c][b] = parts[b].value;
        saturated |= parts[b].saturated;
      }
    }
    return {result, saturated};
  }

  void end_row() {
    using Expansion = WideExpansion<kWidth>;
    const Vertex& of_row = row_.front();
    const auto& cell = of_row.words.cell;
    std::array<typename Expansion::Cumulative, 3> weights;
    bool weights_saturated = false;
    const auto cumulative = cumulative_of(of_row);
    for (int axis = 1; axis < 3; ++axis) {
      for (int b = 0; b < 3; ++b) {
        weights[axis][b] = cumulative[axis][b].value;
        weights_saturated |= cumulative[axis][b].saturated;
      }
    }
    for (int layer = 0; layer < dims_[of_row.page][0]; ++layer) {
      std::array<std::int64_t, 3> sum{};
      int touched = -1;  // the cell of a vertex that has the layer
      for (const Vertex& vertex : row_) {
        const int own = vertex.words.cell[0];
        if (own > layer || layer > own + 3) continue;
        touched = own;
        const AlongS parts = along_s(vertex).first;
        for (int c = 0; c < 3; ++c) sum[c] = Expansion::wrapped(sum[c] + parts[c][layer % 4]);
      }
      if (touched < 0) continue;
      Expansion expansion;
      model::VertexParts wide;
      for (int c = 0; c < 3; ++c) {
        const auto of_t = expansion.expand(weights[1], sum[c], of_row.words.derivative != 1);
        for (int t = 0; t < 4; ++t) {
          const auto of_u = expansion.expand(weights[2], of_t[t], of_row.words.derivative != 2);
          for (int u = 0; u < 4; ++u) {
            const int m = model::local_of_bank(t, cell[1]);
            const int n = model::local_of_bank(u, cell[2]);
            wide.parts[16 * (layer - touched) + 4 * m + n][c] = of_u[u];
          }
        }
      }
      pages_[of_row.page]->add({touched, cell[1], cell[2]}, wide);
      if (expansion.saturated() || weights_saturated) ++expected_layers_;
    }
    rows_.push_back(of_row.page);
    row_.clear();
  }

  void expect_words() {
    model::ScatterPage& page = *pages_[collected_];
    const auto shift = static_cast<int>(sim_->s_collect_shift);
    const auto& dims = dims_[collected_];
    const std::size_t points = static_cast<std::size_t>(dims[0]) * dims[1] * dims[2];
    std::vector<bool> saturated(points);
    for (std::size_t point = 0; point < points; ++point) {
      for (int c = 0; c < 3; ++c) {
        // Rounded half up to a multiple of 2^shift, which 32 bits hold.
        const std::int64_t rounded = page.sum(point, c) + ((std::int64_t{1} << shift) >> 1);
        const std::int64_t most = (std::int64_t{1} << (31 + shift)) - 1;
        if (rounded > most || rounded < -most - 1) saturated[point] = true;
      }
    }
    const auto results = page.collect(shift);
    for (std::size_t point = 0; point < points; ++point) {
      words_.push_back({results[point], point + 1 == points});
      words_.back().words.saturated = saturated[point];
    }
  }

  void take_word() {
    if (words_.empty()) return mismatch("a word that nobody collects");
    Word want = words_.front();
    words_.pop_front();
    if (planted_) want.words.words[0] += 1;
    planted_ = false;
    ++checked_words_;
    if (want.words.saturated) ++saturated_words_;
    for (int c = 0; c < 3; ++c) {
      if (sim_->m_word_data[c] == want.words.words[c]) continue;
      mismatch("component " + std::to_string(c) + " of word " + std::to_string(checked_words_) +
               ": " + std::to_string(sim_->m_word_data[c]) + ", expected " +
               std::to_string(want.words.words[c]));
    }
    if ((sim_->m_word_saturated != 0) != want.words.saturated) mismatch("a flag of a word");
    if ((sim_->m_word_last != 0) != want.last) mismatch("the last word");
  }

  /// What is there in this clock, before its edge.
  void watch() {
    const bool nothing =
        due_.empty() && row_.empty() && rows_.empty() && words_.empty() && sim_->sweeping_o == 0;
    if ((sim_->idle_o != 0) != nothing) mismatch("idle");
    if (nothing && expected_layers_ != saturated_layers_) {
      mismatch("layers that saturated: " + std::to_string(saturated_layers_) + ", expected " +
               std::to_string(expected_layers_));
      expected_layers_ = saturated_layers_;
    }
    if (sim_->collecting_o != 0 && sim_->collecting_page_o != collected_) mismatch("its page");
    if constexpr (Setup::kRows) {
      watch_rows();
      if (sim_->added_o == 0) return;
      if (due_.empty()) return mismatch("a vertex has added that nobody sent");
    } else {
      const bool added = !due_.empty() && due_.front().clock == clock_;
      if ((sim_->added_o != 0) != added) mismatch("when a vertex has added");
      if ((sim_->left_o != 0) != added) mismatch("when a vertex has left");
      if (sim_->layer_saturated_o != 0) mismatch("a layer of no row");
      if (!added) return;
      --inside_[due_.front().page];
    }
    const Due due = due_.front();
    due_.pop_front();
    ++checked_vertices_;
    if (due.saturated) ++saturated_vertices_;
    if (sim_->added_page_o != due.page) mismatch("the page of a vertex");
    if ((sim_->added_saturated_o != 0) != due.saturated) mismatch("whether a vertex saturated");
  }

  void watch_rows() {
    if (sim_->layer_saturated_o != 0) ++saturated_layers_;
    if (sim_->left_o == 0) return;
    if (rows_.empty()) return mismatch("a row has left that did not end");
    if (sim_->layer_page_o != rows_.front()) mismatch("the page of a row");
    --inside_[rows_.front()];
    rows_.pop_front();
    ++checked_rows_;
  }

  void mismatch(const std::string& what) {
    if (mismatches_++ == 0) first_mismatch_ = "clock " + std::to_string(clock_) + ": " + what;
  }

  tb::Sim<typename Setup::Dut> sim_;
  tb::Random random_;
  std::string format_;
  std::array<std::unique_ptr<model::ScatterModel>, 2> models_;
  std::array<model::CoefficientBank<F>, 2> functions_{};
  std::array<std::unique_ptr<model::ScatterPage>, kPages> pages_;
  std::array<std::array<int, 3>, kPages> dims_{};
  std::array<std::array<int, 3>, kPages> last_cell_{};
  std::uint64_t clock_ = 0;
  std::optional<Vertex> vertex_;
  bool entered_ = false;
  std::deque<Due> due_;
  std::vector<Vertex> row_;  ///< that is under way
  std::deque<int> rows_;     ///< the pages of those that have ended
  std::deque<Vertex> planned_;
  std::deque<Word> words_;
  std::array<int, kPages> inside_{};
  int collected_ = -1;
  bool planted_ = false;
  std::uint64_t checked_words_ = 0, checked_vertices_ = 0, mismatches_ = 0;
  std::uint64_t saturated_vertices_ = 0, saturated_words_ = 0;
  std::uint64_t checked_rows_ = 0, saturated_layers_ = 0, expected_layers_ = 0;
  std::string first_mismatch_;
};

}  // namespace hwffd::test
