#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "choice/choose_functions.hpp"
#include "functions/function.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/graph_run.hpp"

namespace treeline {

/// Reference values of one function at one state, known before any compiled code has run.
struct FunctionReference {
  /// The interpreter's result in 50 digits, rounded to 106 bits: high + low.
  std::vector<double> high, low;
  std::vector<double> size;  ///< size of each entry's terms, see `TermSizes`
  /// Result of the expression graph evaluated in Real, which the code must reproduce. Empty if
  /// unknown.
  std::vector<double> graph;
  /// Condition number of the matrix that the function solves with, scaled to a unit diagonal and so
  /// independent of units; the larger one where it solves twice. 1 for functions without a solve.
  double condition = 1;
  double amplification = 1;  ///< of rounding errors by its solves, see `Conditions`
  /// The condition number leaves no correct digit in Real. The reference result is absent then.
  bool singular = false;
  /// For a singular solve: rows of the task are relaxed and the interpreter's result in Real is
  /// finite, so the code's result must be finite too.
  bool stays_finite = false;
  double interpreter_error = 0;  ///< error of the interpreter in Real, in ulp
  /// Sum of the magnitudes of the angles that the code computes as q + offset instead of reading
  /// them from q. Rounding them is like rounding q, so this many ulp are allowed.
  double computed_angles = 0;
  double border_steps = 0;  ///< see `ResultSizes::border_steps`
};

/// One state with the references of its functions, in the order of `all_callable`.
struct StateReference {
  State state;
  std::vector<FunctionReference> functions;
};

/// Called whenever a state is done, from several threads but never at the same time.
using Progress = std::function<void(int done, int total)>;

/// States to draw, and the number of cores to use.
struct ReferenceOptions {
  int states = 1000;
  int first = 0;                        ///< index of the first state
  std::optional<StateClass> only = {};  ///< only consecutive states of this class
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: as many as there are cores
  Progress progress = {};
};

/// Space from which the states of a robot in a scene are drawn, with every argument that the
/// functions take.
StateSpace make_state_space(const Robot& robot, const Scene& scene, const Mechanism& mechanism,
                            const std::vector<GeneratedFunction>& functions, std::uint64_t seed);

/// Draws the states, runs the interpreter in 50 digits and in Real, and evaluates the graph in
/// Real.
std::vector<StateReference> make_references(const Robot& robot, const Scene& scene,
                                            const ChosenFunctions& chosen,
                                            const ReferenceOptions& options);

/// Ulp of one: 2^-52 or 2^-23.
double unit_of(Real real);

/// Largest ratio of error to `size` over all entries, in units of `unit`. Infinite if an entry is
/// not finite, or differs although all its terms are zero.
double error_in_ulp(const std::vector<double>& actual, const FunctionReference& reference,
                    double unit);

/// Whether all entries are finite.
bool are_finite(const std::vector<double>& entries);

}  // namespace treeline
