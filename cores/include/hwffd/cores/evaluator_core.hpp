#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hwffd::cores {

/// A signal inside a core, of at most 8 bits, as cores/rtl/ffd_bench.vlt makes it visible.
struct Probe {
  std::string instance;  ///< hierarchical name
  std::string signal;
  const std::uint8_t* value;  ///< valid as long as the core
};

/// The pins of a Verilated `ffd_bench_evaluator`: an evaluator, whatever its configuration, that
/// reads its control points from a memory of 256 supports.
///
/// A cycle is: drive the inputs, `settle`, read ready and valid, `clock`.
class EvaluatorCore {
 public:
  struct Vertex {
    std::array<std::uint32_t, 3> words{};  ///< s, t, u as stream words
    std::uint32_t second = 0;  ///< s of a second vertex, where the organization takes pairs
    std::uint16_t cell = 0;    ///< {k, j, i}, 4 bits each
    std::uint8_t support = 0;
    std::uint8_t bank = 0;  ///< {u, t, s}, two bits each: {derivative, bank}; all derivative: four
                            ///< results, where the organization gives the Jacobian
    bool changed = false;   ///< points or coefficients were written since the vertex before
    int exponent = 0;       ///< of the support
    std::uint16_t tag = 0;
  };
  struct Derivative {
    std::array<std::uint32_t, 3> words{};
    bool saturated = false;
    bool nan = false;
  };
  struct Result {
    std::array<std::uint32_t, 3> words{};
    bool saturated = false;
    bool nan = false;
    std::uint16_t tag = 0;
    std::array<Derivative, 3> along{};  ///< s, t, u, where the organization gives the Jacobian;
                                        ///< that of a second vertex comes in the place of s
  };

  virtual ~EvaluatorCore() = default;

  virtual void drive_reset(bool asserted) = 0;
  /// One clock that loads a function: coefficients of 1, x, x^2, x^3.
  /// @param address  {derivative, bank, function}: 1, 1 and 2 bits
  virtual void load(int axis, int address, int shift,
                    const std::array<std::uint32_t, 4>& words) = 0;
  /// One clock that writes a control point of a support, in local order, n fastest.
  virtual void write(std::uint8_t support, int index, const std::uint32_t* xyz, int exponent) = 0;

  virtual void drive_vertex(bool valid, const Vertex& vertex) = 0;
  virtual void drive_result_ready(bool ready) = 0;
  virtual void settle() = 0;
  virtual void clock() = 0;

  virtual bool vertex_ready() const = 0;
  virtual bool result_valid() const = 0;
  virtual Result result() const = 0;
  /// Whether vertices are inside, or were a clock ago.
  virtual bool evaluating() const = 0;

  /// By instance, then by signal.
  virtual std::vector<Probe> probes() const = 0;
};

}  // namespace hwffd::cores
