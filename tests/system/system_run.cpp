#include "system_run.hpp"

namespace hwffd::test {

std::vector<Configuration> built_configurations() { return rows_where(cores::has_stream_core); }

std::vector<Configuration> built_configurations(const std::string& format) {
  return rows_where([&](const Configuration& row) {
    return cores::has_stream_core(row) && row.format == format;
  });
}

SystemRun::SystemRun(const Configuration& row, std::uint64_t seed, const std::string& source,
                     const std::string& sink)
    : row_(row), codec_(row.format), core_(cores::make_stream_core(row, seed)), model_(row) {
  tb::StreamBenchOptions options;
  options.test.name = std::string(row.name) + " " + source + " " + sink;
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  options.test.replay = "SEED=" + std::to_string(seed) + " ctest --test-dir build -R '" +
                        (info != nullptr ? info->name() : "") + "'";
  options.test.seed = seed;
  options.source_throttle = source;
  options.sink_throttle = sink;
  options.probe_edges = true;
  bench_ = std::make_unique<tb::StreamBench>(*core_, options);
  reset(3);
}

void SystemRun::send(const std::vector<Beat>& beats) {
  bench_->send(beats);
  bench_->expect(model_.run(beats));
}

void SystemRun::send_bspline() {
  send(coefficients_packet(watertight_bspline(codec_), codec_, Functions::kDerivativesToo));
}

void SystemRun::reset(std::uint64_t cycles) {
  model_.reset();
  bench_->reset(cycles);
}

::testing::AssertionResult SystemRun::run() {
  bench_->run();
  if (bench_->finish()) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << bench_->report();
}

}  // namespace hwffd::test
