// The core headers in one translation unit of C++17 with nothing hosted included: compiled with
// -ffreestanding -fno-exceptions -fno-rtti and instantiated in float, or in TREELINE_REAL, by every
// cross compiler. Would catch a header that needs the library, C++20, a feature firmware lacks, or
// a call of memcpy or memset. All arrays are the caller's, so calls would be the headers' own.
#include "core/closed_chain.hpp"
#include "core/command_laws.hpp"
#include "core/contact_solver.hpp"
#include "core/coordinates.hpp"
#include "core/damped_solve.hpp"
#include "core/ldlt.hpp"
#include "core/orientation.hpp"
#include "core/posture_laws.hpp"
#include "core/prioritized_solve.hpp"
#include "core/quadratic_program.hpp"
#include "core/sin_cos.hpp"
#include "core/singularity.hpp"
#include "core/spline.hpp"
#include "core/states.hpp"
#include "core/task_selection.hpp"

#if !defined(TREELINE_REAL)
#define TREELINE_REAL float
#endif

namespace treeline::test {

using Real = TREELINE_REAL;

struct Data {
  Real x;
  Real a2[2];
  Real b2[2];
  Real a3[3];
  Real b3[3];
  Real c3[3];
  Real c5[5];
  Real a4[4];
  Real a6[6];
  Real b6[6];
  Real c6[6];
  Real a9[9];
  Real b9[9];
  Real a36[36];
  Real b36[36];
  Real a64[64];
  Real hands[2][6];
  Real inertias[1][36];
  Real motions[1][6];
  Real rows[6][8];
  core::Lanes<Real, 8> lanes[6];
  core::TwoGrasps<Real> linkage;
  core::GraspedObject<Real> object;
  core::ContactLaw<Real> law;
  core::ContactSolver<Real, 2> contacts;
  core::Gains<Real> gains;
  core::TaskSelection<Real> selection;
  core::ForceGains<Real> force_gains;
  core::SingularRegion<Real> region;
  core::NullMotionGains<Real> null_gains;
  core::QuadraticRows<Real, 3, 2> limits;
  core::QuadraticSolution<Real, 3, 2> minimum;
};

bool use_closed_chain(Data& data) noexcept;
bool use_contact_solver(Data& data) noexcept;
Real use_damped_solve(Data& data) noexcept;
void use_prioritized_solve(Data& data) noexcept;
void use_posture_laws(Data& data) noexcept;
bool use_quadratic_program(Data& data) noexcept;
void use_task_selection(Data& data) noexcept;
Real use_singularity(Data& data) noexcept;
void use_coordinates(Data& data) noexcept;
void use_spline(Data& data) noexcept;
void use_orientation(Data& data) noexcept;
bool use_small_solvers(Data& data) noexcept;
void use_states(Data& data) noexcept;

bool use_closed_chain(Data& data) noexcept {
  const bool apart = core::make_two_grasps(data.a3, data.b3, data.linkage);
  core::object_wrench(data.object, data.a9, data.a3, data.a6, data.b3, data.b6);
  core::split_over_grasps(data.linkage, data.a6, data.b6, data.hands);
  core::read_internal_forces(data.linkage, data.hands, data.a6);
  core::object_inertia(data.object, data.a9, data.inertias[0]);
  return core::grasp_forces<1>(data.a36, data.a6, data.inertias, data.motions, data.b6,
                               data.motions) &&
         apart;
}

bool use_contact_solver(Data& data) noexcept {
  return data.contacts.solve(1, data.a9, &data.law, data.a3, data.b3).converged;
}

Real use_damped_solve(Data& data) noexcept {
  return core::add_damped_task_torque(data.a4, data.a6, data.a2, data.a3, data.b2, data.a2,
                                      data.b3) +
         core::damped_solve(data.a36, data.a6, data.b6);
}

void use_prioritized_solve(Data& data) noexcept {
  core::prioritized_solve<6>(data.a36, data.x, data.a6);
  core::selective_solve(core::bordered_factor<6>(data.a36, data.a6), data.b6);
}

void use_posture_laws(Data& data) noexcept {
  core::nearest_in_polygon(data.a6, data.a2, data.b2);
  core::add_balance(data.gains, data.a2, data.b2, data.a6, data.x, data.a3, data.b3);
  core::add_damping(data.x, data.a3, data.b3);
  core::add_limit_avoidance(data.a3, data.a3, data.x, data.x, data.x, data.a3, data.a3, data.b3);
  core::add_potential(
      [](const Real(&at)[6], Real(&slope)[6]) noexcept {
        for (int i = 0; i < 6; ++i) {
          slope[i] = -at[i];
        }
      },
      data.a6, data.b6);
  core::add_potential_by_differences([](const Real(&at)[6]) noexcept { return at[0] * at[5]; },
                                     data.x, data.a6, data.b6);
}

bool use_quadratic_program(Data& data) noexcept {
  core::solve_quadratic_program(data.a9, data.a3, data.limits, data.minimum);
  core::solve_least_distance(data.a3, data.limits, data.minimum);
  return data.minimum.status == core::QuadraticStatus::solved;
}

void use_task_selection(Data& data) noexcept {
  core::motion_force_command(data.selection, data.a36, data.a6, data.a6, data.b6, data.x, data.c6);
  core::force_law(data.force_gains, data.a6, data.b6, data.x, data.x, data.c6, data.b6);
}

Real use_singularity(Data& data) noexcept {
  core::scale_rows<2, 3>(data.a6, data.a2, data.b6);
  const auto found = core::singular_directions<2, 3>(data.b6, data.region);
  core::lost_motion(found, 1, data.a3, data.b3);
  const auto lost = core::lost_direction(found, 1, data.a6, data.b6, data.b3);
  core::regular_task_force(found, data.a2, data.a4, data.a2, data.b2);
  const bool turns = core::singularity_type(lost) == core::SingularityType::turns;
  return turns ? core::drive_along(data.null_gains, lost, data.x, Real(1), data.x)
               : core::turn_away(data.null_gains, found.directions + 2, lost, data.a2, data.x,
                                 data.x);
}

void use_coordinates(Data& data) noexcept {
  const core::QuaternionJoint ball[] = {{2, false}};
  core::integrate(ball, data.a6, data.c5, data.x, data.b6);
  core::difference(ball, data.b6, data.a6, data.c5);
  core::integrate(data.a3, data.b3, data.x, data.c3);
  core::difference(data.a3, data.b3, data.c3);
}

void use_spline(Data& data) noexcept {
  const auto between = core::hermite_segment(data.a6, data.b6, data.b6, data.a6, data.x);
  const auto there = between.at(data.x);
  const auto segment = core::rest_to_rest(there.velocity, there.acceleration, data.x);
  const auto motion = segment.at(data.x);
  for (int i = 0; i < 6; ++i) {
    data.b6[i] = motion.position[i] + motion.velocity[i] * motion.acceleration[i];
  }
}

void use_orientation(Data& data) noexcept {
  core::rotation_from_vector(data.a3, data.a9);
  core::rotation_from_vector(data.b3, data.b9);
  core::pose_error(data.a3, data.a9, data.b3, data.b9, data.a6);
  core::saturated_goal_law(data.gains, data.a6, data.a6, data.x, data.x, data.b6);
  core::joint_law(data.gains, data.a6, data.a6, data.b6, data.c6);
  core::tracking_law(data.gains, data.a6, data.b6, data.c6, data.c6, data.b6);
}

bool use_small_solvers(Data& data) noexcept {
  core::sin_cos(data.a6, data.b6, data.c6);
  const auto eigen = core::symmetric_eigen<6>(data.a36);
  data.x = eigen.vectors[0] + core::square_root(eigen.values[0]);
  const bool positive = core::ldlt_factor<6>(data.a36);
  core::ldlt_solve(data.a36, data.a6);
  return positive;
}

void use_states(Data& data) noexcept {
  core::Lanes<Real, 8> sine;
  core::Lanes<Real, 8> cosine;
  for (int i = 0; i < 6; ++i) {
    core::load_lanes(data.rows[i], data.lanes[i]);
    core::sin_cos(data.lanes[i], sine, cosine);
    core::store_lanes(sine * cosine - data.lanes[i], data.rows[i]);
  }
}

}  // namespace treeline::test
