#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// What a variant differs in from the code that the scene asks for.
enum class VariantGroup {
  emitted,      ///< in nothing
  lanes,        ///< numbers computed together
  real,         ///< float for double, or the other way round, in any lanes
  route,        ///< algorithm
  inertia,      ///< full inertias in place of regrouped ones
  accuracy,     ///< `Scene::accuracy`
  contraction,  ///< products and sums are not fused
  sines,        ///< sines and cosines given, or the C library's
  solve,        ///< Lambda by a factorisation of Eigen out of the emitted Lambda^-1
  interpreter,  ///< generic, in float or double
  peer,         ///< another library, in double
};
const char* group_name(VariantGroup group);

/// One way to a function's numbers.
struct Variant {
  Function function{};
  VariantGroup group{};
  std::string name;  ///< "double, 8 lanes", "route: articulated bodies, Chang table 4.2"
  Real real = Real::float64;
  std::string method = {};  ///< of generated code: the route's full name; of a peer: its own
  std::string flags = {};   ///< of generated code: for the compiler
  int flops = 0;            ///< of generated code
  bool whole = true;  ///< false: what the caller must do first, take sines, is not in its time
  std::vector<std::string> repeats = {};  ///< variants whose code is the same to the byte
};

/// Variants that are compiled together: one a function, in one folder.
struct VariantBuild {
  Scene scene;  ///< that the folder is emitted for
  std::vector<Variant> variants;
  std::vector<GeneratedFunction> functions;  ///< of each variant
  std::vector<GeneratedFile> files;
  std::string flags;
};

}  // namespace treeline
