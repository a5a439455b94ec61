#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/bench_report.hpp"
#include "bench/find_peers.hpp"
#include "text/align_columns.hpp"

namespace treeline {
namespace {

std::string error(double x) {
  if (x == 0) return "0";
  return fmt::format("{:.1e}", x);
}

std::string name_of(const Variant& variant) {
  std::string text = variant.name;
  for (const std::string& repeat : variant.repeats) text += "; " + repeat;
  return text;
}

std::string print_disagreeing(const BenchFunction& function) {
  std::string text;
  for (const BenchRow& row : function.disagreeing) {
    text += fmt::format("left out: {} disagrees, by {} at the median, {} at worst\n",
                        row.variant.name, error(row.norm.median), error(row.norm.worst));
  }
  return text;
}

std::string print_choice(const BenchFunction& function) {
  const auto fastest = find_fastest_rejected(function);
  if (!fastest) return {};
  const std::string verdict =
      fastest->is_faster ? fmt::format("more than {:.0f} % faster: let `generate --tune` choose",
                                       kFasterRoute * 100)
                         : fmt::format("none is more than {:.0f} % faster", kFasterRoute * 100);
  return fmt::format(
      "rejected routes: the fastest takes {:.2f} of the time of the emitted one; {}\n",
      fastest->row->timing.ratio, verdict);
}

std::string print_function(const BenchFunction& function) {
  std::vector<std::vector<std::string>> rows;
  for (const BenchRow& row : function.rows) {
    rows.push_back({row.on_front ? "*" : "", print_time(row.timing.nanoseconds),
                    fmt::format("{:.2f}", row.timing.ratio), error(row.norm.median),
                    error(row.norm.percent_99), error(row.norm.worst), error(row.component.median),
                    error(row.component.percent_99), error(row.component.worst),
                    row.variant.flops > 0 ? fmt::format("{}", row.variant.flops) : "",
                    name_of(row.variant)});
  }
  std::string title = function_name(function.function);
  if (!function.rows.front().variant.method.empty()) {
    title += fmt::format(", {}", function.rows.front().variant.method);
  }
  if (function.function == Function::constrained_forward_dynamics) {
    title += "; double at states that keep the constraints, compared by qdd";
  }
  if (function.singular > 0) {
    title += fmt::format("; {} of {} states left out, singular in float", function.singular,
                         function.singular + function.states);
  }
  return title + "\n" +
         align_columns({{""},
                        {"ns", true},
                        {"ratio", true},
                        {"norm 50 %", true},
                        {"99 %", true},
                        {"worst", true},
                        {"comp 50 %", true},
                        {"99 %", true},
                        {"worst", true},
                        {"flops", true},
                        {"variant"}},
                       rows) +
         print_choice(function) + print_disagreeing(function) + "\n";
}

/// Prints `beside KDL 1.5.1, which has no lambda; has no floating base`, one line per peer, and the
/// absent peers.
std::string print_peers(const BenchReport& report) {
  std::string text;
  for (const BenchPeer& peer : report.peers) {
    text += fmt::format("beside {} {}", peer.name, peer.release);
    if (!peer.remarks.empty()) text += fmt::format(", which {}", fmt::join(peer.remarks, "; "));
    text += "\n";
  }
  if (!report.no_peers.empty()) text += fmt::format("without peers: {}\n", report.no_peers);
  if (!report.absent_peers.empty()) {
    text += fmt::format("without {}: {}\n", fmt::join(report.absent_peers, ", "), kBringPeers);
  }
  return text;
}

}  // namespace

std::string print_time(double nanoseconds) {
  return fmt::format("{:.{}f}", nanoseconds, nanoseconds < 100 ? 1 : 0);
}

std::string print_table(const BenchReport& report) {
  const BenchMachine& machine = report.machine;
  std::string text = fmt::format(
      "{}: time of a call and error against 50 digits, {} states, seed {}\n"
      "on {}\ncompiled by {}\n       with {}\ninterpreter by {}\n{}\n",
      report.name, report.states, report.seed, machine.processor, machine.compiler, machine.command,
      machine.interpreter, print_peers(report));
  for (const BenchFunction& function : report.functions) text += print_function(function);
  return text;
}

}  // namespace treeline
