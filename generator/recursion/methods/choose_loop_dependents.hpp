#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/algebra/pivot_rule.hpp"

namespace treeline {

/// Velocities that loops determine: those of passive joints. With J the rows that do not depend on
/// rows before them, J qd = c says
///     qd_D = G qd_I + J_D^-1 c,  G = -J_D^-1 J_I,
/// D: dependent velocities, I: the others. J turns with the pose.
struct LoopedVelocities {
  std::vector<std::size_t> independent;  ///< ascending, so that factors of M keep their zeros
  std::vector<std::size_t> dependent;    ///< in the order in which columns of J_D are eliminated
  std::vector<std::size_t> rows;         ///< rows that do not depend on rows before them
  PivotRule rule;  ///< of what columns of J_D before it leave of each, squared
  /// Whether passive joints follow the others, well away from poses where they do not, in all
  /// closed poses that were looked at: then the elimination has the digits of forces.
  bool follows = false;
};

/// The dependent velocities, or why there are none: a sentence that says what to do.
struct LoopDependents {
  std::optional<LoopedVelocities> velocities;
  std::string obstacle;
};

/// Chooses them, once for all poses: the passive velocities that move rows of loops, if there are
/// as many as rows that are independent in ordinary poses. Rows of couplings count, too. Columns
/// that move the fewest rows come first, so that the rest keeps its zeros.
LoopDependents choose_loop_dependents(const Mechanism& mechanism);

}  // namespace treeline
