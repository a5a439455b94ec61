#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bounds/bound_rounding.hpp"
#include "compilation/compile_folder.hpp"
#include "emission/compare_files.hpp"
#include "oracle/bound.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/reference.hpp"
#include "passes/count_operations.hpp"

namespace treeline {

/// A function's stated rounding error and how much of it occurred.
struct RoundingReport {
  RoundingBound::Kind kind = RoundingBound::Kind::none;
  double error = 0;  ///< largest error stated for any result, SI units
  double used = 0;   ///< largest ratio of an error to its bound
  int states = 0;    ///< number of states in which the bound holds
};

/// How far a function's equation that has a derivative in it is from holding.
struct EquationReport {
  /// Differences in 50 digits leave some 1e-20 where the equation holds.
  static constexpr double kAllowed = 1e-12;

  std::string says;  ///< the equation
  double worst = 0;  ///< largest difference of its sides, relative to its largest term
  int state = 0;     ///< index of the state of that
  int states = 0;    ///< number of states at which it was tested
};

/// Verdict on one function and the figures behind it.
struct FunctionReport {
  std::string name, method;
  std::optional<OperationCount> count;  ///< absent for functions composed of others
  std::optional<int> code_bytes, stack_bytes;
  double compile_seconds = 0;
  bool is_long = false;   ///< compiled with fewer passes, see CheckReport::long_command
  bool is_small = false;  ///< compiled to small code, see CheckReport::small_command

  int states = 0;                          ///< number of states at which the function was called
  int singular = 0;                        ///< number of these states without a reference
  double median = 0, percent_99 = 0;       ///< errors in ulp of the scale
  ErrorAt worst;                           ///< the largest error
  ErrorAt nearest;                         ///< the error with the largest ratio to its bound
  double interpreter_worst = 0;            ///< largest error of the interpreter in Real
  std::optional<EquationReport> equation;  ///< absent if it has none, or no state tests it
  Bound bound;
  std::optional<RoundingReport> rounding;  ///< absent if no bound is known
  int beyond_bound = 0;                    ///< number of states whose error exceeds the bound
  int out_of_bounds = 0;                   ///< states at which it wrote beyond its outputs
  bool bits_known = true;                  ///< whether the correct bits are known
  int bits_differ = 0;                     ///< states whose result is not the graph's to the bit
  std::optional<int> first_bits_differ;    ///< index of a state

  [[nodiscard]] bool has_errors() const { return states > singular; }
  /// Whether the function is singular at states of every class. Then the robot or its task gives
  /// the function no value, and only its bits can be compared.
  [[nodiscard]] bool has_no_value() const {
    return singular == states && states >= kStatesOfEveryClass && bits_known;
  }
  [[nodiscard]] bool passed() const {
    return beyond_bound == 0 && (!equation || equation->worst <= EquationReport::kAllowed) &&
           (!rounding || rounding->used <= 1) && out_of_bounds == 0 && bits_differ == 0 &&
           (has_errors() || has_no_value());
  }
};

/// Verdict on `limited_control_torque`. Where a limit is exceeded its result is compared with the
/// optimum that KKT conditions certify in 50 digits; where none is, with the unlimited law's bits.
struct LimitsReport {
  std::string name;  ///< of the function, or of the batch function
  int states = 0;
  int singular = 0;       ///< states at which the unlimited law has no value
  int limited = 0;        ///< states at which something was changed
  int certified = 0;      ///< of these, those whose optimum was certified and compared
  int irregular = 0;      ///< states whose freedoms are more than ordinary, or not certain
  int uncertain = 0;      ///< states whose conditions could not be met
  int unsolved = 0;       ///< states at which the iterations were used up or numbers did not fit
  int beyond_limits = 0;  ///< states with a torque beyond its limit
  int changed = 0;        ///< states within limits with other bits than the unlimited law
  int out_of_bounds = 0;  ///< states at which it wrote beyond its outputs
  int corrected = 0;      ///< of the certified, those in which other limits are reached
  double median = 0, worst = 0;      ///< errors in ulp of the scale
  std::array<double, 4> worst_of{};  ///< of tau, f, slack, and what the task loses
  int worst_state = -1;
  double worst_sensitivity = 0;  ///< there, what rounding of M, J_s, J_t, tau and f alone does
  double of_bound = 0;           ///< largest ratio of an error to what is allowed
  CompiledFunction compiled = {};

