#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "check/report.hpp"
#include "core/mode.hpp"
#include "emission/generated_file.hpp"
#include "functions/function.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

/// Returns the number, or null for infinity and NaN, which JSON does not have.
Json finite(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json optional(const std::optional<int>& x) {
  return x ? Json(*x) : Json(nullptr);
}

Json to_json(const ErrorAt& at) {
  return {{"state", at.state},
          {"class", state_class_name(class_of_state(at.state))},
          {"error", finite(at.error)},
          {"bound", finite(at.bound)},
          {"condition", finite(at.condition)},
          {"amplification", finite(at.amplification)}};
}

Json to_json(const Bound& bound) {
  const std::string of = matrix_symbols(bound.solve);
  return {{"floor", Bound::kFloorUlp},
          {"interpreter_factor", Bound::kInterpreterFactor},
          {"interpreter", bound.interpreter},
          {"times_condition_of", of.empty() ? Json(nullptr) : Json(of)}};
}

const char* name_of(RoundingBound::Kind kind) {
  switch (kind) {
    case RoundingBound::Kind::proven:
      return "proven";
    case RoundingBound::Kind::searched:
      return "first order, searched";
    case RoundingBound::Kind::typical:
      return "first order, at 99 of 100 states";
    case RoundingBound::Kind::none:
      break;
  }
  return "none";
}

Json to_json(const std::optional<RoundingReport>& rounding) {
  if (!rounding) return nullptr;
  return {{"kind", name_of(rounding->kind)},
          {"error", rounding->error},
          {"used", rounding->used},
          {"states", rounding->states}};
}

Json to_json(const std::optional<EquationReport>& equation) {
  if (!equation) return nullptr;
  return {{"says", equation->says},
          {"worst", finite(equation->worst)},
          {"allowed", EquationReport::kAllowed},
          {"state", equation->state},
          {"states", equation->states}};
}

Json to_json(const FunctionReport& f) {
  Json json{{"name", f.name},
            {"passed", f.passed()},
            {"method", f.method},
            {"states", f.states},
            {"singular", f.singular},
            {"has_value", !f.has_no_value()},
            {"median", nullptr},
            {"percent_99", nullptr},
            {"worst", nullptr},
            {"nearest_to_bound", nullptr},
            {"interpreter_worst", finite(f.interpreter_worst)},
            {"equation", to_json(f.equation)},
            {"bound", to_json(f.bound)},
            {"rounding", to_json(f.rounding)},
            {"beyond_bound", f.beyond_bound},
            {"out_of_bounds", f.out_of_bounds},
            {"bits_known", f.bits_known},
            {"bits_differ", f.bits_differ},
            {"first_bits_differ", optional(f.first_bits_differ)},
            {"flops", nullptr},
            {"add", nullptr},
            {"mul", nullptr},
            {"div", nullptr},
            {"sin_cos", nullptr},
            {"code_bytes", optional(f.code_bytes)},
            {"stack_bytes", optional(f.stack_bytes)},
            {"compile_seconds", f.compile_seconds},
            {"long", f.is_long},
            {"small", f.is_small}};
  if (f.count) {
    json["flops"] = f.count->flops();
    json["add"] = f.count->add;
    json["mul"] = f.count->mul;
    json["div"] = f.count->div;
    json["sin_cos"] = f.count->sin_cos;
  }
  if (f.has_errors()) {
    json["median"] = finite(f.median);
    json["percent_99"] = finite(f.percent_99);
    json["worst"] = to_json(f.worst);
    json["nearest_to_bound"] = to_json(f.nearest);
  }
  return json;
}

Json to_json(const State& state) {
  Json others = Json::object();
  for (const auto& [quantity, entries] : state.others) others[symbol_of(quantity)] = entries;
  return {{"index", state.index},
          {"class", state_class_name(state.kind)},
          {"q", state.q},
          {"qd", state.qd},
          {"qdd", state.qdd},
          {"tau", state.tau},
          {"xdd_cmd", state.xdd_cmd},
          {"f_ext", state.f_ext},
          {"others", others}};
}

Json to_json(const FileDifference& file) {
  constexpr std::array kNames = {"missing", "changed", "left over"};
  return {{"file", file.name}, {"difference", kNames[static_cast<std::size_t>(file.difference)]}};
}

template <class T>
Json list(const std::vector<T>& items) {
  Json json = Json::array();
  for (const T& item : items) json.push_back(to_json(item));
  return json;
}

Json to_json(const LimitsReport& limits) {
  const bool any = limits.certified > 0;
  return {{"passed", limits.passed()},
          {"states", limits.states},
          {"singular", limits.singular},
          {"limited", limits.limited},
          {"certified", limits.certified},
          {"irregular", limits.irregular},
          {"uncertain", limits.uncertain},
          {"unsolved", limits.unsolved},
          {"beyond_limits", limits.beyond_limits},
          {"changed", limits.changed},
          {"out_of_bounds", limits.out_of_bounds},
          {"other_limits", limits.corrected},
          {"median", any ? finite(limits.median) : Json(nullptr)},
          {"worst", any ? finite(limits.worst) : Json(nullptr)},
          {"worst_of", any ? Json(limits.worst_of) : Json(nullptr)},
          {"worst_state", any ? Json(limits.worst_state) : Json(nullptr)},
          {"worst_sensitivity", any ? finite(limits.worst_sensitivity) : Json(nullptr)},
          {"of_bound", finite(limits.of_bound)},
          {"code_bytes", optional(limits.compiled.code_bytes)},
          {"stack_bytes", optional(limits.compiled.stack_bytes)},
          {"compile_seconds", limits.compiled.seconds}};
}

Json to_json(const StepReport& step) {
  Json modes = Json::object();
  for (std::size_t i = 0; i < step.modes.size(); ++i) {
    modes[core::mode_name(static_cast<core::Mode>(i))] = step.modes[i];
  }
  return {{"name", step.name},
          {"passed", step.passed()},
          {"motions", step.motions},
          {"steps", step.steps},
          {"modes", modes},
          {"faults", step.faults},
          {"refused", step.refused},
          {"compared", step.compared},
          {"ties", step.ties},
          {"differ", step.differ},
          {"first_difference", step.first_difference},
          {"median", finite(step.median)},
          {"percent_99", finite(step.percent_99)},
          {"worst", finite(step.worst)},
          {"of_bound", finite(step.of_bound)},
          {"nearest_to_bound", step.worst_place},
          {"beyond_bound", step.beyond_bound},
          {"broken_rules", step.broken},
          {"first_broken_rule", step.first_broken},
          {"code_bytes", optional(step.code_bytes)},
          {"stack_bytes", optional(step.stack_bytes)},
          {"compile_seconds", step.compile_seconds}};
}

Json list_functions(const CheckReport& report) {
  Json json = Json::array();
  for (const FunctionReport& f : report.functions) {
    json.push_back(to_json(f));
    json.back()["digits_left"] =
        f.has_errors() ? Json(digits_left(report, f.worst.error)) : Json(nullptr);
  }
  return json;
}

}  // namespace

