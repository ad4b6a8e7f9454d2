// What the generator of standalone cores asks of the model: sample packets, and the results of a
// core.

#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "arrays.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/stream_model.hpp"
#include "lattice.hpp"
#include "sample_packets.hpp"

namespace hwffd::python {
namespace {

constexpr int kColumns = 5;  // four words, and 1 for tlast, 2 for tuser

py::array table_of(const std::vector<Beat>& beats) {
  std::vector<std::uint32_t> cells;
  cells.reserve(beats.size() * kColumns);
  for (const Beat& beat : beats) {
    cells.insert(cells.end(), beat.words.begin(), beat.words.end());
    cells.push_back((beat.last ? 1U : 0U) | (beat.user ? 2U : 0U));
  }
  return owning(std::move(cells), {static_cast<py::ssize_t>(beats.size()), kColumns});
}

py::tuple core_sample(const std::string& org, int n, const std::string& format, bool powers,
                      bool fused, std::uint32_t features, int axis, int pages, int spans,
                      int grid_limit, std::size_t vertices, std::uint64_t seed) {
  const Configuration row{"standalone",
                          org.c_str(),
                          n,
                          format.c_str(),
                          "overlapped",
                          powers ? "powers" : "pipelined",
                          1,
                          1,
                          fused ? 1 : 0,
                          0,
                          "all",
                          "all"};
  SamplePackets sample({format, features, axis, pages, spans}, seed);
  const std::vector<Beat> commands = sample.packets(vertices);
  model::StreamModel model(row, features, axis, pages, spans, grid_limit);
  const std::vector<Beat> results = model.run(commands);
  return py::make_tuple(table_of(commands), table_of(results), model.vertices(),
                        sample.beats_of_first(), model.error_status());
}

}  // namespace

void bind_core(py::module_& module) {
  module.def("core_sample", &core_sample, py::kw_only(), py::arg("org"), py::arg("n"),
             py::arg("format"), py::arg("powers"), py::arg("fused"), py::arg("features"),
             py::arg("axis"), py::arg("pages"), py::arg("spans"), py::arg("grid_limit"),
             py::arg("vertices"), py::arg("seed"),
             "Packets of every kind that a core takes, and what it answers: commands and results, "
             "(beats, 5) words each, the fifth 1 for tlast and 2 for tuser; the vertices of the "
             "model; commands up to the end of the first vertex; and ERROR_STATUS of the model.");
}

}  // namespace hwffd::python
