// What worker.js calls: functions of C. Each returns whether it went well; what it has to say is
// then in a text of JSON, and positions in an array of floats.
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "design.hpp"
#include "engine.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/configuration.hpp"
#include "hwffd/model/schedule.hpp"
#include "row_texts.hpp"

namespace {

using Json = nlohmann::json;

struct State {
  hwffd::web::Engine engine;
  std::vector<float> in;
  std::vector<float> out;
  std::string text;
};

State& state() {
  static State state;
  return state;
}

/// Runs it; what it throws becomes the text.
template <class F>
int guarded(F f) {
  try {
    f(state());
    return 1;
  } catch (const std::exception& error) {
    state().text = hwffd::one_line(error.what());
    return 0;
  }
}

hwffd::Points points_given(State& s) {
  hwffd::Points points(static_cast<Eigen::Index>(s.in.size() / 3), 3);
  for (std::size_t i = 0; i < 3 * (s.in.size() / 3); ++i) points.data()[i] = double{s.in[i]};
  return points;
}

void give(State& s, const hwffd::Points& points) {
  s.out.resize(static_cast<std::size_t>(points.size()));
  for (std::size_t i = 0; i < s.out.size(); ++i) s.out[i] = static_cast<float>(points.data()[i]);
}

Json json_of(const hwffd::Configuration& row) {
  return {{"name", row.name},
          {"org", row.org},
          {"n", row.n},
          {"format", row.format},
          {"schedule", row.schedule},
          {"title", hwffd::web::title_of(row)},
          {"formula", hwffd::web::formula_of(row)},
          {"formula_clocks", hwffd::expected_interval(row)}};
}

/// What a core has to show.
Json json_of(hwffd::web::Engine& engine) {
  Json blocks = Json::array();
  for (const hwffd::web::Block& block : hwffd::web::design_of(engine.row()).blocks) {
    blocks.push_back({{"id", block.id}, {"title", block.title}, {"module", block.module}});
  }
  Json ports = Json::array();
  for (const hwffd::web::Port& port : hwffd::web::ports()) {
    ports.push_back({{"name", port.name},
                     {"width", engine.inside().signals().only(port.signal).width},
                     {"description", port.description}});
  }
  return {{"core", engine.row().name}, {"blocks", std::move(blocks)}, {"ports", std::move(ports)}};
}

Json json_of(const hwffd::web::Snapshot& shown) {
  Json lanes = Json::array();
  for (const hwffd::cores::Lane& lane : shown.lanes) {
    Json spans = Json::array();
    for (const auto& span : lane.spans) spans.push_back({span.begin, span.end, span.vertex});
    lanes.push_back({{"name", lane.name}, {"spans", std::move(spans)}});
  }
  return {{"clock", shown.clock},
          {"busy", shown.busy},
          {"vertices", shown.vertices},
          {"mismatches", shown.mismatches},
          {"timeline",
           {{"first_clock", shown.first_clock},
            {"clocks", shown.clock - shown.first_clock},
            {"lanes", std::move(lanes)}}},
          {"ports", shown.ports}};
}

Json json_of(const std::optional<hwffd::web::Mismatch>& first) {
  if (!first) return nullptr;
  return {{"vertex", first->vertex},
          {"word", first->word},
          {"rtl", first->rtl},
          {"model", first->model}};
}

}  // namespace

extern "C" {

const char* hwffd_text() { return state().text.c_str(); }
const float* hwffd_floats() { return state().out.data(); }
int hwffd_float_count() { return static_cast<int>(state().out.size()); }

/// Where so many floats are written that the next call reads.
float* hwffd_room(int floats) {
  state().in.resize(static_cast<std::size_t>(floats));
  return state().in.data();
}

/// The rows that this build has.
int hwffd_cores() {
  return guarded([](State& s) {
    Json cores = Json::array();
    for (const hwffd::Configuration& row : hwffd::configurations()) {
      if (hwffd::cores::has_stream_core(row)) cores.push_back(json_of(row));
    }
    s.text = Json{{"cores", std::move(cores)}}.dump();
  });
}

int hwffd_open(const char* core) {
  return guarded([&](State& s) {
    s.engine.open(core);
    s.text = json_of(s.engine).dump();
  });
}
int hwffd_mesh() {
  return guarded([](State& s) { s.engine.set_mesh(points_given(s)); });
}
int hwffd_dims(int a, int b, int c) {
  return guarded([&](State& s) { s.engine.set_dims({a, b, c}); });
}
int hwffd_points() {
  return guarded([](State& s) { s.engine.set_points(points_given(s)); });
}
int hwffd_shape(const char* deformation) {
  return guarded([&](State& s) { s.engine.set_shape(deformation); });
}
int hwffd_fault(int on) {
  return guarded([&](State& s) { s.engine.set_fault(on != 0); });
}
int hwffd_has_mesh() { return state().engine.has_mesh() ? 1 : 0; }

int hwffd_lattice() {
  return guarded([](State& s) {
    const hwffd::Lattice& lattice = s.engine.lattice();
    give(s, lattice.points());
    s.text = Json{{"dims", lattice.dims()}}.dump();
  });
}

int hwffd_deform() {
  return guarded([](State& s) {
    const hwffd::web::Deformed deformed = s.engine.deform();
    give(s, deformed.positions);
    s.text = Json{{"vertices", deformed.positions.rows()},
                  {"words", deformed.words},
                  {"mismatches", deformed.mismatches},
                  {"first", json_of(deformed.first)},
                  {"clocks", deformed.clocks},
                  {"clocks_per_vertex", deformed.clocks_per_vertex},
                  {"saturated", deformed.saturated}}
                 .dump();
  });
}

/// Goes on by so many clocks, or where there are none until a vertex has come.
int hwffd_inside(int clocks) {
  return guarded([&](State& s) {
    hwffd::web::Inside& inside = s.engine.inside();
    if (clocks == 0) {
      inside.run_vertex();
    } else {
      inside.run(clocks < 0 ? 0 : static_cast<std::uint64_t>(clocks));
    }
    s.text = json_of(inside.snapshot()).dump();
  });
}

/// @param names  of ports, each behind the one before and a comma
int hwffd_watch(const char* names) {
  return guarded([&](State& s) {
    std::istringstream list(names);
    std::vector<std::string> wanted;
    for (std::string name; std::getline(list, name, ',');) wanted.push_back(name);
    s.engine.watch(wanted);
    s.text = json_of(s.engine.inside().snapshot()).dump();
  });
}

int hwffd_vcd() {
  return guarded([](State& s) { s.text = s.engine.inside().vcd(); });
}

}  // extern "C"
