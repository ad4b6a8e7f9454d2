#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hwffd/lattice/family.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/lattice/lattice.hpp"
#include "hwffd/lattice/lattice_file.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace hwffd::command {

/// What the user said of one stage.
struct StageText {
  std::string lattice = "box";  ///< a shape, or a lattice file
  std::string dims;             ///< "4x4x4"; empty: what suits the shape
  std::string family;           ///< of blending functions; empty: bspline
  std::string region;           ///< "X0,Y0,Z0,X1,Y1,Z1" that a shape holds; empty: all points
  std::vector<std::string> deformations;  ///< texts that Deformation::parse takes, in order
};

/// The files that stages are read from.
std::vector<std::string> files_of(const std::vector<StageText>& texts);

/// A lattice of the hierarchy, before and after.
struct Stage {
  std::string name;  ///< of its shape or file
  Family family;
  Lattice rest;
  Lattice deformed;
  bool apart;  ///< whether its file has points at rest beside those that are deformed

  /// What to write of a stage: its family, and the lattice at rest where its file has it apart.
  LatticeFile file() const;
};

/// Whether the lattices of a stage fold.
struct StageFolds {
  FoldCheck rest;
  FoldCheck deformed;
};

/// The options --lattice, --dims, --family, --region and --deform of a command. Every --lattice
/// begins a stage; the others belong to the stage before them.
class StageOptions {
 public:
  explicit StageOptions(CLI::App& app);

  /// The stages in the order of the command line; without --lattice one box.
  /// @throws UsageError for --dims, --family or --region twice in a stage, and for --dims or
  ///   --region beside a lattice file
  std::vector<StageText> texts() const;

 private:
  CLI::App& app_;
  CLI::Option* lattice_;
  CLI::Option* dims_;
  CLI::Option* family_;
  CLI::Option* region_;
  CLI::Option* deform_;
};

/// The family of an option --family, which may be empty.
/// @throws UsageError for one that is unknown
std::optional<Family> family_named(const std::string& name);

/// What a stage begins with: its shape, or its file, which is read once; of few points an axis
/// where the text or the file says so (few_points.hpp). Its family is that of the text, else that
/// of the file, else the usual one.
/// @param points  what a shape holds if the text gives no region
/// @throws UsageError, Error for a text, file or lattice that is no good
LatticeFile given_lattice(const StageText& text, const Points& points);

/// The same with the deformations of the text, in order; what stands at rest beside it stays.
LatticeFile deformed_lattice(const StageText& text, LatticeFile given);

/// All stages of a command; their lattices have four points and more along each axis.
/// @throws Error for a lattice at rest whose points lie in one plane
std::vector<Stage> make_stages(const std::vector<StageText>& texts, const Points& points);

/// Adds the option --check-folds to a command.
void add_check_folds(CLI::App& app, bool& check);

/// Checks the lattice at rest of a stage, which takes what check_folds() takes.
/// @throws Error for one that folds, or whose cells span no volume together
FoldCheck check_rest(const Stage& stage);

}  // namespace hwffd::command
