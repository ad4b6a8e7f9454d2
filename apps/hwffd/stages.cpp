#include "stages.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "dims.hpp"
#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd::command {
namespace {

constexpr double kNoVolume = 1e-12;  // of the cube around the points

bool is_shape(const std::string& name) { return find_shape(name) != nullptr; }

/// "box 4x4x4, cylinder 4x4x9, ..."
std::string usual_points() {
  std::string text;
  for (const Shape& shape : shapes()) {
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : ", ", shape.name, fmt::join(shape.usual, "x"));
  }
  return text;
}

void check_shape(const char* option, const std::string& value, const StageText& stage) {
  if (is_shape(stage.lattice)) return;
  throw UsageError(fmt::format("{} {}: lattice file '{}' says this itself; leave it out", option,
                               excerpt(value), excerpt(stage.lattice)));
}

void set_once(std::string& entry, const char* option, const std::string& value) {
  if (!entry.empty()) {
    throw UsageError(fmt::format("{} {}: given twice; begin the next stage by --lattice", option,
                                 excerpt(value)));
  }
  entry = value;
}

/// The two corners of a region, 2 x 3.
Points parse_region(const std::string& text) {
  std::array<double, 6> values{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto [next, error] = std::from_chars(at, end, values[i]);
    const bool last = i + 1 == values.size();
    const bool good = error == std::errc() && std::isfinite(values[i]) &&
                      (last ? next == end : next != end && *next == ',');
    if (!good) {
      throw UsageError(
          fmt::format("--region {}: expected two corners, X0,Y0,Z0,X1,Y1,Z1", excerpt(text)));
    }
    at = last ? next : next + 1;
  }
  Points corners = Eigen::Map<const Points>(values.data(), 2, 3);
  if ((corners.row(0).array() == corners.row(1).array()).any()) {
    throw UsageError(
        fmt::format("--region {}: spans no volume; give two corners that differ along x, y and z",
                    excerpt(text)));
  }
  return corners;
}

/// The file with the family of the text, if it names one.
/// @throws Error where there is no such file, and for points that are too few for the family
LatticeFile read_stage(const StageText& text) {
  if (!std::filesystem::exists(text.lattice)) {
    throw Error(fmt::format("--lattice {}: no file, nor a shape; shapes are {}",
                            excerpt(text.lattice), shape_list()));
  }
  return read_lattice_file(text.lattice, family_named(text.family));
}

[[noreturn]] void throw_no_volume(const std::string& name) {
  throw Error(fmt::format("lattice '{}': its cells span no volume; spread its points", name));
}

}  // namespace

StageOptions::StageOptions(CLI::App& app) : app_(app) {
  // The texts are taken from the parse order; what CLI11 binds them to does not matter.
  const auto add = [&](const char* name, const char* type, const std::string& help) {
    return app
        .add_option_function<std::vector<std::string>>(
            name, [](const std::vector<std::string>&) {}, help)
        ->type_name(type)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  };
  lattice_ = add("--lattice", "SHAPE|FILE",
                 fmt::format("what a stage begins with: {} (default: {}), or a lattice file",
                             shape_list(), StageText{}.lattice));
  dims_ = add("--dims", "IxJxK", fmt::format("control points an axis ({})", usual_points()));
  family_ = add("--family", "NAME",
                fmt::format("blending functions: {} (default: {})",
                            fmt::join(Family::names(), ", "), Family().name()));
  region_ = add("--region", "X0,Y0,Z0,X1,Y1,Z1", "what a shape holds (default: all vertices)");
  deform_ = add("--deform", "KIND:ARGUMENT",
                "how its points move: none, twist:90 (turns the corners of the lattice), helix:90 "
                "(turns what it "
                "holds by that angle), shear:0.5, bend:90, taper:0.5, scale:2 or scale:X,Y,Z, "
                "move:I,J,K:DX,DY,DZ, random:SEED, to:FILE; twist, helix, bend and taper take an "
                "axis, as twist:90:x; again for more, in order");
}

