// Watertight seams: a vertex on a face, edge or corner that cells share gets the same bits from
// each of them (docs/numerics.md section 5), in the model and in the RTL.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "hwffd/tb/evaluator_stimulus.hpp"
#include "hwffd/tb/random.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

/// Compared components, at least.
std::size_t model_values() { return share_of(60000); }

/// The same in the RTL, where every bit is compared with the model's, too.
std::size_t rtl_values() { return share_of(tb::seed_from_environment(6000, "HWFFD_SEAM_VALUES")); }

/// Vertices on seams with so many values in results of that kind, and how these differ where the
/// function makes them of packets.
template <class Answer>
tb::SeamStimulus::Differences differences(const Configuration& row, std::size_t values,
                                          std::uint64_t seed, Results wanted, Answer answer) {
  const WordCodec codec(row.format);
  const std::size_t each = results_of(wanted), compared = each == 1 ? 3 : 9;  // but the position
  const auto seams =
      tb::seam_stimulus(codec, 3 * values / compared, tb::seed_from_environment(seed));
  const std::vector<Beat> results =
      answer(interleaved_packet(tb::interleaved(seams), OutsideMode::kClamp, wanted));
  EXPECT_EQ(results.size(), each * seams.vertices.size());
  EXPECT_GE(compared * seams.vertices.size(), values);
  return seams.differences(
      each, [&](std::size_t v, std::size_t r) { return results.at(each * v + r).words; });
}

void expect_none(const tb::SeamStimulus::Differences& differ) {
  std::printf("%zu values, %zu differ\n", differ.values, differ.count);
  EXPECT_EQ(differ.count, 0U);
}

tb::SeamStimulus::Differences model_differences(const Configuration& row, std::uint64_t seed,
                                                Results wanted, const Blending& blending) {
  model::StreamModel model(row);
  const bool derive = wanted != Results::kPosition;
  model.run(coefficients_packet(blending, WordCodec(row.format),
                                derive ? Functions::kDerivativesToo : Functions::kBlending));
  return differences(row, model_values(), seed, wanted,
                     [&](const std::vector<Beat>& packets) { return model.run(packets); });
}

tb::SeamStimulus::Differences rtl_differences(const Configuration& row, std::uint64_t seed,
                                              Results wanted) {
  SystemRun run(row, 1);
  return differences(row, rtl_values(), seed, wanted, [&](const std::vector<Beat>& packets) {
    run.send_bspline();
    run.send(packets);
    EXPECT_TRUE(run.run());
    return run.bench().results();
  });
}

class Seam : public PerConfiguration {
 protected:
  Blending bspline() const { return watertight_bspline(WordCodec(GetParam().format)); }
};
class FloatSeam : public PerConfiguration {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(FloatSeam);  // gates are of fixed point only

TEST_P(Seam, ModelIsWatertight) {
  expect_none(model_differences(GetParam(), 1, Results::kPosition, bspline()));
}

// The test can fail: with each coefficient rounded by itself, binary32 cracks.
TEST_P(FloatSeam, PlainCoefficientsCrackInBinary32) {
  const auto differ = model_differences(GetParam(), 1, Results::kPosition, plain_bspline());
  std::printf("%zu values, %zu differ\n", differ.values, differ.count);
  EXPECT_GT(differ.count, model_values() / 10);
}

TEST_P(Seam, RtlIsWatertight) { expect_none(rtl_differences(GetParam(), 2, Results::kPosition)); }

// The derivatives of both sides, too: three of four results, each of three components.

TEST_P(Seam, ModelDerivativesAreWatertight) {
  expect_none(model_differences(GetParam(), 3, Results::kDerivatives, bspline()));
}

TEST_P(Seam, RtlDerivativesAreWatertight) {
  expect_none(rtl_differences(GetParam(), 4, Results::kDerivatives));
}

HWFFD_FOR_EACH_CONFIGURATION(Seam);
HWFFD_FOR_EACH_CONFIGURATION(FloatSeam, "fp32");

}  // namespace
}  // namespace hwffd::test
