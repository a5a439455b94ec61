#include "recursion/tree/declare_inputs.hpp"

#include <algorithm>
#include <string>

#include "recursion/parameters/base_parameters.hpp"

namespace treeline {
namespace {

int internal_force_entries(const Mechanism& mechanism) {
  int entries = 0;
  for (const MechanismObject& object : mechanism.objects) {
    entries += 6 * (static_cast<int>(object.grasps.size()) - 1);
  }
  return entries;
}

int count_orientations(const MechanismInputs& inputs) {
  return static_cast<int>(
      std::count_if(inputs.tools.begin(), inputs.tools.end(),
                    [](const MechanismTool& tool) { return tool.orientation; }));
}

/// Units of rotation and of translation, as rows of joint quantities name them.
struct JointUnits {
  std::string angular, linear;
};

JointUnits joint_units(const QuantityInfo& row) {
  const std::string both = row.unit;
  const std::size_t comma = both.find(", ");
  if (comma == std::string::npos) return {both, both};
  return {both.substr(0, comma), both.substr(comma + 2)};
}

/// "joint velocities, rad/s"; some meanings tell their units themselves.
std::string describe_input(const QuantityInfo& row, const Mechanism& mechanism) {
  const std::string meaning = row.meaning, unit = unit_of(row.quantity, mechanism);
  const bool told = meaning.find(", " + joint_units(row).angular) != std::string::npos;
  return unit == "1" || told ? meaning : meaning + ", " + unit;
}

}  // namespace

std::string unit_of(Quantity quantity, const Mechanism& mechanism) {
  const QuantityInfo& row = info_of(quantity);
  const bool of_joints = row.space == IndexSpace::positions || row.space == IndexSpace::velocities;
  if (!of_joints) return row.unit;
  const auto& coordinates = mechanism.coordinates;
  // A quaternion has no unit, its velocity is one of rotation.
  const bool turns = std::any_of(coordinates.begin(), coordinates.end(), [&](const Coordinate& c) {
    return c.is_angle() || (c.is_of_quaternion() && row.space == IndexSpace::velocities);
  });
  const bool slides = std::any_of(coordinates.begin(), coordinates.end(), [](const Coordinate& c) {
    return c.kind == CoordinateKind::displacement;
  });
  const JointUnits units = joint_units(row);
  return turns == slides ? row.unit : turns ? units.angular : units.linear;
}

int size_of(IndexSpace space, const Mechanism& mechanism) {
  switch (space) {
    case IndexSpace::positions:
      return mechanism.nq();
    case IndexSpace::velocities:
      return mechanism.nv();
    case IndexSpace::task_rows:
      return mechanism.task_rows();
    case IndexSpace::external_forces:
      return 6 * static_cast<int>(mechanism.external_forces.size());
    case IndexSpace::contacts:
      return 3 * static_cast<int>(mechanism.contacts.size());
    case IndexSpace::objects:
      return 6 * static_cast<int>(mechanism.objects.size());
    case IndexSpace::linkages:
      return internal_force_entries(mechanism);
    case IndexSpace::held_rows:
      return mechanism.held_rows();
    case IndexSpace::anchored_rows:
      return mechanism.anchored_rows();
    case IndexSpace::grasp_gains:
      return 2;
    case IndexSpace::step:
      return mechanism.implicit_friction ? 1 : 0;
    case IndexSpace::gravity:
      return mechanism.inputs.gravity ? 3 : 0;
    case IndexSpace::payloads:
      return kInertialParameters * static_cast<int>(mechanism.inputs.payloads.size());
    case IndexSpace::parameters:
      return kInertialParameters * static_cast<int>(mechanism.inputs.parameters.size());
    case IndexSpace::base_parameters:
      return mechanism.inputs.base.empty()
                 ? 0
                 : static_cast<int>(base_parameters_of(mechanism)->base.size());
    case IndexSpace::tools:
      return 3 * static_cast<int>(mechanism.inputs.tools.size());
    case IndexSpace::orientations:
      return 4 * count_orientations(mechanism.inputs);
    case IndexSpace::active_groups:
      return static_cast<int>(mechanism.inputs.active.size());
    case IndexSpace::active_tasks:
      return static_cast<int>(mechanism.inputs.active_tasks.size());
    case IndexSpace::contact_places:
      break;
  }
  return 3 * static_cast<int>(mechanism.inputs.contacts.size());
}

TracedInputs::TracedInputs(const Mechanism& mechanism, Function function, Program& program) {
  for (const Quantity quantity : info_of(function).inputs) {
    const QuantityInfo& row = info_of(quantity);
    const int size = size_of(row.space, mechanism);
    if (size == 0) continue;
    program.arguments.push_back({row.symbol, size, 1, describe_input(row, mechanism)});
    std::vector<Expression>& entries = entries_[static_cast<std::size_t>(quantity)];
    for (int i = 0; i < size; ++i) {
      entries.push_back(
          program.graph.input(std::string(row.symbol) + "[" + std::to_string(i) + "]"));
    }
  }
}

void apply_inputs(const Mechanism& mechanism, const TracedInputs& inputs, Tree<Expression>& tree) {
  ModelInputs<Expression> model;
  if (const auto& gravity = inputs[Quantity::gravity]; !gravity.empty()) {
    model.gravity = triple_at(gravity, 0);
  }
  model.payloads = inertial_parameters(inputs[Quantity::payload]);
  model.parameters = inertial_parameters(inputs[Quantity::parameters]);
  if (const auto& base = inputs[Quantity::base_parameters]; !base.empty()) {
    realize_base_parameters(*base_parameters_of(mechanism), base, model);
  }
  model.tools = triples(inputs[Quantity::tool]);
  model.orientations = rotations(inputs[Quantity::tool_orientation]);
  model.contacts = triples(inputs[Quantity::contact]);
  model.shares = inputs[Quantity::active_tasks];
  apply_inputs<Expression>(mechanism, model, tree);
}

Tree<Expression> structure_of(const Mechanism& mechanism, Function function, Program& scratch) {
  const TracedInputs inputs(mechanism, function, scratch);
  auto tree = constant_tree<Expression>(mechanism);
  apply_inputs(mechanism, inputs, tree);
  return tree;
}

}  // namespace treeline