std::vector<StageText> StageOptions::texts() const {
  std::vector<StageText> stages;
  std::map<const CLI::Option*, std::size_t> taken;
  for (const CLI::Option* option : app_.parse_order()) {
    if (option != lattice_ && option != dims_ && option != family_ && option != region_ &&
        option != deform_) {
      continue;
    }
    const std::string& value = option->results().at(taken[option]++);
    if (option == lattice_) {
      stages.emplace_back();
      stages.back().lattice = value;
      continue;
    }
    if (stages.empty()) stages.emplace_back();
    StageText& stage = stages.back();
    if (option == deform_) {
      stage.deformations.push_back(value);
    } else if (option == family_) {
      set_once(stage.family, "--family", value);
    } else if (option == dims_) {
      check_shape("--dims", value, stage);
      set_once(stage.dims, "--dims", value);
    } else {
      check_shape("--region", value, stage);
      set_once(stage.region, "--region", value);
    }
  }
  if (stages.empty()) stages.emplace_back();
  return stages;
}

LatticeFile Stage::file() const {
  return {deformed, apart ? std::optional<Lattice>(rest) : std::nullopt, family};
}

std::vector<std::string> files_of(const std::vector<StageText>& texts) {
  constexpr std::string_view kTo = "to:";
  std::vector<std::string> files;
  for (const StageText& text : texts) {
    if (!is_shape(text.lattice)) files.push_back(text.lattice);
    for (const std::string& word : text.deformations) {
      if (word.compare(0, kTo.size(), kTo) == 0) files.push_back(word.substr(kTo.size()));
    }
  }
  return files;
}

std::optional<Family> family_named(const std::string& name) {
  return name.empty() ? std::nullopt : std::optional<Family>(Family::parse(name));
}

LatticeFile given_lattice(const StageText& text, const Points& points) {
  if (!is_shape(text.lattice)) return read_stage(text);
  const Family family = family_named(text.family).value_or(Family());
  std::optional<Index3> dims;
  if (!text.dims.empty()) {
    dims = parse_dims(text.dims, "--dims " + excerpt(text.dims),
                      family.takes_few() ? Lattice::kFewestPoints : Lattice::kMinPoints,
                      Lattice::kMaxPoints);
  }
  if (text.region.empty()) {
    return {lattice_around(text.lattice, points, dims, family), std::nullopt, family};
  }
  Fit exactly;
  exactly.room = 0.0;
  return {lattice_around(text.lattice, parse_region(text.region), dims, family, exactly),
          std::nullopt, family};
}

LatticeFile deformed_lattice(const StageText& text, LatticeFile given) {
  std::vector<Deformation> deformations;
  for (const std::string& word : text.deformations) {
    deformations.push_back(Deformation::parse(word));
  }
  given.lattice = deform_lattice(given.lattice, deformations, *given.family);
  return given;
}

std::vector<Stage> make_stages(const std::vector<StageText>& texts, const Points& points) {
  std::vector<Stage> stages;
  for (const StageText& text : texts) {
    LatticeFile given = given_lattice(text, points);
    const Family family = *given.family;
    const bool apart = given.rest.has_value();
    Lattice rest = whole(given.rest.value_or(given.lattice), family);
    if (!span_volume(rest.points())) throw_no_volume(text.lattice);
    Lattice deformed = whole(deformed_lattice(text, std::move(given)).lattice, family);
    stages.push_back({text.lattice, family, std::move(rest), std::move(deformed), apart});
  }
  return stages;
}

void add_check_folds(CLI::App& app, bool& check) {
  app.add_flag("--check-folds", check,
               "prove that no lattice folds, and refuse one that does at rest; takes seconds for "
               "lattices of many points");
}

FoldCheck check_rest(const Stage& stage) {
  FoldCheck check = check_folds(stage.rest, kFoldDepth, stage.family);
  const Points& points = stage.rest.points();
  const Point extent = points.colwise().maxCoeff() - points.colwise().minCoeff();
  if (std::abs(check.volume) <= kNoVolume * std::pow(extent.maxCoeff(), 3)) {
    throw_no_volume(stage.name);
  }
  if (check.verdict == FoldCheck::Verdict::kFolded) {
    throw Error(fmt::format("lattice '{}': {}; embedding wants a lattice without folds at rest",
                            stage.name, check.text()));
  }
  return check;
}

}  // namespace hwffd::command
