#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/algebra/pivot_rule.hpp"
#include "recursion/algebra/row_space.hpp"

namespace treeline {

/// Velocities that couplings determine, and how. With C the rows that do not depend on rows before
/// them, C qd = c says
///     qd_D = G qd_I + S c,  S = C_D^-1,  G = -S C_I,
/// D: dependent velocities, I: the others. All of it is constant and has 50 digits.
struct CoupledVelocities {
  std::vector<std::size_t> independent;  ///< ascending, so that factors of M keep their zeros
  std::vector<std::size_t> dependent;
  std::vector<std::size_t> rows;  ///< couplings that do not depend on couplings before them
  Digits50Rows G;                 ///< dependent x independent
  Digits50Rows S;                 ///< dependent x rows
};

/// Chooses the dependent velocities: those that move little in proportion to what a row moves, so
/// that the force of a coupling is no small difference of large ones, and of these the ones that
/// the fewest other velocities are coupled with through M. Nothing if the rows do not alone hold
/// the robot (rows of points and loops move with the pose), or if a velocity moves no inertia.
std::optional<CoupledVelocities> choose_dependents(const Mechanism& mechanism);

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
