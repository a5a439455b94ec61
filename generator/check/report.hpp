#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bounds/bound_rounding.hpp"
#include "emission/compare_files.hpp"
#include "oracle/bound.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/reference.hpp"
#include "passes/count_operations.hpp"

namespace treeline {

/// What is known of a function's rounding errors, beside what was found.
struct RoundingReport {
  RoundingBound::Kind kind = RoundingBound::Kind::none;
  double error = 0;  ///< the largest of any result that is stated, SI units
  double used = 0;   ///< the largest share of an entry's bound that an error was
  int states = 0;    ///< for which it holds
};

/// The verdict on one function and what it rests on.
struct FunctionReport {
  std::string name, method;
  std::optional<OperationCount> count;  ///< absent for what is composed of other functions
  std::optional<int> code_bytes, stack_bytes;
  double compile_seconds = 0;
  bool is_long = false;  ///< compiled with fewer passes, see CheckReport::long_command

  int states = 0;                     ///< at which the function was called
  int singular = 0;                   ///< of these, where no truth can be compared with
  double median = 0, percent_99 = 0;  ///< error in ulp of the scale
  ErrorAt worst;                      ///< the largest error
  ErrorAt nearest;                    ///< the error that is most of its bound
  double interpreter_worst = 0;       ///< what the interpreter errs by in Real
  Bound bound;
  std::optional<RoundingReport> rounding;  ///< nothing where no bound is known
  int beyond_bound = 0;                    ///< states whose error exceeds the bound
  int out_of_bounds = 0;                   ///< states at which it wrote beyond its outputs
  bool bits_known = true;                  ///< whether it is known which bits must come out
  int bits_differ = 0;                     ///< states whose result is not the graph's, to the bit
  std::optional<int> first_bits_differ;    ///< state

  [[nodiscard]] bool has_errors() const { return states > singular; }
  /// Singular at states of every class: the robot or its task gives the function no value, whose
  /// bits are all there is to compare.
  [[nodiscard]] bool has_no_value() const {
    return singular == states && states >= kStatesOfEveryClass && bits_known;
  }
  [[nodiscard]] bool passed() const {
    return beyond_bound == 0 && (!rounding || rounding->used <= 1) && out_of_bounds == 0 &&
           bits_differ == 0 && (has_errors() || has_no_value());
  }
};

/// Everything `treeline check` has to say.
struct CheckReport {
  std::string name, robot;
  bool single_precision = false;
  int states = 0, first_state = 0;
  std::uint64_t seed = 1;
  std::string compile_command, exact_command;
  std::string long_command;  ///< for long functions, with fewer passes; empty: for none
  double compile_seconds = 0, reference_seconds = 0;
  long compile_peak_kib = 0;
  std::string folder;                 ///< that was compiled; empty: what is generated now
  std::vector<FileDifference> stale;  ///< how that folder differs from what is generated now
  std::string domain;                 ///< of inputs, where what is known of rounding errors holds
  std::vector<FunctionReport> functions;
  std::vector<State> named_states;  ///< each state that a function's report names, once

  [[nodiscard]] bool passed() const;
};

/// Decimal digits that an error of so many ulp leaves of the scale of the report's results: 0 to
/// 16.3, in float to 7.5.
double digits_left(const CheckReport& report, double error_in_ulp);

/// A table, then a line for each function that leaves less than half of the digits of Real, one for
/// each thing that is wrong, then the verdict.
std::string print_text(const CheckReport& report);
std::string print_json(const CheckReport& report);

}  // namespace treeline
