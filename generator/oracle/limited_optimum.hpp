#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "description/scene.hpp"
#include "emission/limit_facts.hpp"
#include "interpreter/digits50.hpp"
#include "interpreter/types.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Torques and forces of an unlimited law at a state, and what limits them: the program of
/// emitted/limited_torque.h in the velocities and forces themselves, without its coordinates.
struct LimitProblem {
  interpreter::Matrix<Digits50> M, J_s, J_t;
  interpreter::Vector<Digits50> tau, f;
  double hierarchy = 1;    ///< k of the cost
  double least_share = 0;  ///< to which supports must be held to have cones
  /// To which held rows are held and task rows are done; empty: 1.
  interpreter::Vector<Digits50> held_shares = {}, task_shares = {};
};

/// The problem at a state; `tau` and `f` as the generated code has computed them.
LimitProblem limit_problem(const Subject<Digits50>& subject, const State& state,
                           const std::vector<double>& tau, const std::vector<double>& f,
                           double hierarchy, double least_share);

/// Which side of a limit is reached: -1 the lower, 1 the upper, 0 none. Limits are those of motors
/// in the order of velocities, of cones, and the least slack, 0.
using LimitSides = std::vector<int>;

/// The point of least cost within limits.
struct LimitedOptimum {
  interpreter::Vector<Digits50> tau, f;
  interpreter::Vector<Digits50> lost;  ///< accelerations of task rows before less those after
  Digits50 lost_size;                  ///< size of the terms of these
  Digits50 slack;
  int corrections = 0;  ///< how often the sides that were given first had to be changed
  LimitSides sides;     ///< the limits that are reached
};

/// Changes M, J_s and J_t at random, as velocities changed by about `unit` of themselves would, and
/// entries of J_s, tau and f as much: the effect of rounding these numbers alone. Relations between
/// rows stay. The same seed gives the same problem.
LimitProblem perturbed(const LimitProblem& problem, double unit, std::uint64_t seed);

/// The point of least cost with these limits reached, whatever the others are.
LimitedOptimum point_at_limits(const LimitProblem& problem, const LimitFacts& facts,
                               const LimitSides& sides);

/// Whether no more changes keep the equations than in ordinary states, whose freedoms the generated
/// code has, and their number is certain. Held rows that depend on each other only here leave more;
/// of those that all but depend on each other rounding decides whether they do.
bool fits_freedoms(const LimitProblem& problem, const LimitFacts& facts, Real real);

/// Solves the KKT system of the limits that are reached in 50 digits, and changes these until all
/// conditions hold: no limit is exceeded, and no multiplier has the wrong sign. The cost is
/// strictly convex in what the equations leave free, so that this certifies the point. Nothing
/// where `most` changes do not do.
std::optional<LimitedOptimum> find_limited_optimum(const LimitProblem& problem,
                                                   const LimitFacts& facts, LimitSides sides,
                                                   int most = 60);

}  // namespace treeline
