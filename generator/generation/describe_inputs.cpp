#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "description/noise.hpp"
#include "generation/append_notes.hpp"
#include "program/format_literal.hpp"
#include "recursion/parameters/base_parameters.hpp"

namespace treeline {
namespace {

std::string entries(std::size_t k, std::size_t size) {
  return fmt::format("{}..{}", size * k, size * k + size - 1);
}

/// The ten parameters of a body, in the order of the arguments.
std::string list_parameters(const Inertia& inertia) {
  const Digits50Matrix3 J = rotational_inertia(inertia);
  const std::array<Digits50, kInertialParameters> values{
      inertia.mass, inertia.h(0), inertia.h(1), inertia.h(2), J(0, 0),
      J(0, 1),      J(1, 1),      J(0, 2),      J(1, 2),      J(2, 2)};
  std::vector<std::string> listed;
  for (const Digits50& value : values) listed.push_back(format_literal(static_cast<double>(value)));
  return fmt::format("{}", fmt::join(listed, ", "));
}

void append_origins(const char* argument, const char* kind, const std::vector<SceneTool>& named,
                    const std::vector<MechanismTool>& placed, std::vector<std::string>& notes) {
  for (std::size_t k = 0; k < named.size(); ++k) {
    const auto& xyz = placed[k].nominal;
    notes.push_back(fmt::format(
        "{} {}: origin of {} {}, in the scene {{{}, {}, {}}}", argument, entries(k, 3), kind,
        named[k].point, format_literal(static_cast<double>(xyz(0))),
        format_literal(static_cast<double>(xyz(1))), format_literal(static_cast<double>(xyz(2)))));
  }
}

/// x, y, z, w of the rotations by roll, pitch and yaw about fixed axes, in this order.
std::string list_quaternion(const std::array<double, 3>& rpy) {
  std::array<Digits50, 3> s, c;
  for (std::size_t i = 0; i < 3; ++i) {
    s[i] = sin(Digits50(rpy[i]) / 2);
    c[i] = cos(Digits50(rpy[i]) / 2);
  }
  const std::array<Digits50, 4> entries{Digits50(s[0] * c[1] * c[2] - c[0] * s[1] * s[2]),
                                        Digits50(c[0] * s[1] * c[2] + s[0] * c[1] * s[2]),
                                        Digits50(c[0] * c[1] * s[2] - s[0] * s[1] * c[2]),
                                        Digits50(c[0] * c[1] * c[2] + s[0] * s[1] * s[2])};
  std::vector<std::string> listed;
  for (const Digits50& entry : entries) {
    const bool noise = abs(entry) < kResolution;
    listed.push_back(format_literal(noise ? 0.0 : static_cast<double>(entry)));
  }
  return fmt::format("{}", fmt::join(listed, ", "));
}

void append_orientations(const Scene& scene, std::vector<std::string>& notes) {
  std::size_t k = 0;
  for (const SceneTool& tool : scene.inputs.tools) {
    if (!tool.orientation) continue;
    const auto point =
        std::find_if(scene.operational_points.begin(), scene.operational_points.end(),
                     [&](const ScenePoint& each) { return each.name == tool.point; });
    notes.push_back(fmt::format("tool_orientation {}: of point {}, in the scene {{{}}}",
                                entries(k++, 4), tool.point, list_quaternion(point->origin.rpy)));
  }
}

void append_base_parameters(const Mechanism& mechanism, std::vector<std::string>& notes) {
  if (mechanism.inputs.base.empty()) return;
  notes.emplace_back(
      "base_parameters: combinations of m, m c_x, m c_y, m c_z, Ixx, Ixy, Iyy, Ixz, Iyz, Izz of "
      "links, in their frames in the URDF, each with what is fixed to it: kg, kg m, kg m^2");
  const auto found = base_parameters_of(mechanism);
  for (std::size_t k = 0; k < found->base.size(); ++k) {
    const auto value = static_cast<double>(value_in_files(found->base[k], *found, mechanism));
    const ModelParameter& named = found->parameters[found->base[k].parameter];
    std::string text = describe(found->base[k], *found);
    if (named.kind == ModelParameter::Kind::coulomb) {
      text += " of " + sign_of(named);
    }
    notes.push_back(fmt::format("base_parameters {}: {}, {}, in the files {}", k, text,
                                unit_of(named), format_literal(value)));
  }
}

}  // namespace

void append_input_notes(const Scene& scene, const Mechanism& mechanism,
                        std::vector<std::string>& notes) {
  const SceneInputs& inputs = scene.inputs;
  for (std::size_t k = 0; k < inputs.payloads.size(); ++k) {
    notes.push_back(fmt::format("payload {}: added to link {}; all 0 for none",
                                entries(k, kInertialParameters), inputs.payloads[k].link));
  }
  for (std::size_t k = 0; k < inputs.parameters.size(); ++k) {
    notes.push_back(fmt::format("parameters {}: of link {}, in the URDF {{{}}}",
                                entries(k, kInertialParameters), inputs.parameters[k].link,
                                list_parameters(mechanism.inputs.parameters[k].nominal)));
  }
  append_base_parameters(mechanism, notes);
  append_origins("tool", "point", inputs.tools, mechanism.inputs.tools, notes);
  append_orientations(scene, notes);
  append_origins("contact", "contact", inputs.contacts, mechanism.inputs.contacts, notes);
  for (std::size_t k = 0; k < inputs.active.size(); ++k) {
    notes.push_back(fmt::format("active {}: of constraint {}", k, inputs.active[k]));
  }
  for (std::size_t k = 0; k < inputs.active_tasks.size(); ++k) {
    notes.push_back(fmt::format("active_tasks {}: of point {}", k, inputs.active_tasks[k]));
  }
}

}  // namespace treeline
