#include "replay.hpp"

#include "hwffd/model/evaluator.hpp"
#include "hwffd/model/stream_model.hpp"

namespace hwffd::test {
namespace {

Recording recording_of(const Configuration& row, const std::vector<Beat>& results) {
  Recording recording;
  recording.row = row.name;
  recording.results = results.size();
  recording.hash = hash_of(results);
  return recording;
}

}  // namespace

Recording model_answers(const Configuration& row, const std::vector<Beat>& commands) {
  model::StreamModel model(row);
  Recording recording = recording_of(row, model.run(commands));
  recording.events = recorded_events(model.events());
  return recording;
}

Recording answers_of(const Configuration& row,
                     const std::vector<cores::EvaluatorCore::Result>& results) {
  std::vector<Beat> beats;
  for (const auto& result : results) {
    const std::uint32_t flags = (result.saturated ? 1U : 0U) | (result.nan ? 2U : 0U);
    beats.push_back({{result.words[0], result.words[1], result.words[2], flags}, false});
  }
  return recording_of(row, beats);
}

Recording model_answers_at_read_port(const Configuration& row, const std::vector<Beat>& beats) {
  const ReadPortRecording recording = read_port_recording(beats);
  const auto model = model::make_evaluator_model(row);
  for (int bank = 0; bank < 2; ++bank) {
    for (int axis = 0; axis < 3; ++axis) {
      const AxisWords& words = recording.banks[bank][axis];
      for (int f = 0; f < 4; ++f) {
        model->load(bank, axis, f, words.degree, words.shift, words.word[f]);
        model->load_derivative(bank, axis, f, words.degree, words.derivative.shift,
                               words.derivative.word[f]);
      }
    }
  }
  const tb::EvaluatorStimulus& stimulus = recording.stimulus;
  std::vector<cores::EvaluatorCore::Result> results;
  for (const tb::EvaluatorVertex& vertex : stimulus.vertices) {
    const tb::SupportWords& support = stimulus.supports[vertex.support];
    model::VertexWords words{vertex.local, vertex.cell, support.points};
    words.derivative = vertex.derivative;
    words.exponent = support.exponent;
    const model::ResultWords result = model->evaluate(vertex.bank, words);
    results.push_back({result.words, result.saturated, result.nan, 0});
  }
  return answers_of(row, results);
}

}  // namespace hwffd::test
