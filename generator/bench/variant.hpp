#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Difference of a variant from the code that the scene asks for.
enum class VariantGroup {
  emitted,      ///< none
  language,     ///< emitted code in C99
  batch,        ///< several states a call
  lanes,        ///< number of lanes
  real,         ///< float instead of double, or the reverse, with any number of lanes
  route,        ///< algorithm
  inertia,      ///< full inertias instead of regrouped ones
  accuracy,     ///< `Scene::accuracy`
  contraction,  ///< products and sums are not fused
  sines,        ///< sines and cosines are inputs, or come from the C library
  solve,        ///< Lambda by Eigen's factorization of the emitted Lambda^-1
  interpreter,  ///< generic interpreter, in float or double
  peer,         ///< another library, in double
};
const char* group_name(VariantGroup group);
/// Returns the group of a name; nothing if there is none.
std::optional<VariantGroup> find_group(std::string_view name);
/// Names of all groups, in their order.
std::vector<std::string> group_names();

/// One way to compute a function.
struct Variant {
  Function function{};
  VariantGroup group{};
  std::string name;  ///< "double, 8 lanes", "route: articulated bodies, Chang table 4.2"
  Real real = Real::float64;
  std::string method = {};  ///< generated code: full name of the route; peers: their own name
  std::string flags = {};   ///< generated code: compiler flags
  int flops = 0;            ///< of generated code
  int states = 1;           ///< of a call; times are of one of them
  /// Whether a caller with one state has its result in this time: not of a batch, nor where it
  /// takes the sines itself.
  bool whole = true;
  bool recorded = false;                  ///< peers: code that another tool made for this robot
  std::vector<std::string> repeats = {};  ///< variants with the same code, byte by byte
};

/// Variants that are compiled together in one folder, one per function.
struct VariantBuild {
  Scene scene;  ///< scene for which the folder is emitted
  std::vector<Variant> variants;
  std::vector<GeneratedFunction> functions;  ///< by variant
  std::vector<GeneratedFile> files;
  std::string flags;
};

}  // namespace treeline