std::string print_json(const CheckReport& report) {
  const Json json{
      {"name", report.name},
      {"robot", report.robot},
      {"generator", generator_version()},
      {"digest", report.digest},
      {"passed", report.passed()},
      {"real", report.single_precision ? "float" : "double"},
      {"states", report.states},
      {"first_state", report.first_state},
      {"seed", report.seed},
      {"compile",
       {{"command", report.compile_command},
        {"exact_command", report.exact_command},
        {"long_command", report.long_command.empty() ? Json(nullptr) : Json(report.long_command)},
        {"small_command",
         report.small_command.empty() ? Json(nullptr) : Json(report.small_command)},
        {"seconds", report.compile_seconds},
        {"peak_kib", report.compile_peak_kib}}},
      {"reference_seconds", report.reference_seconds},
      {"folder", report.folder.empty() ? Json(nullptr) : Json(report.folder)},
      {"stale", list(report.stale)},
      {"domain", report.domain},
      {"functions", list_functions(report)},
      {"limited_control_torque", report.limits ? to_json(*report.limits) : Json(nullptr)},
      {"batch_limited_control_torque",
       report.batch_limits ? to_json(*report.batch_limits) : Json(nullptr)},
      {"step", report.step ? to_json(*report.step) : Json(nullptr)},
      {"selftest", report.selftest ? Json(*report.selftest) : Json(nullptr)},
      {"named_states", list(report.named_states)}};
  return json_text(json);
}

}  // namespace treeline