  [[nodiscard]] bool passed() const {
    return beyond_limits == 0 && changed == 0 && out_of_bounds == 0 && uncertain == 0 &&
           of_bound <= 1;
  }
};

/// Verdict on the step of an emitted controller.
struct StepReport {
  std::string name;            ///< of the function
  int motions = 0, steps = 0;  ///< that were run
  std::array<int, 4> modes{};  ///< steps that ended in each mode, in the order of `core::Mode`
  std::uint32_t faults = 0;    ///< bits of the faults that occurred
  int refused = 0;             ///< commands

  int compared = 0;  ///< steps compared with the reference
  int ties = 0;      ///< of these, those in which a comparison is decided by a rounding
  int differ = 0;    ///< steps with other modes, faults or counts than the reference
  std::string first_difference = {};
  double median = 0, percent_99 = 0, worst = 0;  ///< errors in ulp of the scale
  std::string worst_place = {};                  ///< step and member
  double of_bound = 0;                           ///< largest ratio of an error to what is allowed
  int beyond_bound = 0;
  int broken = 0;  ///< steps that do what no step may do
  std::string first_broken = {};
  std::optional<int> code_bytes = {}, stack_bytes = {};
  double compile_seconds = 0;

  [[nodiscard]] bool passed() const {
    return compared > 0 && differ == 0 && beyond_bound == 0 && broken == 0;
  }
};

/// Complete result of `treeline check`.
struct CheckReport {
  std::string name, robot;
  std::string digest;  ///< of the files that the generator makes, see `digest_of_files`
  bool single_precision = false;
  int states = 0, first_state = 0;
  std::uint64_t seed = 1;
  std::string compile_command, exact_command;
  std::string long_command;   ///< for long functions, with fewer passes; empty: there is none
  std::string small_command;  ///< for those that `optimize` makes small; empty: there is none
  double compile_seconds = 0, reference_seconds = 0;
  long compile_peak_kib = 0;
  std::string folder;                 ///< that was compiled; empty: code generated now
  std::vector<FileDifference> stale;  ///< how the folder differs from the code generated now
  std::string domain;                 ///< domain of inputs in which the rounding bounds hold
  std::vector<FunctionReport> functions;
  std::optional<LimitsReport> limits;        ///< if the scene limits torques or forces
  std::optional<LimitsReport> batch_limits;  ///< if it has a batch besides
  std::optional<StepReport> step;            ///< if it has a controller
  /// What NAME_selftest returns: 0, or the number of a function; -1 where it is missing.
  std::optional<int> selftest;
  std::vector<State> named_states;  ///< states named in the reports of functions, each once

  [[nodiscard]] bool passed() const;
};

/// Decimal digits that remain of the scale of the report's results if the error is `error_in_ulp`:
/// 0 to 16.3, for float to 7.5.
double digits_left(const CheckReport& report, double error_in_ulp);

/// Prints a table, a line for each function that keeps less than half of Real's digits, a line for
/// each fault, and the verdict.
std::string print_text(const CheckReport& report);
std::string print_json(const CheckReport& report);

/// Names of the functions of a report of which that holds, with commas.
template <class Function>
std::string list_names(const std::vector<Function>& functions, bool Function::*holds) {
  std::string names;
  for (const Function& f : functions) {
    if (f.*holds) names += (names.empty() ? "" : ", ") + f.name;
  }
  return names;
}

}  // namespace treeline
