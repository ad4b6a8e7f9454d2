#include "study.hpp"

#include <algorithm>
#include <thread>

#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/tb/stream_bench.hpp"
#include "order.hpp"

namespace hwffd::streams {
namespace {

/// A mesh in a lattice.
struct Scene {
  const NamedMesh* mesh;
  int points;
  Lattice lattice;
  std::vector<Embedded> vertices;  // in the order of the file
};

std::vector<Scene> scenes_of(const std::vector<NamedMesh>& meshes,
                             const std::vector<int>& lattices) {
  std::vector<Scene> scenes;
  for (const NamedMesh& mesh : meshes) {
    const Box box = Box::around(mesh.mesh.positions());
    for (const int points : lattices) {
      const Index3 dims{points, points, points};
      scenes.push_back({&mesh, points, Deformation::parse("twist:90").apply(box.lattice(dims)),
                        box.embed(dims, mesh.mesh.positions())});
    }
  }
  return scenes;
}

struct Job {
  const Scene* scene;
  tb::Arrangement arrangement;
  std::string order;
};

void count(Row& row, const Job& job, const std::vector<Embedded>& vertices,
           const Configuration& configuration) {
  const std::vector<Beat> beats =
      tb::packets(job.arrangement, job.scene->lattice, vertices, configuration.format);
  const auto core = cores::make_stream_core(configuration, 1);
  tb::StreamBenchOptions options;
  options.test.name = "streams " + row.mesh + " " + row.arrangement;
  tb::StreamBench bench(*core, options);
  bench.reset(4);
  bench.expect(model::StreamModel(configuration).run(beats));
  bench.send(beats);
  bench.run();
  const bool good = bench.finish();
  row.counted = bench.accept_clocks().size();
  row.mismatches = bench.scoreboard().mismatches() + (good ? 0 : 1);
}

Row run(const Job& job, const Configuration& configuration) {
  const Scene& scene = *job.scene;
  const std::vector<Embedded> vertices = ordered(scene.vertices, job.order);
  std::vector<Index3> cells;
  for (const Embedded& vertex : vertices) cells.push_back(vertex.cell);
  Row row{scene.mesh->name, vertices.size(), scene.points, job.arrangement.name(), job.order};
  row.predicted = tb::predicted_beats(job.arrangement, scene.lattice.dims(), cells);
  if (job.arrangement.is_built()) count(row, job, vertices, configuration);
  return row;
}

}  // namespace

std::vector<Row> study(const std::vector<NamedMesh>& meshes, const std::vector<int>& lattices,
                       const Configuration& configuration, const Progress& progress) {
  const std::vector<Scene> scenes = scenes_of(meshes, lattices);
  std::vector<Job> jobs;
  for (const Scene& scene : scenes) {
    for (const tb::Arrangement& arrangement : tb::arrangements()) {
      for (const std::string& order : arrangement.orders)
        jobs.push_back({&scene, arrangement, order});
    }
  }
  std::vector<Row> rows(jobs.size());
  on_threads(
      jobs.size(), [&](std::size_t i) { rows[i] = run(jobs[i], configuration); },
      [&](std::size_t done) { progress(done, jobs.size()); });
  return rows;
}

}  // namespace hwffd::streams
