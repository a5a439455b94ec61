#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bench/suite.hpp"
#include "text/align_columns.hpp"

namespace treeline {
namespace {

std::string bytes_of(const BenchRow& row) {
  const bool known = row.compiled && row.compiled->code_bytes;
  return known ? fmt::format("{}", *row.compiled->code_bytes) : "";
}

/// Adds a peer's time, how many times the emitted code's that is, its error and its name.
void add_peer(const BenchRow* peer, double time, std::vector<std::string>& cells) {
  if (peer == nullptr) {
    cells.insert(cells.end(), {"", "", "", "none has it"});
    return;
  }
  const double theirs = peer->timing.nanoseconds;
  cells.insert(cells.end(), {print_time(theirs), fmt::format("{:.1f}", theirs / time),
                             fmt::format("{:.1e}", peer->norm.worst), peer->variant.name});
}

std::vector<std::string> cells_of(const SuiteResult& result) {
  const BenchRow& emitted = *result.emitted;
  const double time = emitted.timing.nanoseconds;
  std::vector<std::string> cells{result.scene, function_name(result.function), print_time(time)};
  cells.push_back(result.in_c != nullptr ? print_time(result.in_c->timing.nanoseconds) : "");
  cells.push_back(result.batch != nullptr ? print_time(result.batch->timing.nanoseconds) : "");
  cells.push_back(fmt::format("{:.2f}", emitted.placement));
  cells.push_back(bytes_of(emitted));
  cells.push_back(emitted.compiled ? fmt::format("{:.1f}", emitted.compiled->seconds) : "");
  cells.push_back(fmt::format("{:.1e}", emitted.norm.worst));
  add_peer(result.best, time, cells);
  add_peer(result.recorded, time, cells);
  return cells;
}

/// The peers and their releases, once each.
std::vector<std::string> name_peers(const std::vector<BenchReport>& reports) {
  std::vector<std::string> names;
  for (const BenchReport& report : reports) {
    for (const BenchPeer& peer : report.peers) {
      const std::string name = peer.name + " " + peer.release;
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

/// What peers cannot do, by robot.
std::string print_remarks(const std::vector<BenchReport>& reports) {
  std::string text;
  for (const BenchReport& report : reports) {
    if (!report.no_peers.empty()) {
      text += fmt::format("{}: no peers, {}\n", report.name, report.no_peers);
    }
    for (const BenchPeer& peer : report.peers) {
      if (peer.remarks.empty()) continue;
      text += fmt::format("{}: {} {}\n", report.name, peer.name, fmt::join(peer.remarks, "; "));
    }
    for (const BenchFunction& function : report.functions) {
      for (const BenchRow& row : function.disagreeing) {
        text += fmt::format("{}: {} of {} disagrees, by {:.1e} at the median\n", report.name,
                            function_name(function.function), row.variant.name, row.norm.median);
      }
    }
  }
  return text;
}

void keep_faster(const BenchRow& row, const BenchRow*& fastest) {
  if (fastest == nullptr || row.timing.nanoseconds < fastest->timing.nanoseconds) fastest = &row;
}

}  // namespace

std::vector<SuiteResult> compare_to_best(const std::vector<BenchReport>& reports) {
  std::vector<SuiteResult> results;
  for (const BenchReport& report : reports) {
    for (const BenchFunction& function : report.functions) {
      SuiteResult result{report.name, function.function};
      for (const BenchRow& row : function.rows) {
        const VariantGroup group = row.variant.group;
        if (group == VariantGroup::emitted) result.emitted = &row;
        if (group == VariantGroup::language) result.in_c = &row;
        if (group == VariantGroup::batch) result.batch = &row;
        if (group == VariantGroup::peer) {
          keep_faster(row, row.variant.recorded ? result.recorded : result.best);
        }
      }
      results.push_back(result);
    }
  }
  return results;
}

std::string print_json_lines(const std::vector<BenchReport>& reports) {
  std::string text;
  for (const BenchReport& report : reports) text += print_json_lines(report);
  return text;
}

std::string print_table(const std::vector<BenchReport>& reports) {
  const BenchMachine& machine = reports.front().machine;
  std::vector<std::vector<std::string>> rows;
  for (const SuiteResult& result : compare_to_best(reports)) rows.push_back(cells_of(result));
  return fmt::format(
             "Time of a call in nanoseconds and largest error against 50 digits, {} states\n"
             "on {}\ncompiled by {}\n       with {}\nbeside {}\n\n",
             reports.front().states, machine.processor, machine.compiler, machine.command,
             fmt::join(name_peers(reports), ", ")) +
         align_columns({{"robot"},
                        {"function"},
                        {"C++", true},
                        {"C", true},
                        {"batch", true},
                        {"places", true},
                        {"bytes", true},
                        {"compile s", true},
                        {"error", true},
                        {"best peer", true},
                        {"times", true},
                        {"error", true},
                        {"the peer"},
                        {"recorded", true},
                        {"times", true},
                        {"error", true},
                        {"by"}},
                       rows) +
         "\n" + print_remarks(reports);
}

}  // namespace treeline
