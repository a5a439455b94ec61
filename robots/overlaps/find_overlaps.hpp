#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline::experiments {

/// A recorded motion and what is asked about it.
struct OverlapQuestion {
  std::string robot;   ///< URDF; or a scene that lists robots
  std::string scene;   ///< of a URDF; may be empty
  std::string motion;  ///< table of an experiment
  bool floor = true;   ///< the ground z = 0 is a body, too
  bool itself = true;  ///< links may not overlap each other either
  /// Pairs that may overlap, each the ends of two links' names, `hand:wrist1`, that have the same
  /// beginning. Links that a joint connects may overlap always.
  std::vector<std::string> left_out;
};

/// Two bodies that were inside each other.
struct Overlap {
  std::string first;
  std::string second;
  double depth = 0;  ///< the largest, m
  double time = 0;   ///< of that depth, s
};

/// Overlaps that are allowed: below what is seen, above what stiff grounds and walls yield, m.
inline constexpr double kAllowedOverlap = 1e-3;

/// Pairs out of a file, the first word of each line that is no comment; none without the file.
std::vector<std::string> read_left_out(const std::string& path);

/// How deep a robot's `<collision>` shapes, the objects in its hands, obstacles and the ground are
/// in each other during a motion, by FCL: pairs of bodies from the deepest on. Looks every 5 ms.
/// Nothing, with errors, where a file cannot be read or a robot has no such shape.
std::optional<std::vector<Overlap>> find_overlaps(const OverlapQuestion& question,
                                                  Diagnostics& diagnostics);

}  // namespace treeline::experiments
