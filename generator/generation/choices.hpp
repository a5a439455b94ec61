#pragma once

#include <map>
#include <optional>
#include <string>

#include "description/diagnostic.hpp"
#include "description/scene.hpp"

namespace treeline {

/// The way to compute a function that somebody has chosen, by measuring it or otherwise.
struct RouteChoice {
  std::string route;  ///< its key, or the words by which earlier manifests name it
  int lanes = 0;      ///< 1, 2, 4 or 8; 0: the scene's
};

/// What is chosen beforehand; every other function takes the route of least cost.
struct Choices {
  std::map<Function, RouteChoice> plain;
  std::map<Function, RouteChoice> batch;  ///< without lanes: those of a batch are its states
  std::string measured;  ///< compiler, flags and processor that they were measured with; or empty

  [[nodiscard]] bool empty() const { return plain.empty() && batch.empty(); }
};

/// The choices that a manifest.json records, or that are written by hand in the same form:
/// {"choices": [{"function": "gravity", "chosen": {"route": "...", "lanes": 4}}, ...]}; a batch
/// function is "batch_gravity". Errors: a file that cannot be read or is no JSON of this form, a
/// function that is none.
std::optional<Choices> read_choices(const std::string& path, Diagnostics& diagnostics);

}  // namespace treeline
