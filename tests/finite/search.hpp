#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "oracle/draw_state.hpp"
#include "text/diagnostic.hpp"

/// Search for finite inputs for which emitted code, compiled and run, is not finite.
namespace treeline::tests {

struct FiniteOptions {
  std::int64_t states = 10000;
  std::int64_t first = 0;
  std::uint64_t seed = 1;
  std::string flags = "-O1";  ///< for $CXX, else c++, else g++
  double length = 1e3;        ///< the largest displacement of a joint, m
};

/// A function, and the first state at which a result of it is not finite.
struct NotFinite {
  std::string function;
  std::int64_t times = 0;  ///< number of states at which it is not finite
  State first;
};

struct FiniteReport {
  std::vector<std::string> functions;
  std::int64_t states = 0;
  std::vector<NotFinite> found;
  /// Number of states left out because M is singular in 50 digits, so that functions which need its
  /// inverse have no value.
  std::int64_t without_value = 0;
};

/// Generates the scene's functions, compiles them, and calls each in all states. Returns nothing if
/// the code cannot be made or compiled; `diagnostics` says why.
std::optional<FiniteReport> search_not_finite(const Robot& robot, const Scene& scene,
                                              const FiniteOptions& options,
                                              Diagnostics& diagnostics);

/// The scene that `treeline init-scene --base` proposes, without functions that are impossible.
std::optional<Scene> proposed_scene(const Robot& robot, Base base, Diagnostics& diagnostics);

/// Prints the inputs of the function, `q = 0.5 0 -1; qd = ...`, in digits that read back as the
/// same numbers.
std::string print_inputs(const State& state);

}  // namespace treeline::tests
