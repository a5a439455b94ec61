#include "front_end/scene_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "inspect/end_names.hpp"

namespace treeline::tests {
namespace {

constexpr const char* kTaskFunctions =
    "functions: [jacobian, inverse_dynamics, mass_matrix, forward_dynamics, lambda, "
    "control_torque]\n";

std::string print_rows(const ScenePoint& point) {
  constexpr std::array kNames{"x", "y", "z", "rx", "ry", "rz"};
  std::string rows;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (point.rows[i]) rows += (rows.empty() ? "" : ", ") + std::string(kNames[i]);
  }
  return rows;
}

std::string print_points(const SceneProposal& proposal) {
  if (proposal.points.empty()) return {};
  std::string text = "operational_points:\n";
  for (std::size_t i = 0; i < proposal.points.size(); ++i) {
    const ScenePoint& point = proposal.points[i];
    text += fmt::format("  - {{name: tip_{}, link: \"{}\", rows: [{}]}}\n", i, point.link,
                        print_rows(point));
  }
  return text;
}

std::string print_with(const char* line, const SceneProposal& proposal) {
  const std::string points = print_points(proposal);
  return points.empty() ? points : points + line + kTaskFunctions;
}

std::string print_all(const SceneProposal& proposal) {
  return print_points(proposal);
}

std::string print_requested(const SceneProposal& /*proposal*/) {
  return "functions: [center_of_mass_jacobian, coriolis_matrix, inverse_dynamics_derivatives, "
         "centroidal_momentum_matrix, centroidal_bias, inverse_dynamics_regressor]\n";
}

std::string print_contacts(const SceneProposal& proposal) {
  if (proposal.points.empty()) return {};
  std::string text = "contacts:\n";
  for (std::size_t i = 0; i < proposal.points.size(); ++i) {
    text += fmt::format("  - {{name: contact_{}, link: \"{}\"}}\n", i, proposal.points[i].link);
  }
  return text +
         "functions: [contact_motion, contact_inverse_inertia, effective_mass, "
         "impulse_response]\n";
}

/// Feet by their names; where there are none, whatever ends.
std::vector<std::string> find_feet(const SceneProposal& proposal) {
  std::vector<std::string> feet, ends;
  for (const ScenePoint& point : proposal.points) {
    ends.push_back(point.link);
    if (end_name(point.link).kind == EndKind::foot) feet.push_back(point.link);
  }
  return feet.empty() ? ends : feet;
}

std::string print_feet(const SceneProposal& proposal) {
  const std::vector<std::string> feet = find_feet(proposal);
  if (feet.empty()) return {};
  const bool two = feet.size() <= 2;
  std::string text = "constraints:\n";
  for (std::size_t i = 0; i < feet.size(); ++i) {
    text += fmt::format("  - {{name: foot_{}, between: [\"{}\", world], contact: {}}}\n", i,
                        feet[i], two ? "rigid" : "point");
  }
  return text + "functions: [constrained_forward_dynamics, constraint_jacobian]\n";
}

std::string print_object(const SceneProposal& proposal) {
  if (proposal.points.size() < 2) return {};
  std::string text = "operational_points:\n";
  for (int i = 0; i < 2; ++i) {
    text += fmt::format("  - {{name: hand_{}, link: \"{}\"}}\n", i,
                        proposal.points[static_cast<std::size_t>(i)].link);
  }
  return text +
         "objects:\n  - name: box\n    mass: 2\n"
         "    inertia: {ixx: 0.02, iyy: 0.03, izz: 0.04}\n    grasps:\n"
         "      - {point: hand_0, origin: {xyz: [0.1, 0.1, 0]}}\n"
         "      - {point: hand_1, origin: {xyz: [0.1, -0.1, 0]}}\n"
         "functions: [object_state, object_control_torque, object_forward_dynamics]\n";
}

constexpr SceneKind kKinds[] = {
    {"points", print_all},
    {"requested", print_requested},
    {"contacts", print_contacts},
    {"feet", print_feet},
    {"object", print_object},
    {"batch", [](const SceneProposal& of) { return print_with("batch: 4\n", of); }},
    {"c", [](const SceneProposal& of) { return print_with("language: c\n", of); }},
    {"float", [](const SceneProposal& of) { return print_with("real: float\n", of); }},
    {"size", [](const SceneProposal& of) { return print_with("optimize: size\n", of); }},
};

}  // namespace

std::span<const SceneKind> scene_kinds() {
  return kKinds;
}

}  // namespace treeline::tests
