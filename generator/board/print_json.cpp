#include <nlohmann/json.hpp>

#include "board/board_report.hpp"
#include "core/mode.hpp"
#include "emission/generated_file.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json if_known(const std::optional<T>& x) {
  return x ? Json(*x) : Json(nullptr);
}

Json if_any(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json if_counted(std::uint64_t cycles) {
  return cycles == 0 ? Json(nullptr) : Json(cycles);
}

Json describe_modes(const BoardFunction& f) {
  if (f.modes.empty()) return nullptr;
  Json modes = Json::object();
  for (std::size_t i = 0; i < f.modes.size(); ++i) {
    modes[core::mode_name(static_cast<core::Mode>(i))] = {{"steps", f.modes[i].steps},
                                                          {"least_instructions", f.modes[i].least},
                                                          {"most_instructions", f.modes[i].most}};
  }
  return modes;
}

Json describe_function(const BoardFunction& f, bool contracted) {
  return {{"name", f.name},
          {"passed", f.passed(contracted)},
          {"long", f.is_long},
          {"small", f.is_small},
          {"text_bytes", f.text_bytes},
          {"constant_bytes", f.constant_bytes},
          {"variable_bytes", f.static_bytes},
          {"stack_bytes", if_known(f.stack_bytes)},
          {"stack_bytes_seen", f.stack_seen},
          {"library", f.arithmetic},
          {"undefined", f.strays},
          {"least_instructions", f.least},
          {"most_instructions", f.most},
          {"constant_time", f.takes_constant_time()},
          {"cycles_estimate", f.cycles},
          {"least_cycles", if_counted(f.least_cycles)},
          {"most_cycles", if_counted(f.most_cycles)},
          {"modes", describe_modes(f)},
          {"returned", f.returned},
          {"states", f.states},
          {"bits_differ", f.bits_differ},
          {"first_bits_differ", if_known(f.first_bits_differ)},
          {"beyond_bound", contracted ? Json(f.beyond_bound) : Json(nullptr)},
          {"worst_error", contracted ? Json(f.worst) : Json(nullptr)}};
}

Json describe_costs(const CycleCosts& costs) {
  return {{"source", costs.source},
          {"other", costs.other},
          {"memory", costs.memory},
          {"branch", costs.branch},
          {"arithmetic", costs.arithmetic},
          {"fused", costs.fused},
          {"divide_float", costs.divide_float},
          {"divide_double", costs.divide_double}};
}

}  // namespace

std::string print_json(const BoardReport& report) {
  Json functions = Json::array();
  for (const BoardFunction& f : report.functions) {
    functions.push_back(describe_function(f, report.contracted));
  }
  Json stale = Json::array();
  for (const FileDifference& file : report.stale) stale.push_back(file.name);
  const Json json{{"name", report.name},
                  {"robot", report.robot},
                  {"generator", generator_version()},
                  {"digest", report.digest},
                  {"target", report.target->name},
                  {"passed", report.passed()},
                  {"real", report.single_precision ? "float" : "double"},
                  {"contracted", report.contracted},
                  {"states", report.states},
                  {"first_state", report.first_state},
                  {"seed", report.seed},
                  {"compiler", report.compiler},
                  {"command", report.command},
                  {"long_command", if_any(report.long_command)},
                  {"small_command", if_any(report.small_command)},
                  {"simulator", report.runner},
                  {"counts_instructions", report.counts_instructions},
                  {"counts_cycles", report.counts_cycles},
                  {"compile_seconds", report.compile_seconds},
                  {"run_seconds", report.run_seconds},
                  {"cycles", describe_costs(report.target->cycles)},
                  {"folder", report.folder.empty() ? Json(nullptr) : Json(report.folder)},
                  {"stale", stale},
                  {"not_run", report.not_run},
                  {"functions", functions}};
  return json_text(json);
}

}  // namespace treeline
