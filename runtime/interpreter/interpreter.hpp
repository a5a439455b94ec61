#pragma once

/// All functions of the interpreter. Arguments are a `Model`, the operational points if they
/// matter, then Eigen vectors q (nq), qd, qdd, tau (nv), xdd_cmd (rows), and, if there are any, the
/// external points with f_ext (6 for each). Results are returned by value. See `model.hpp` for the
/// joints' coordinates. For a robot with mimic joints all quantities refer to its independent
/// coordinates. `instances.hpp` has the same functions compiled once for double and 50 digits.

#include "interpreter/augmented_object.hpp"
#include "interpreter/center_of_mass.hpp"
#include "interpreter/centroidal_momentum.hpp"
#include "interpreter/constrained_forward_dynamics.hpp"
#include "interpreter/contacts.hpp"
#include "interpreter/control_torque.hpp"
#include "interpreter/coriolis_matrix.hpp"
#include "interpreter/damped_torque.hpp"
#include "interpreter/derivatives.hpp"
#include "interpreter/explicit_operational_space.hpp"
#include "interpreter/forward_dynamics.hpp"
#include "interpreter/forward_kinematics.hpp"
#include "interpreter/impulse_response.hpp"
#include "interpreter/inverse_dynamics.hpp"
#include "interpreter/jacobian.hpp"
#include "interpreter/kinetic_energy.hpp"
#include "interpreter/lambda_inverse.hpp"
#include "interpreter/link_inverse_inertias.hpp"
#include "interpreter/mass_matrix.hpp"
#include "interpreter/motion_derivatives.hpp"
#include "interpreter/object_control_torque.hpp"
#include "interpreter/object_forward_dynamics.hpp"
#include "interpreter/operational_quantities.hpp"
#include "interpreter/point_accelerations.hpp"
#include "interpreter/potential_energy.hpp"
#include "interpreter/supported_control_torque.hpp"
