#include "inspect/print_base_parameters.hpp"

#include <fmt/format.h>

#include <vector>

#include "inspect/align_columns.hpp"
#include "inspect/wrap_words.hpp"
#include "mechanism/build_mechanism.hpp"
#include "recursion/base_parameters.hpp"

namespace treeline {
namespace {

/// What the files say of a parameter; rotors and friction of the scene.
double value_of(const ModelParameter& parameter, const Mechanism& mechanism, const Scene& scene) {
  if (parameter.kind == ModelParameter::Kind::rotor) {
    const auto found = scene.armature.find(parameter.owner);
    return found == scene.armature.end() ? 0 : found->second;
  }
  if (parameter.kind == ModelParameter::Kind::viscous) return 0;
  const Inertia& body = mechanism.link_matter[parameter.frame];
  const ExactMatrix3 J = rotational_inertia(body);
  const Exact values[] = {body.mass, body.h(0), body.h(1), body.h(2), J(0, 0),
                          J(0, 1),   J(1, 1),   J(0, 2),   J(1, 2),   J(2, 2)};
  return static_cast<double>(values[parameter.entry]);
}

double value_of(const BaseParameter& base, const BaseParameters& found, const Mechanism& mechanism,
                const Scene& scene) {
  double value = 0;
  for (const auto& [parameter, coefficient] : base.combination) {
    value +=
        static_cast<double>(coefficient) * value_of(found.parameters[parameter], mechanism, scene);
  }
  return value;
}

std::string print_without_effect(const BaseParameters& found) {
  if (found.without_effect.empty()) return {};
  std::string names;
  for (const std::size_t k : found.without_effect) {
    names += (names.empty() ? "" : ", ") + name_of(found.parameters[k]);
  }
  return "\n" + wrap_labelled("without effect on any motion: ", names, kPageColumns) + "\n";
}

}  // namespace

std::string print_base_parameters(const Robot& robot, const Scene& scene) {
  const Mechanism mechanism = build_mechanism(robot, scene);
  const BaseParameters found = find_base_parameters(mechanism, scene.regressor);
  std::vector<std::vector<std::string>> rows;
  for (const BaseParameter& base : found.base) {
    rows.push_back(
        {fmt::format("{:.6g}", value_of(base, found, mechanism, scene)), describe(base, found)});
  }
  return fmt::format(
             "{}: {} base parameters of {}, in the frames of the URDF's links (Gautier & Khalil "
             "1990)\n\n",
             robot.name, found.base.size(), found.parameters.size()) +
         align_columns({{"value", true}, {"combination"}}, rows, kPageColumns) +
         print_without_effect(found);
}

}  // namespace treeline
