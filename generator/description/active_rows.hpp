#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// For each constraint that comes and goes, the rows that it holds among all that are held: those
/// of constraints to the world first, then those of loops.
using ActiveRows = std::vector<std::vector<std::size_t>>;

/// The rows of the constraints that `inputs` names under `active`.
inline ActiveRows find_active_rows(const Scene& scene) {
  ActiveRows found(scene.inputs.active.size());
  std::size_t row = 0;
  const auto pass = [&](const std::string& name, const auto& rows) {
    const auto& names = scene.inputs.active;
    const auto named = std::find(names.begin(), names.end(), name);
    for (const bool holds : rows) {
      if (!holds) continue;
      if (named != names.end()) {
        found[static_cast<std::size_t>(named - names.begin())].push_back(row);
      }
      ++row;
    }
  };
  for (const ScenePoint& held : scene.constraints) pass(held.name, held.rows);
  for (const SceneLoop& loop : scene.loops) pass(loop.first.name, loop.second.rows);
  return found;
}

/// The share to which each of the first `count` rows is held, from one of each constraint that
/// comes and goes; 1 of all others. Nothing where there are no shares.
template <class Scalar>
std::vector<Scalar> shares_of_rows(const ActiveRows& active, std::size_t count,
                                   const std::vector<Scalar>& shares) {
  if (shares.empty()) return {};
  std::vector<Scalar> of_rows(count, Scalar(1.0));
  for (std::size_t k = 0; k < active.size(); ++k) {
    for (const std::size_t row : active[k]) of_rows[row] = shares[k];
  }
  return of_rows;
}

}  // namespace treeline
