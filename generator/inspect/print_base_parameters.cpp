#include "inspect/print_base_parameters.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "mechanism/build_mechanism.hpp"
#include "recursion/parameters/base_parameters.hpp"
#include "text/align_columns.hpp"
#include "text/json_text.hpp"
#include "text/wrap_words.hpp"

namespace treeline {
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
