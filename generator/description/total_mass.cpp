#include "description/total_mass.hpp"

namespace treeline {

double total_mass(const Robot& robot) {
  double mass = 0;
  for (const Link& link : robot.links) mass += link.inertial ? link.inertial->mass : 0;
  return mass;
}

}  // namespace treeline
