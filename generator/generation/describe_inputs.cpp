#include "generation/describe_inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "program/format_literal.hpp"

namespace treeline {
namespace {

std::string entries(std::size_t k, std::size_t size) {
  return fmt::format("{}..{}", size * k, size * k + size - 1);
}

/// The ten parameters of a body, in the order of the arguments.
std::string list_parameters(const Inertia& inertia) {
  const ExactMatrix3 J = rotational_inertia(inertia);
  const std::array<Exact, kInertialParameters> values{
      inertia.mass, inertia.h(0), inertia.h(1), inertia.h(2), J(0, 0),
      J(0, 1),      J(1, 1),      J(0, 2),      J(1, 2),      J(2, 2)};
  std::vector<std::string> listed;
  for (const Exact& value : values) listed.push_back(format_literal(static_cast<double>(value)));
  return fmt::format("{}", fmt::join(listed, ", "));
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
  for (std::size_t k = 0; k < inputs.tools.size(); ++k) {
    const auto& xyz = mechanism.inputs.tools[k].nominal;
    notes.push_back(fmt::format(
        "tool {}: origin of point {}, in the scene {{{}, {}, {}}}", entries(k, 3),
        inputs.tools[k].point, format_literal(static_cast<double>(xyz(0))),
        format_literal(static_cast<double>(xyz(1))), format_literal(static_cast<double>(xyz(2)))));
  }
}

}  // namespace treeline
