#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "functions/function.hpp"
#include "generation/generate_code.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/graph_run.hpp"

namespace treeline {

/// What is known of one function at one state before any compiled code has run.
struct FunctionReference {
  /// The interpreter's result in 50 digits, to 106 bits: high + low.
  std::vector<double> high, low;
  std::vector<double> size;  ///< of each entry's terms, see `TermSizes`
  /// Of the expression graph evaluated in Real: what must come out. Empty: not known.
  std::vector<double> graph;
  /// Of the matrix solved with, scaled to a unit diagonal so that no unit matters; 1 without one.
  double condition = 1;
  /// A solve with this condition leaves no digit in Real: the truth above is absent.
  bool singular = false;
  /// Of a singular solve: rows of the task yield, and the interpreter's answer in Real is finite.
  /// So must every other be.
  bool stays_finite = false;
  double interpreter_error = 0;  ///< of the interpreter in Real, in ulp
  /// The magnitudes, added up, of the angles that the code does not read from q but computes, as
  /// q + offset; their rounding is as if q were rounded, and counts so many ulp.
  double computed_angles = 0;
};

/// One state and, in the order of `all_callable`, its references.
struct StateReference {
  State state;
  std::vector<FunctionReference> functions;
};

/// Called as states are done, from several threads but never at the same time.
using Progress = std::function<void(int done, int total)>;

/// How many states, which ones, on how many cores.
struct ReferenceOptions {
  int states = 1000;
  int first = 0;                        ///< index of the first state
  std::optional<StateClass> only = {};  ///< the next states of this class, not all classes
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: as many as there are cores
  Progress progress = {};
};

/// Where the states of a robot in a scene are drawn from, with every argument that the functions
/// take.
StateSpace make_state_space(const Robot& robot, const Scene& scene, const Mechanism& mechanism,
                            const std::vector<GeneratedFunction>& functions, std::uint64_t seed);

/// Draws the states and runs the interpreter in 50 digits and in Real, and the graph in Real.
std::vector<StateReference> make_references(const Robot& robot, const Scene& scene,
                                            const Generation& generation,
                                            const ReferenceOptions& options);

/// 2^-52 or 2^-23: an ulp of one.
double unit_of(Real real);

/// The largest error over `size` of any entry, in units of `unit`. Infinite where an entry is not
/// finite, or differs although its terms are all zero.
double error_in_ulp(const std::vector<double>& actual, const FunctionReference& reference,
                    double unit);

/// Whether each of them is.
bool are_finite(const std::vector<double>& entries);

}  // namespace treeline
