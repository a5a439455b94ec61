#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "interpreter/regressor.hpp"
#include "mechanism/mechanism.hpp"
#include "recursion/parameters/model_parameter.hpp"

namespace treeline {

/// A unit parameter of a link, or of the joint that carries it.
struct UnitOfLink {
  interpreter::UnitParameter::Kind kind = interpreter::UnitParameter::Kind::inertial;
  std::string link;
  int entry = 0;          ///< which of the ten inertial ones
  double slip_speed = 0;  ///< of Coulomb friction
};

UnitOfLink unit_of_link(const ModelParameter& column, const Robot& robot);

/// The columns of regressors, in their order; none if the scene asks for no regressor. `mechanism`,
/// if it is there already, is that of the robot in the scene.
std::vector<UnitOfLink> list_regressor_units(const Robot& robot, const Scene& scene,
                                             const Mechanism* mechanism = nullptr);

}  // namespace treeline
