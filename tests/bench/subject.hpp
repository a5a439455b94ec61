#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

/// One implementation of a robot's functions, which is measured. Each function has the same plain
/// call, so that a generated function and a library's solver have the same cost of being called.
namespace treeline::bench {

/// Measured functions, in the order of the report.
enum class Function {
  inverse_dynamics,
  forward_dynamics,
  mass_matrix,
  mass_matrix_inverse,
  lambda_inverse,
  lambda,
  control_torque,
  inverse_dynamics_derivatives,
  forward_dynamics_derivatives
};

/// A call of a function. The inputs are in the order of the generated contract, each an array of
/// its own: inverse_dynamics and its derivatives q qd qdd, forward_dynamics and its derivatives q
/// qd tau, matrices q, control_torque q qd qdd_0 xdd_cmd. There is one output. Matrices are
/// row-major; derivatives are three of them one after the other. A call for n states has rows of n:
/// element i of all states.
using Call = void (*)(void* solver, const double* const* inputs, double* output);

struct Routine {
  Call call = nullptr;
  std::shared_ptr<void> solver = nullptr;  ///< the call's first argument; generated code has none
  int states = 1;                          ///< number of states per call: 1, 2, 4, 8, 16
  /// Converts an output into that order if the library's own form is different but equally useful
  /// (column-major, one triangle of a symmetric matrix). Not timed.
  void (*finish)(void* solver, double* output) = nullptr;

  void operator()(const double* const* inputs, double* output) const {
    call(solver.get(), inputs, output);
  }
};

struct Subject {
  std::string implementation;  ///< for the table: "KDL", "generated, g++ -O3"
  std::map<Function, Routine> routines;
  /// For generated code: the folder with `manifest.json` and, for each function, the cost of
  /// compiling it (`FUNCTION.json`, see compile_meter.cpp). Empty for others.
  std::string facts = {};
  std::string source_prefix = {};  ///< `batch_` where that is what FUNCTION.json begins with
};

/// Makes a routine that keeps `solver` alive. `body` must not have captures.
template <class Solver>
Routine make_routine(std::shared_ptr<Solver> solver, Call body) {
  return {body, std::move(solver)};
}

}  // namespace treeline::bench
