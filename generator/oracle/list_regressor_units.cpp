#include "oracle/list_regressor_units.hpp"

#include <algorithm>

#include "description/find_joint.hpp"
#include "mechanism/build_mechanism.hpp"
#include "recursion/model_parameter.hpp"

namespace treeline {

std::vector<UnitOfLink> list_regressor_units(const Robot& robot, const Scene& scene) {
  using Kind = interpreter::UnitParameter::Kind;
  std::vector<UnitOfLink> units;
  if (std::none_of(scene.functions.begin(), scene.functions.end(), is_regressor)) return units;
  for (const ModelParameter& column : regressor_columns(build_mechanism(robot, scene))) {
    if (column.kind == ModelParameter::Kind::inertial) {
      units.push_back({Kind::inertial, column.owner, column.entry});
      continue;
    }
    const bool is_rotor = column.kind == ModelParameter::Kind::rotor;
    const Joint& joint = *find_joint(robot, column.owner);
    units.push_back({is_rotor ? Kind::rotor : Kind::viscous,
                     robot.links[static_cast<std::size_t>(joint.child)].name, 0});
  }
  return units;
}

}  // namespace treeline
