#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mechanism/mechanism.hpp"
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

}  // namespace treeline
