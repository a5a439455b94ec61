#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "interpreter/regressor.hpp"

namespace treeline {

/// A unit parameter of a link, or of the joint that carries it.
struct UnitOfLink {
  interpreter::UnitParameter::Kind kind = interpreter::UnitParameter::Kind::inertial;
  std::string link;
  int entry = 0;  ///< which of the ten inertial ones
};

/// The columns of regressors, in their order; none if the scene asks for no regressor.
std::vector<UnitOfLink> list_regressor_units(const Robot& robot, const Scene& scene);

}  // namespace treeline
