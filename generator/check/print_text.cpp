#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/report.hpp"
#include "core/mode.hpp"
#include "emission/comment.hpp"
#include "functions/function.hpp"
#include "text/align_columns.hpp"
#include "text/round_outward.hpp"

namespace treeline {
namespace {

/// Prints three significant digits, in a form that is short for any magnitude.
std::string number(double x) {
  if (!std::isfinite(x)) return "inf";
  if (x == 0) return "0";
  if (x < 0.01 || x >= 1e5) return fmt::format("{:.1e}", x);
  if (x >= 100) return fmt::format("{:.0f}", x);
  return fmt::format("{:.{}f}", x, x >= 10 ? 1 : 2);
}

/// Prints a bound as `number` does, rounded up.
std::string up(double x) {
  const bool is_long = x < 0.01 || !(x < 1e5);
  const int digits = is_long ? 2 : x < 100 ? 3 : static_cast<int>(std::log10(x)) + 1;
  return number(round_up(x, digits));
}

std::string print_if_known(const std::optional<int>& x) {
  return x ? fmt::format("{}", *x) : "?";
}

std::string state_name(int index) {
  return fmt::format("{} {}", index, state_class_name(class_of_state(index)));
}

std::string print_bound(const Bound& bound) {
  const std::string factor = bound.solve == Solve::none
                                 ? std::string()
                                 : fmt::format(" x condition of {}", matrix_symbols(bound.solve));
  return fmt::format("{:.0f} + {}{}", Bound::kFloorUlp,
                     up(Bound::kInterpreterFactor * bound.interpreter), factor);
}

/// Prints the stated rounding error, with a tilde if it is of first order.
std::string print_rounding(const std::optional<RoundingReport>& rounding) {
  if (!rounding) return "none";
  return rounding->kind == RoundingBound::Kind::proven ? rounded_up(rounding->error, 2)
                                                       : "~" + rounded_up(rounding->error, 1);
}

std::string print_bits(const FunctionReport& function) {
  if (!function.bits_known) return "unknown";
  return function.bits_differ == 0 ? "equal" : fmt::format("{} differ", function.bits_differ);
}

std::vector<std::string> print_step_row(const CheckReport& report, const StepReport& step) {
  return {step.name,
          number(step.median),
          number(step.percent_99),
          number(step.worst),
          fmt::format("{:.1f}", digits_left(report, step.worst)),
          "",
          "",
          "see below",
          "see below",
          fmt::format("{} %", number(100 * step.of_bound)),
          "none",
          "",
          "",
          step.differ == 0 ? "modes equal" : fmt::format("{} differ", step.differ),
          "",
          print_if_known(step.code_bytes),
          print_if_known(step.stack_bytes),
          fmt::format("{:.1f}", step.compile_seconds)};
}

std::string print_table(const CheckReport& report) {
  std::vector<std::vector<std::string>> rows;
  for (const FunctionReport& f : report.functions) {
    const bool any = f.has_errors();
    const auto error = [any](double x) { return any ? number(x) : std::string("-"); };
    rows.push_back(
        {f.name, error(f.median), error(f.percent_99), error(f.worst.error),
         any ? fmt::format("{:.1f}", digits_left(report, f.worst.error)) : "-",
         error(f.interpreter_worst), f.equation ? fmt::format("{:.0e}", f.equation->worst) : "",
         any ? state_name(f.worst.state) : "-", print_bound(f.bound),
         any ? fmt::format("{} %", number(100 * f.nearest.error / f.nearest.bound)) : "-",
         print_rounding(f.rounding),
         f.rounding && f.rounding->states > 0 ? fmt::format("{} %", number(100 * f.rounding->used))
                                              : "",
         f.singular == 0 ? "" : fmt::format("{}", f.singular), print_bits(f),
         f.count ? fmt::format("{}", f.count->flops()) : "", print_if_known(f.code_bytes),
         print_if_known(f.stack_bytes), fmt::format("{:.1f}", f.compile_seconds)});
  }
  if (report.step) rows.push_back(print_step_row(report, *report.step));
  return align_columns({{"function", false, true},
                        {"median", true},
                        {"99 %", true},
                        {"worst", true},
                        {"digits", true},
                        {"interp", true},
                        {"equation", true},
                        {"worst state"},
                        {"bound"},
                        {"of bound", true},
                        {"rounding", true},
                        {"of rounding", true},
                        {"singular", true},
                        {"bits"},
                        {"flops", true},
                        {"code B", true},
                        {"stack B", true},
                        {"cc s", true}},
                       rows);
}

std::string print_head(const CheckReport& report) {
  const char* const real = report.single_precision ? "float" : "double";
  std::string text = fmt::format("{} ({}): {} states from {}, seed {}\n", report.name, real,
                                 report.states, report.first_state, report.seed);
  if (!report.folder.empty()) text += fmt::format("  code: {}\n", report.folder);
  text += fmt::format("  compiled by {} in {:.1f} s, {} MB\n", report.compile_command,
                      report.compile_seconds, report.compile_peak_kib / 1024);
  if (!report.small_command.empty()) {
    text +=
        fmt::format("  by {}: {},\n  as the emitted CMakeLists.txt does for `optimize`\n",
                    report.small_command, list_names(report.functions, &FunctionReport::is_small));
  }
  if (!report.long_command.empty()) {
    text += fmt::format(
        "  by {}: {}, of more than 12000 operations, lest it take minutes;\n"
        "  --flags compiles all alike\n",
        report.long_command, list_names(report.functions, &FunctionReport::is_long));
  }
  if (report.exact_command != report.compile_command) {
    text += fmt::format("  bits compared as compiled by {}\n", report.exact_command);
  }
  return text + "  errors against 50 digits, in ulp of the scale\n\n";
}

/// Warns if less than half of the digits remain although the error is within the bound.
std::string print_warning(const CheckReport& report, const FunctionReport& f) {
  const double digits = digits_left(report, f.worst.error);
  if (!f.has_errors() || digits >= 0.5 * digits_left(report, 0)) return {};
  const std::string condition =
      f.bound.solve == Solve::none
          ? std::string()
          : fmt::format(", where the condition of {} is {}", matrix_symbol(f.bound.solve),
                        number(f.worst.condition));
  return fmt::format("{}: few digits: {:.1f} left at {}{}\n", f.name, digits,
                     state_name(f.worst.state), condition);
}

std::string print_faults(const FunctionReport& f) {
  std::string text;
  const auto add = [&](const std::string& fault) { text += f.name + ": " + fault + "\n"; };
  if (f.has_no_value()) {
    add(
        fmt::format("no value to check: {} is singular at all {} states, of every class; its bits "
                    "were compared",
                    matrix_symbol(f.bound.solve), f.states));
  } else if (!f.has_errors()) {
    add("not checked: every state is singular, and nothing was compared with the truth");
  }
  if (f.beyond_bound > 0) {
    add(fmt::format("beyond its bound at {} of {} states; at {} the error is {} ulp, allowed {}",
                    f.beyond_bound, f.states - f.singular, state_name(f.nearest.state),
                    number(f.nearest.error), up(f.nearest.bound)));
  }
  if (f.equation && !(f.equation->worst <= EquationReport::kAllowed)) {
    add(
        fmt::format("its equation does not hold: of {} the sides differ by {} of the largest term "
                    "at {}",
                    f.equation->says, number(f.equation->worst), state_name(f.equation->state)));
  }
  if (f.rounding && f.rounding->used > 1) {
    add(fmt::format("errs by {} times what its expression graph permits",
                    number(f.rounding->used)));
  }
  if (f.out_of_bounds > 0) {
    add(fmt::format("writes beyond its outputs at {} states", f.out_of_bounds));
  }
  if (f.bits_differ > 0) {
    add(
        fmt::format("not what was generated: other bits than the expression graph at {} of {} "
                    "states, first at {}",
                    f.bits_differ, f.states, state_name(*f.first_bits_differ)));
  }
  return text;
}

std::string print_limit_errors(const CheckReport& report, const LimitsReport& limits) {
  if (limits.certified == 0) return "there is no error to tell";
  return fmt::format(
      "errors in ulp of the scale {} at the median, {} at most ({:.1f} digits, state {}, where "
      "rounding of the matrices alone does {}; tau {}, f {}, slack {}, lost {}), {} % of what is "
      "allowed; in {} other limits are reached",
      number(limits.median), number(limits.worst), digits_left(report, limits.worst),
      state_name(limits.worst_state), number(limits.worst_sensitivity), number(limits.worst_of[0]),
      number(limits.worst_of[1]), number(limits.worst_of[2]), number(limits.worst_of[3]),
      number(100 * limits.of_bound), limits.corrected);
}

std::string print_limits(const CheckReport& report, const LimitsReport& limits) {
  std::string text = fmt::format(
      "{}: something is limited at {} of {} states. {} of these were compared with the optimum "
      "that "
      "KKT conditions certify in 50 digits: {}",
      limits.name, limits.limited, limits.states, limits.certified,
      print_limit_errors(report, limits));
  const auto note = [&text](int count, const char* what) {
    if (count > 0) text += fmt::format("; {} {}", count, what);
  };
  note(
      limits.irregular,
      "were not, where held rows depend or all but depend on each other as they ordinarily do not");
  note(limits.unsolved, "are not solved, as their status says, and only clipped");
  note(limits.singular, "have no value of the unlimited law");
  text += fmt::format(". Code {} B, stack {} B, compiled in {:.1f} s",
                      print_if_known(limits.compiled.code_bytes),
                      print_if_known(limits.compiled.stack_bytes), limits.compiled.seconds);
  text = wrap_text(text + ".", 99) + "\n";
  const auto fault = [&](int count, const char* what) {
    if (count > 0) text += fmt::format("{}: {} at {} states\n", limits.name, what, count);
  };
  fault(limits.beyond_limits, "torques beyond their limits");
  fault(limits.changed, "changes what is within its limits");
  fault(limits.out_of_bounds, "writes beyond its outputs");
  fault(limits.uncertain, "no limits that meet the KKT conditions were found");
  if (!(limits.of_bound <= 1)) text += limits.name + ": beyond its bound\n";
  return text + "\n";
}

/// `idle 120, running 1503, stopping 12, faulted 900`
std::string print_modes(const StepReport& step) {
  std::string text;
  for (std::size_t i = 0; i < step.modes.size(); ++i) {
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", core::mode_name(static_cast<core::Mode>(i)),
                        step.modes[i]);
  }
  return text;
}

std::string print_step(const StepReport& step) {
  std::string text = fmt::format(
      "{}: {} steps in {} motions (in mode {}), with {} commands refused and faults 0x{:x}. {} "
      "were "
      "compared with the same laws in long double, with dynamics of 50 digits: at most {} % of "
      "what "
      "is allowed, in {}; {} hang on a comparison that a rounding decides.",
      step.name, step.steps, step.motions, print_modes(step), step.refused, step.faults,
      step.compared, number(100 * step.of_bound),
      step.worst_place.empty() ? "none" : step.worst_place, step.ties);
  text = wrap_text(text, 99) + "\n";
  if (step.differ > 0) {
    text += fmt::format("{}: not what the laws give in {} of {} steps, first {}\n", step.name,
                        step.differ, step.compared, step.first_difference);
  }
  if (step.beyond_bound > 0) {
    text += fmt::format("{}: beyond its bound in {} of {} steps, most in {}\n", step.name,
                        step.beyond_bound, step.compared, step.worst_place);
  }
  if (step.broken > 0) {
    text += fmt::format("{}: {}; so are {} of {} steps\n", step.name, step.first_broken,
                        step.broken, step.steps);
  }
  return text + "\n";
}

const char* difference_name(Difference difference) {
  switch (difference) {
    case Difference::missing:
      return "missing";
    case Difference::changed:
      return "stale";
    case Difference::left_over:
      return "left over";
  }
  return "";
}

}  // namespace

