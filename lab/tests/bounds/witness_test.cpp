// The vertices that lab/docs/bounds.md sets beside proved bounds, at the read ports of the rows
// of this build that compute such a form: RTL, model and report have the same bits.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>

#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/model/organizations.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_bench.hpp"
#include "hwffd/tb/random.hpp"
#include "named.hpp"

namespace hwffd::test {
namespace {

/// What the report calls the form of a row; empty where it has none of these.
std::string form_of(const Configuration& row) {
  const bool product = organization_of(row).form == Form::kProduct;
  const bool powers = row.evaluator == std::string("powers");
  if (product && row.format == std::string("fp32")) {
    return row.n == 1 ? "sequence" : row.n == 64 ? "tree" : "";
  }
  if (product) return "product";
  if (powers) return "powers";
  return organization_of(row).form == Form::kAffine ? "affine" : "factored";
}

nlohmann::json witnesses() {
  std::ifstream file(HWFFD_BOUNDS);
  return nlohmann::json::parse(file).at("witnesses");
}

/// The witness of a row; null where there is none.
nlohmann::json witness_of(const Configuration& row) {
  const std::string format = row.format + std::string(row.fma_latency > 0 ? "-fused" : "");
  for (const nlohmann::json& witness : witnesses()) {
    if (witness.at("form") == form_of(row) && witness.at("format") == format) return witness;
  }
  return nullptr;
}

std::vector<Configuration> rows_with_witness() {
  return rows_where([](const Configuration& row) {
    return cores::has_evaluator_core(row) && !witness_of(row).is_null();
  });
}

class Witness : public ::testing::TestWithParam<Configuration> {
 protected:
  Witness()
      : codec_(GetParam().format),
        core_(cores::make_evaluator_core(GetParam(), tb::seed_from_environment(1))),
        model_(model::make_evaluator_model(GetParam())),
        bench_(*core_, *model_, bank(codec_)),
        witness_(witness_of(GetParam())) {}

  static tb::EvaluatorBench::Bank bank(const WordCodec& codec) {
    const AxisWords axis = encode(watertight_bspline(codec), codec);
    return {axis, axis, axis};
  }

  /// Its points in all components; twice, since some rows take the first vertex another way.
  tb::EvaluatorStimulus stimulus() const {
    tb::EvaluatorStimulus stimulus;
    stimulus.supports.resize(1);
    for (std::size_t p = 0; p < 192; ++p) {
      stimulus.supports[0].points[p] = witness_.at("points").at(p / 3);
    }
    stimulus.vertices.resize(2);
    for (tb::EvaluatorVertex& vertex : stimulus.vertices) {
      vertex.local = witness_.at("local");
      vertex.cell = witness_.at("cell");
    }
    return stimulus;
  }

  WordCodec codec_;
  std::unique_ptr<cores::EvaluatorCore> core_;
  std::unique_ptr<model::EvaluatorModel> model_;
  tb::EvaluatorBench bench_;
  nlohmann::json witness_;
};

TEST_P(Witness, TheRtlHasItsResult) {
  bench_.run(stimulus());
  EXPECT_EQ(bench_.mismatches(), 0U) << bench_.first_mismatch();
  ASSERT_EQ(bench_.results().size(), 2U);
  for (const auto& result : bench_.results()) {
    EXPECT_FALSE(result.saturated || result.nan);
    for (const std::uint32_t word : result.words) EXPECT_EQ(word, witness_.at("result"));
  }
}

// A point that is another has another result.
TEST_P(Witness, AnotherPointIsNoticed) {
  auto planted = stimulus();
  planted.supports[0].points[3 * 21] = 0;
  bench_.run(planted);
  EXPECT_NE(bench_.results().at(0).words[0], witness_.at("result"));
  EXPECT_EQ(bench_.results().at(0).words[1], witness_.at("result"));
}

TEST(Witnesses, AreOfSomeRow) { EXPECT_FALSE(rows_with_witness().empty()); }

INSTANTIATE_TEST_SUITE_P(, Witness, ::testing::ValuesIn(rows_with_witness()), by_name);

}  // namespace
}  // namespace hwffd::test
