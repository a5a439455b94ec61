#include <fmt/format.h>

#include <cmath>

#include "board/board_report.hpp"
#include "check/report.hpp"
#include "core/mode.hpp"
#include "emission/comment.hpp"
#include "text/align_columns.hpp"

namespace treeline {
namespace {

constexpr std::size_t kColumns = 99;

/// The least and the most of a count; one number where they are the same.
std::string print_range(std::uint64_t least, std::uint64_t most) {
  return least == most ? std::to_string(most) : fmt::format("{}..{}", least, most);
}

/// Rounds to two digits: more would pretend to be a measurement.
std::string print_estimate(double cycles) {
  const double unit =
      std::pow(10, std::max(0.0, std::floor(std::log10(std::max(cycles, 1.0))) - 1));
  return fmt::format("{:.0f}", std::round(cycles / unit) * unit);
}

std::string print_results(const BoardFunction& f, bool contracted) {
  if (!contracted) return f.bits_differ == 0 ? "equal" : fmt::format("{} differ", f.bits_differ);
  return fmt::format("{:.1f} ulp", f.worst);
}

std::string print_board_table(const BoardReport& report) {
  const char* const results = report.contracted ? "error" : "bits";
  std::vector<Column> columns{
      {"function"}, {"text", true}, {"const", true}, {"stack", true}, {"seen", true}};
  if (report.counts_instructions) {
    columns.insert(columns.end(), {{"instructions", true}, {"cycles, about", true}});
  }
  if (report.counts_cycles) columns.push_back({"cycles", true});
  columns.insert(columns.end(), {{results, true}, {"library"}});
  std::vector<std::vector<std::string>> rows;
  for (const BoardFunction& f : report.functions) {
    const std::string library =
        f.arithmetic.empty() ? "" : fmt::format("{} functions", f.arithmetic.size());
    std::vector<std::string>& row = rows.emplace_back();
    row = {f.name, std::to_string(f.text_bytes), std::to_string(f.constant_bytes),
           f.stack_bytes ? std::to_string(*f.stack_bytes) : "?", std::to_string(f.stack_seen)};
    if (report.counts_instructions) {
      row.insert(row.end(), {print_range(f.least, f.most), print_estimate(f.cycles)});
    }
    if (report.counts_cycles) row.push_back(print_range(f.least_cycles, f.most_cycles));
    row.insert(row.end(), {print_results(f, report.contracted), library});
  }
  return align_columns(columns, rows);
}

std::string print_costs(const CycleCosts& c) {
  return wrap_text(
      fmt::format("cycles, about: {} a load or store, {} a branch, {} a sum or product, {} a fused "
                  "one, {} a quotient or root of floats and {} of doubles, {} for all else ({})",
                  c.memory, c.branch, c.arithmetic, c.fused, c.divide_float, c.divide_double,
                  c.other, c.source),
      kColumns);
}

/// Instructions of a controller's step by the mode that it ended in.
std::string print_modes(const BoardFunction& f) {
  std::string text;
  for (std::size_t i = 0; i < f.modes.size(); ++i) {
    const BoardFunction::Mode& mode = f.modes[i];
    if (mode.steps == 0) continue;
    text += fmt::format("{}{} {}..{}", text.empty() ? "" : ", ",
                        core::mode_name(static_cast<core::Mode>(i)), mode.least, mode.most);
  }
  return text.empty() ? text : fmt::format("{}: instructions by mode: {}\n", f.name, text);
}

std::string print_board_faults(const BoardReport& report, const BoardFunction& f) {
  std::string text;
  if (!f.strays.empty()) {
    text += fmt::format("{}: needs {}\n", f.name, fmt::join(f.strays, ", "));
  }
  if (f.static_bytes > 0) {
    text += fmt::format("{}: has {} bytes of variables\n", f.name, f.static_bytes);
  }
  if (f.returned != 0) {
    text += fmt::format("{}: returns {}, which its header explains\n", f.name, f.returned);
  } else if (!report.contracted && f.bits_differ > 0) {
    text += fmt::format("{}: other bits than on the host in {} of {} states, first in {}\n", f.name,
                        f.bits_differ, f.states, *f.first_bits_differ);
  }
  if (f.beyond_bound > 0) {
    text +=
        fmt::format("{}: beyond its bound in {} of {} states\n", f.name, f.beyond_bound, f.states);
  }
  return text;
}

/// The command of the functions of which that holds, if there is one, and what they are.
std::string print_other_command(const BoardReport& report, const std::string& command,
                                bool BoardFunction::*holds, const char* what) {
  if (command.empty()) return {};
  const std::string names = list_names(report.functions, holds);
  return wrap_text(fmt::format("{}: {}, {}", command, names, what), kColumns) + "\n";
}

std::string print_verdict(const BoardReport& report) {
  int failed = 0, varying = 0;
  for (const BoardFunction& f : report.functions) {
    failed += f.passed(report.contracted) ? 0 : 1;
    varying += f.takes_constant_time() ? 0 : 1;
  }
  if (!report.passed()) {
    return fmt::format("FAILED: {} of {} functions, {} files not up to date\n", failed,
                       report.functions.size(), report.stale.size());
  }
  const std::string time =
      !report.counts_instructions ? "whose instructions this board does not count"
      : varying == 0              ? "the same number of instructions in every state"
                     : fmt::format("{} of them in a time that depends on the state", varying);
  return fmt::format("passed: {} functions {}, {}\n", report.functions.size(),
                     report.contracted ? "within their bounds" : "equal to the host's to the bit",
                     time);
}

}  // namespace

std::string print_text(const BoardReport& report) {
  std::string text = fmt::format("{} ({}) in {} for {}, {}; {} states\n{}\n{}\n", report.name,
                                 report.robot, report.single_precision ? "float" : "double",
                                 report.target->name, report.target->about, report.states,
                                 report.compiler, wrap_text(report.command, kColumns));
  text += print_other_command(report, report.small_command, &BoardFunction::is_small,
                              "as the emitted CMakeLists.txt does for `optimize`");
  text += print_other_command(report, report.long_command, &BoardFunction::is_long,
                              "of more than 12000 operations; --flags compiles all alike");
  text += wrap_text(report.runner, kColumns) + "\n\n" + print_board_table(report) + "\n";
  if (report.counts_instructions) text += print_costs(report.target->cycles) + "\n\n";
  for (const BoardFunction& f : report.functions) text += print_modes(f);
  for (const std::string& name : report.not_run) {
    text += fmt::format("{}: not run, it takes several states at once\n", name);
  }
  for (const FileDifference& file : report.stale) {
    text += fmt::format("{}/{}: not up to date\n", report.folder, file.name);
  }
  for (const BoardFunction& f : report.functions) text += print_board_faults(report, f);
  return text + print_verdict(report);
}

}  // namespace treeline