double digits_left(const CheckReport& report, double error_in_ulp) {
  const double unit = unit_of(report.single_precision ? Real::float32 : Real::float64);
  if (!(error_in_ulp * unit < 1)) return 0;
  return -std::log10(std::max(error_in_ulp, 0.25) * unit);
}

std::string print_text(const CheckReport& report) {
  std::string text = print_head(report) + print_table(report) + "\n";
  if (!report.domain.empty()) {
    text += wrap_text("rounding: for inputs of " + report.domain, 99) + "\n\n";
  }
  int failed = 0;
  for (const auto* limits : {&report.limits, &report.batch_limits}) {
    if (!*limits) continue;
    text += print_limits(report, **limits);
    failed += (*limits)->passed() ? 0 : 1;
  }
  if (report.step) {
    text += print_step(*report.step);
    failed += report.step->passed() ? 0 : 1;
  }
  if (report.selftest) {
    text += fmt::format("{}_selftest returns {}\n", report.name, *report.selftest);
    failed += *report.selftest == 0 ? 0 : 1;
  }
  for (const FileDifference& file : report.stale) {
    text += fmt::format("{}/{}: {}\n", report.folder, file.name, difference_name(file.difference));
  }
  int without_value = 0;
  for (const FunctionReport& function : report.functions) {
    text += print_warning(report, function);
    text += print_faults(function);
    failed += function.passed() ? 0 : 1;
    without_value += function.has_no_value() ? 1 : 0;
  }
  if (report.passed()) {
    return text + fmt::format("passed: {} functions equal to the bit and within their bounds{}{}\n",
                              report.functions.size(),
                              report.step ? ", and the controller's step" : "",
                              without_value == 0
                                  ? ""
                                  : fmt::format(", {} of them without a value", without_value));
  }
  return text + fmt::format("FAILED: {} of {} functions, {} files not up to date\n", failed,
                            report.functions.size() + (report.step ? 1 : 0), report.stale.size());
}

}  // namespace treeline
