#pragma once

#include <map>
#include <optional>
#include <string>

#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A route for a function that is chosen in advance, for instance by measuring.
struct RouteChoice {
  std::string route;  ///< key of the route, or the words by which earlier manifests name it
  int lanes = 0;      ///< 1, 2, 4 or 8; 0: the scene's
};

/// Routes that are chosen in advance. Every other function takes the route of least cost.
struct Choices {
  std::map<Function, RouteChoice> plain;
  std::map<Function, RouteChoice> batch;  ///< without lanes, which are the states of a batch
  std::string measured;  ///< compiler, flags and processor of the measurement; may be empty

  [[nodiscard]] bool empty() const { return plain.empty() && batch.empty(); }
};

/// Reads the choices that a manifest.json records, or that are written by hand in the same form:
/// {"choices": [{"function": "gravity", "chosen": {"route": "...", "lanes": 4}}, ...]}, where
/// `lanes` may be missing. A batch function is called "batch_gravity". Errors: the file cannot be
/// read or is not JSON of this form; a function does not exist; the file says that it is about
/// another robot than `robot`.
std::optional<Choices> read_choices(const std::string& path, const std::string& robot,
                                    Diagnostics& diagnostics);

}  // namespace treeline
