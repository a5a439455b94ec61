#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/bench_report.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the number, or null for infinity and NaN, which JSON does not have.
Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json("inf");
}

Json errors(const ErrorSummary& summary) {
  return {{"median", number(summary.median)},
          {"percent_99", number(summary.percent_99)},
          {"worst", number(summary.worst)}};
}

/// Adds what the compiler made of a function.
void add_compiled(const BenchRow& row, Json& json) {
  if (!row.compiled) return;
  if (row.compiled->code_bytes) json["code_bytes"] = *row.compiled->code_bytes;
  if (row.compiled->stack_bytes) json["stack_bytes"] = *row.compiled->stack_bytes;
  json["compile_seconds"] = row.compiled->seconds;
}

Json describe(const BenchReport& report, const BenchFunction& function, const BenchRow& row) {
  const Variant& variant = row.variant;
  Json json = {{"scene", report.name},
               {"function", function_name(function.function)},
               {"group", group_name(variant.group)},
               {"variant", variant.name},
               {"repeats", variant.repeats},
               {"real", variant.real == Real::float32 ? "float" : "double"},
               {"method", variant.method},
               {"flags", variant.flags},
               {"flops", variant.flops},
               {"states_a_call", variant.states},
               {"nanoseconds", row.timing.nanoseconds},
               {"ratio", row.timing.ratio},
               {"noise", row.timing.noise},
               {"placement", row.placement},
               {"norm_error", errors(row.norm)},
               {"component_error", errors(row.component)},
               {"states", function.states},
               {"singular", function.singular},
               {"on_front", row.on_front}};
  add_compiled(row, json);
  return json;
}

/// Says whether a rejected route is faster than the emitted one.
Json describe_choice(const BenchReport& report, const BenchFunction& function,
                     const FastestRejected& fastest) {
  return {{"scene", report.name},
          {"function", function_name(function.function)},
          {"group", "choice"},
          {"fastest_rejected", fastest.row->variant.method},
          {"ratio", fastest.row->timing.ratio},
          {"noise", fastest.row->timing.noise},
          {"is_faster", fastest.is_faster}};
}

/// Describes a peer that was not timed because it computes something else.
Json describe_disagreement(const BenchReport& report, const BenchFunction& function,
                           const BenchRow& row) {
  return {{"scene", report.name},
          {"function", function_name(function.function)},
          {"group", group_name(row.variant.group)},
          {"disagrees", row.variant.name},
          {"norm_error", errors(row.norm)},
          {"component_error", errors(row.component)},
          {"states", function.states}};
}

Json describe_peers(const BenchReport& report) {
  Json peers = Json::array();
  for (const BenchPeer& peer : report.peers) {
    peers.push_back({{"name", peer.name}, {"release", peer.release}, {"remarks", peer.remarks}});
  }
  return peers;
}

}  // namespace

std::string print_json_lines(const BenchReport& report) {
  const BenchMachine& machine = report.machine;
  const Json head = {{"scene", report.name},
                     {"robot", report.robot},
                     {"processor", machine.processor},
                     {"compiler", machine.compiler},
                     {"command", machine.command},
                     {"interpreter", machine.interpreter},
                     {"states", report.states},
                     {"seed", report.seed},
                     {"peers", describe_peers(report)},
                     {"absent_peers", report.absent_peers},
                     {"no_peers", report.no_peers}};
  std::string text = json_line(head) + "\n";
  for (const BenchFunction& function : report.functions) {
    for (const BenchRow& row : function.rows) {
      text += json_line(describe(report, function, row)) + "\n";
    }
    if (const auto fastest = find_fastest_rejected(function)) {
      text += json_line(describe_choice(report, function, *fastest)) + "\n";
    }
    for (const BenchRow& row : function.disagreeing) {
      text += json_line(describe_disagreement(report, function, row)) + "\n";
    }
  }
  return text;
}

}  // namespace treeline
