#pragma once

#include <array>

#include "ur10e.hpp"

/// Torques for the UR10e's flange by three laws that differ only near singularities.
namespace treeline::ur10e_experiments {

enum class Law {
  exact,          ///< table 6.1 as it stands, `singular: exact`
  least_squares,  ///< damped least squares (Nakamura & Hanafusa 1986)
  damped,         ///< the generated damped_control_torque
};
inline constexpr std::array kLaws{Law::exact, Law::least_squares, Law::damped};
const char* name_of(Law law);

/// Torque for commanded accelerations of the tool (world axes). Every law damps the motion outside
/// the task at the same rate. Returns the smallest eigenvalue of `core::damped_solve`, whatever the
/// law.
double control(Law law, const double (&q)[6], const double (&qd)[6], const double (&xdd_cmd)[6],
               double (&tau)[6]);

}  // namespace treeline::ur10e_experiments
