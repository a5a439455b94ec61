// The core headers in one C++17 translation unit that includes nothing hosted, compiled with
// -ffreestanding -fno-exceptions -fno-rtti and instantiated in float. Would catch: a header that
// needs the library, C++20, or a feature that firmware lacks.
#include "core/closed_chain.hpp"
#include "core/command_laws.hpp"
#include "core/contact_solver.hpp"
#include "core/damped_solve.hpp"
#include "core/ldlt.hpp"
#include "core/orientation.hpp"
#include "core/posture_laws.hpp"
#include "core/prioritized_solve.hpp"
#include "core/sin_cos.hpp"
#include "core/singularity.hpp"
#include "core/spline.hpp"
#include "core/task_selection.hpp"

namespace treeline::test {

float use_everything(float x) noexcept;
float use_closed_chain(float x) noexcept;
float use_contact_solver(float x) noexcept;
float use_damped_solve(float x) noexcept;
float use_posture_laws(float x) noexcept;
float use_singularity(float x) noexcept;

float use_closed_chain(float x) noexcept {
  const float points[2][3] = {{x, 0.0F, 0.0F}, {0.0F, x, 0.0F}};
  core::TwoGrasps<float> linkage;
  if (!core::make_two_grasps(points[0], points[1], linkage)) {
    return 0.0F;
  }
  const core::GraspedObject<float> object{x, {x, 0.0F, 0.0F}, {x, 0, 0, 0, x, 0, 0, 0, x}};
  const float R[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const float w[3] = {x, x, x};
  const float xdd[6] = {};
  float wrench[6];
  core::object_wrench(object, R, w, xdd, w, wrench);
  float forces[2][6];
  float internal[6] = {};
  core::split_over_grasps(linkage, wrench, internal, forces);
  core::read_internal_forces(linkage, forces, internal);
  float Lambda[1][36];
  core::object_inertia(object, R, Lambda[0]);
  const float free_motion[1][6] = {{x}};
  float moved[6];
  float force[1][6];
  core::grasp_forces<1>(Lambda[0], wrench, Lambda, free_motion, moved, force);
  return internal[0] + force[0][0];
}

float use_contact_solver(float x) noexcept {
  const float A[9] = {1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, x};
  core::ContactLaw<float> law;
  law.friction = x;
  float v[3] = {0.0F, x, -1.0F};
  float y[3] = {};
  float wanted[1];
  core::solve_contacts<float>(1, A, &law, v, y, wanted, {10, 1e-6F});
  return y[2];
}

float use_damped_solve(float x) noexcept {
  const float Lambda_inv[4] = {x, 0.0F, 0.0F, 1.0F};
  const float J[6] = {x, 1.0F, 2.0F, 3.0F, x, 1.0F};
  const float rows[2] = {x, x};
  const float qdd_0[3] = {};
  float tau[3] = {};
  return core::add_damped_task_torque(Lambda_inv, J, rows, qdd_0, rows, rows, tau) + tau[0];
}

float use_posture_laws(float x) noexcept {
  const float q[3] = {x, 2.0F * x, 3.0F * x};
  const float support[6] = {0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F};
  const float com[2] = {x, x};
  const float J_com[6] = {x, 1.0F, 2.0F, 3.0F, x, 1.0F};
  float goal[2];
  float qdd[3] = {};
  core::nearest_in_polygon(support, com, goal);
  core::add_balance({100.0F, 20.0F}, goal, com, J_com, 0.01F, q, qdd);
  core::add_damping(1.0F, q, qdd);
  core::add_limit_avoidance(q, q, 0.1F, 10.0F, 1.0F, q, q, qdd);
  core::add_potential_by_differences([](const float(&at)[3]) noexcept { return at[0] * at[1]; },
                                     0.01F, q, qdd);
  const core::TaskSelection<float> selection;
  const float Lambda_inv[36] = {1.0F};
  const float motion[6] = {x};
  float command[6];
  core::motion_force_command(selection, Lambda_inv, motion, motion, motion, 1.0F, command);
  return qdd[0] + command[0];
}

float use_singularity(float x) noexcept {
  const float J[6] = {1.0F, x, 0.0F, 0.0F, 1.0F, x};
  const float scales[2] = {0.4F, 1.0F};
  const float Lambda_inv[4] = {2.0F, 0.1F, 0.1F, 2.0F};
  const float reference[3] = {0.0F, 0.0F, 1.0F};
  float n[3];
  float F[2];
  const auto found = core::singular_directions<2, 3>(J, core::SingularRegion<float>{});
  core::lost_motion(found, 1, reference, n);
  const auto lost = core::lost_direction(found, 1, J, J, n);
  core::regular_task_force(found, scales, Lambda_inv, scales, F);
  const core::NullMotionGains<float> gains;
  return F[0] + core::drive_along(gains, lost, x, 1.0F, x) +
         core::turn_away(gains, found.directions + 2, lost, scales, x, x);
}

float use_everything(float x) noexcept {
  float sine[3];
  float cosine[3];
  const float angles[3] = {x, 2.0F * x, 3.0F * x};
  core::sin_cos(angles, sine, cosine);
  float A[4] = {2.0F, 0.0F, sine[0], 2.0F};
  float b[2] = {cosine[0], cosine[1]};
  const bool positive = core::ldlt_factor<2>(A);
  core::ldlt_solve(A, b);
  const auto segment = core::rest_to_rest(angles, sine, 1.0F);
  float R[9];
  float R_wanted[9];
  core::rotation_from_vector(angles, R);
  core::rotation_from_vector(segment.at(x).position, R_wanted);
  float error[6];
  core::pose_error(angles, R, sine, R_wanted, error);
  float acceleration[6];
  const core::Gains<float> gains{100.0F, 20.0F};
  core::saturated_goal_law(gains, error, error, 1.0F, 1.0F, acceleration);
  float tracked[6];
  core::tracking_law(gains, error, acceleration, error, error, tracked);
  return b[0] + tracked[3] + (positive ? 1.0F : 0.0F);
}

}  // namespace treeline::test
