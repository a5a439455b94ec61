#include "inspect/print_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "description/noise.hpp"
#include "mechanism/build_mechanism.hpp"
#include "recursion/parameters/base_parameters.hpp"
#include "text/align_columns.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string effect(const LinkReport& link) {
  if (link.felt) return "the motion feels it";
  return link.nearest ? "hidden: possible bodies move the same" : "";
}

std::string print_unphysical(const Report& report) {
  Rows rows;
  bool felt = false;
  for (const LinkReport& link : report.links) {
    if (!link.unphysical) continue;
    rows.push_back({link.name, effect(link)});
    rows.push_back({"  " + *link.unphysical, ""});
    felt = felt || link.felt;
  }
  if (rows.empty()) return {};
  std::string text =
      "\ninertias that are not physical\n" + align_columns({{"link"}, {""}}, rows, page_columns());
  if (felt) {
    text +=
        "  The nearest possible inertia of those that the motion feels keeps mass and centre of\n"
        "  mass and changes the second moments of mass by the least Frobenius norm. A patch of "
        "the\n"
        "  URDF follows below; `--repair FILE` writes the URDF with it.\n";
  }
  return text;
}

std::string print_flat(const Report& report) {
  Rows rows;
  for (const LinkReport& link : report.links) {
    if (link.flat) rows.push_back({link.name, *link.flat});
  }
  if (rows.empty()) return {};
  return "\nbodies without extent in some direction (possible, no fault)\n" +
         align_columns({{"link"}, {"all mass is in"}}, rows, page_columns());
}

}  // namespace

std::string print_inertias(const Report& report) {
  return print_unphysical(report) + print_flat(report);
}

namespace {

/// Limit for suggestions: rounding errors of programs that computed with a few digits less.
constexpr double kCoarse = 1e-12;

std::string print_line(const NoiseDecision& decision) {
  const std::string place =
      decision.line > 0 ? fmt::format("line {}", decision.line) : std::string("-");
  return fmt::format("  {:<10} {:<10.1e} {}: {}\n", place, decision.change, decision.element,
                     decision.text);
}

/// Says what a wider limit would change, if it would change more.
std::string print_suggestion(const Robot& robot, const Scene& scene, std::size_t taken) {
  if (scene.noise >= kCoarse) return "";
  Scene wide = scene;
  wide.noise = kCoarse;
  NoiseDecisions decisions;
  const NoiseLimits limits = noise_limits(robot, wide);
  without_noise(robot, limits, &decisions);
  without_noise(scene, limits, &decisions);
  if (decisions.size() <= taken) return "";
  return fmt::format(
      "Used as written, though within {:.0e} of an exact number: {}. `noise: {:.0e}` in the scene\n"
      "takes them as exact too, which saves operations.\n",
      kCoarse, decisions.size() - taken, kCoarse);
}

}  // namespace

std::string print_noise(const Robot& robot, const Scene& scene) {
  const NoiseLimits limits = noise_limits(robot, scene);
  NoiseDecisions of_numbers;
  without_noise(robot, limits, &of_numbers);
  without_noise(scene, limits, &of_numbers);
  const NoiseDecisions decisions = reduced_mechanism(robot, scene).noise;
  std::string text =
      scene.noise == 0
          ? "`noise: keep`: every number is used as written.\n"
          : fmt::format("Taken as exact: {} that differ by at most {:.2g} rad, {:.2g} m.\n",
                        decisions.size(), limits.angle, limits.length);
  if (!decisions.empty()) text += "  where      change     what\n";
  for (const NoiseDecision& decision : decisions) text += print_line(decision);
  return text + print_suggestion(robot, scene, of_numbers.size());
}

namespace {

using Json = nlohmann::ordered_json;

std::string print_without_effect(const BaseParameters& found) {
  if (found.without_effect.empty()) return {};
  std::string names;
  for (const std::size_t k : found.without_effect) {
    names += (names.empty() ? "" : ", ") + name_of(found.parameters[k]);
  }
  return "\n" + wrap_labelled("without effect on any motion: ", names, page_columns()) + "\n";
}

Json to_json(const BaseParameter& base, const BaseParameters& found, const Mechanism& mechanism) {
  const ModelParameter& named = found.parameters[base.parameter];
  Json combination = Json::array();
  const auto add = [&](std::size_t parameter, const Digits50& coefficient) {
    const ModelParameter& part = found.parameters[parameter];
    combination.push_back({{"parameter", name_of(part)},
                           {"unit", unit_of(part)},
                           {"coefficient", static_cast<double>(coefficient)}});
  };
  add(base.parameter, base.combination.at(base.parameter));
  for (const auto& [parameter, coefficient] : base.combination) {
    if (parameter != base.parameter) add(parameter, coefficient);
  }
  return {{"name", name_of(named)},
          {"unit", unit_of(named)},
          {"value", static_cast<double>(value_in_files(base, found, mechanism))},
          {"combination", combination}};
}

}  // namespace

std::string print_base_parameters(const Robot& robot, const Scene& scene) {
  const Mechanism mechanism = build_mechanism(robot, scene);
  const auto found = base_parameters_of(mechanism);
  std::vector<std::vector<std::string>> rows;
  for (const BaseParameter& base : found->base) {
    const auto value = static_cast<double>(value_in_files(base, *found, mechanism));
    rows.push_back({fmt::format("{:.6g}", value), describe(base, *found)});
  }
  return fmt::format(
             "{}: {} base parameters of {}, in the frames of the URDF's links (Gautier & Khalil "
             "1990)\n\n",
             robot.name, found->base.size(), found->parameters.size()) +
         align_columns({{"value", true}, {"combination"}}, rows, page_columns()) +
         print_without_effect(*found);
}

std::string print_base_parameters_json(const Robot& robot, const Scene& scene) {
  const Mechanism mechanism = build_mechanism(robot, scene);
  const auto found = base_parameters_of(mechanism);
  Json base = Json::array(), without_effect = Json::array();
  for (const BaseParameter& each : found->base) base.push_back(to_json(each, *found, mechanism));
  for (const std::size_t k : found->without_effect) {
    without_effect.push_back(name_of(found->parameters[k]));
  }
  return json_text({{"robot", robot.name},
                    {"parameters", found->parameters.size()},
                    {"base_parameters", base},
                    {"without_effect", without_effect}});
}

}  // namespace treeline
