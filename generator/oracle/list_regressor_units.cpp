#include "oracle/list_regressor_units.hpp"

#include <algorithm>

#include "description/robot_queries.hpp"
#include "mechanism/build_mechanism.hpp"
#include "recursion/parameters/model_parameter.hpp"

namespace treeline {

UnitOfLink unit_of_link(const ModelParameter& column, const Robot& robot) {
  using Kind = interpreter::UnitParameter::Kind;
  if (column.is_of_body()) return {Kind::inertial, column.owner, column.entry};
  const Joint& joint = *find_joint(robot, column.owner);
  UnitOfLink unit{Kind::rotor, robot.links[static_cast<std::size_t>(joint.child)].name};
  if (column.kind == ModelParameter::Kind::viscous) unit.kind = Kind::viscous;
  if (column.kind == ModelParameter::Kind::coulomb) {
    unit.kind = Kind::coulomb;
    unit.slip_speed = column.width();
  }
  return unit;
}

std::vector<UnitOfLink> list_regressor_units(const Robot& robot, const Scene& scene,
                                             const Mechanism* mechanism) {
  std::vector<UnitOfLink> units;
  if (std::none_of(scene.functions.begin(), scene.functions.end(), is_regressor)) return units;
  const auto columns = mechanism != nullptr ? regressor_columns(*mechanism)
                                            : regressor_columns(build_mechanism(robot, scene));
  for (const ModelParameter& column : columns) units.push_back(unit_of_link(column, robot));
  return units;
}

}  // namespace treeline
