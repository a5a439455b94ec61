// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_SAMM_CALLS_HPP
#define TREELINE_SAMM_CALLS_HPP
// samm: other ways to call the functions of samm.hpp.
// Generated; optional. With named inputs, so that q and qd cannot be swapped, with std::array, and
// with pointers. Nothing is copied but what a struct of inputs is filled with. They are in a
// namespace of their own so that a function's address is never ambiguous.
#if defined(__has_include)
#if __has_include(<array>)
#include <array>
#define SAMM_HAS_ARRAY
#endif
#endif

#include "samm.hpp"

namespace samm::calls {

/// The `size` numbers from `first` on as the array that a function takes: for pointers,
/// std::vector::data() and spans. There have to be that many.
template <decltype(sizeof(0)) size>
const Real (&array_at(const Real* first) noexcept)[size] {
  return *reinterpret_cast<const Real(*)[size]>(first);
}
template <decltype(sizeof(0)) size>
Real (&array_at(Real* first) noexcept)[size] {
  return *reinterpret_cast<Real(*)[size]>(first);
}

/// What forward_kinematics takes.
struct ForwardKinematicsInput {
  /// joint coordinates, rad, m
  Real q[9];
};

/// What forward_kinematics gives.
struct ForwardKinematicsOutput {
  /// positions in the world, m, one point after the other
  Real position[3];
  /// rotation matrices, row-major, point's axes to world, one point after the other
  Real rotation[9];
};

inline ForwardKinematicsOutput forward_kinematics(const ForwardKinematicsInput& in) noexcept {
  ForwardKinematicsOutput out;
  samm::forward_kinematics(in.q, out.position, out.rotation);
  return out;
}

/// What jacobian takes.
struct JacobianInput {
  /// joint coordinates, rad, m
  Real q[9];
};

/// What jacobian gives.
struct JacobianOutput {
  /// 6 x 9, Jacobian
  Real J[54];
};

inline JacobianOutput jacobian(const JacobianInput& in) noexcept {
  JacobianOutput out;
  samm::jacobian(in.q, out.J);
  return out;
}

/// What bias_acceleration takes.
struct BiasAccelerationInput {
  /// joint coordinates, rad, m
  Real q[9];
  /// joint velocities, rad/s, m/s
  Real qd[9];
};

/// What bias_acceleration gives.
struct BiasAccelerationOutput {
  /// accelerations of the task rows at qdd = 0, m/s^2, rad/s^2
  Real bias[6];
};

inline BiasAccelerationOutput bias_acceleration(const BiasAccelerationInput& in) noexcept {
  BiasAccelerationOutput out;
  samm::bias_acceleration(in.q, in.qd, out.bias);
  return out;
}

/// What inverse_dynamics takes.
struct InverseDynamicsInput {
  /// joint coordinates, rad, m
  Real q[9];
  /// joint velocities, rad/s, m/s
  Real qd[9];
  /// joint accelerations, rad/s^2, m/s^2
  Real qdd[9];
};

/// What inverse_dynamics gives.
struct InverseDynamicsOutput {
  /// joint forces, N m, N
  Real tau[9];
};

inline InverseDynamicsOutput inverse_dynamics(const InverseDynamicsInput& in) noexcept {
  InverseDynamicsOutput out;
  samm::inverse_dynamics(in.q, in.qd, in.qdd, out.tau);
  return out;
}

/// What gravity takes.
struct GravityInput {
  /// joint coordinates, rad, m
  Real q[9];
};

/// What gravity gives.
struct GravityOutput {
  /// joint forces, N m, N
  Real g[9];
};

inline GravityOutput gravity(const GravityInput& in) noexcept {
  GravityOutput out;
  samm::gravity(in.q, out.g);
  return out;
}

/// What nonlinear_effects takes.
struct NonlinearEffectsInput {
  /// joint coordinates, rad, m
  Real q[9];
  /// joint velocities, rad/s, m/s
  Real qd[9];
};

/// What nonlinear_effects gives.
struct NonlinearEffectsOutput {
  /// joint forces, N m, N
  Real h[9];
};

inline NonlinearEffectsOutput nonlinear_effects(const NonlinearEffectsInput& in) noexcept {
  NonlinearEffectsOutput out;
  samm::nonlinear_effects(in.q, in.qd, out.h);
  return out;
}

/// What mass_matrix takes.
struct MassMatrixInput {
  /// joint coordinates, rad, m
  Real q[9];
};

/// What mass_matrix gives.
struct MassMatrixOutput {
  /// 9 x 9, joint-space inertia
  Real M[81];
};

inline MassMatrixOutput mass_matrix(const MassMatrixInput& in) noexcept {
  MassMatrixOutput out;
  samm::mass_matrix(in.q, out.M);
  return out;
}

/// What forward_dynamics takes.
struct ForwardDynamicsInput {
  /// joint coordinates, rad, m
  Real q[9];
  /// joint velocities, rad/s, m/s
  Real qd[9];
  /// joint forces, N m, N
  Real tau[9];
};

/// What forward_dynamics gives.
struct ForwardDynamicsOutput {
  /// joint accelerations, rad/s^2, m/s^2
  Real qdd[9];
};

inline ForwardDynamicsOutput forward_dynamics(const ForwardDynamicsInput& in) noexcept {
  ForwardDynamicsOutput out;
  samm::forward_dynamics(in.q, in.qd, in.tau, out.qdd);
  return out;
}

/// What lambda_inverse takes.
struct LambdaInverseInput {
  /// joint coordinates, rad, m
  Real q[9];
};

/// What lambda_inverse gives.
struct LambdaInverseOutput {
  /// 6 x 6, inverse operational-space inertia
  Real Lambda_inv[36];
};

inline LambdaInverseOutput lambda_inverse(const LambdaInverseInput& in) noexcept {
  LambdaInverseOutput out;
  samm::lambda_inverse(in.q, out.Lambda_inv);
  return out;
}

/// What lambda takes.
struct LambdaInput {
  /// joint coordinates, rad, m
  Real q[9];
};

/// What lambda gives.
struct LambdaOutput {
  /// 6 x 6, operational-space inertia
  Real Lambda[36];
};

inline LambdaOutput lambda(const LambdaInput& in) noexcept {
  LambdaOutput out;
  samm::lambda(in.q, out.Lambda);
  return out;
}

/// What control_torque takes.
struct ControlTorqueInput {
  /// joint coordinates, rad, m
  Real q[9];
  /// joint velocities, rad/s, m/s
  Real qd[9];
  /// joint accelerations that the posture asks for, rad/s^2, m/s^2
  Real qdd_0[9];
  /// commanded accelerations of the task rows, m/s^2, rad/s^2
  Real xdd_cmd[6];
};

/// What control_torque gives.
struct ControlTorqueOutput {
  /// joint forces, N m, N
  Real tau[9];
};

inline ControlTorqueOutput control_torque(const ControlTorqueInput& in) noexcept {
  ControlTorqueOutput out;
  samm::control_torque(in.q, in.qd, in.qdd_0, in.xdd_cmd, out.tau);
  return out;
}

#ifdef SAMM_HAS_ARRAY

inline void forward_kinematics(const std::array<Real, 9>& q, std::array<Real, 3>& position,
    std::array<Real, 9>& rotation) noexcept {

  samm::forward_kinematics(array_at<9>(q.data()), array_at<3>(position.data()),
      array_at<9>(rotation.data()));

}

inline void jacobian(const std::array<Real, 9>& q, std::array<Real, 54>& J) noexcept {

  samm::jacobian(array_at<9>(q.data()), array_at<54>(J.data()));

}

inline void bias_acceleration(const std::array<Real, 9>& q, const std::array<Real, 9>& qd,
    std::array<Real, 6>& bias) noexcept {

  samm::bias_acceleration(array_at<9>(q.data()), array_at<9>(qd.data()), array_at<6>(bias.data()));

}

inline void inverse_dynamics(const std::array<Real, 9>& q, const std::array<Real, 9>& qd,
    const std::array<Real, 9>& qdd, std::array<Real, 9>& tau) noexcept {

  samm::inverse_dynamics(array_at<9>(q.data()), array_at<9>(qd.data()), array_at<9>(qdd.data()),
      array_at<9>(tau.data()));

}

inline void gravity(const std::array<Real, 9>& q, std::array<Real, 9>& g) noexcept {

  samm::gravity(array_at<9>(q.data()), array_at<9>(g.data()));

}

inline void nonlinear_effects(const std::array<Real, 9>& q, const std::array<Real, 9>& qd,
    std::array<Real, 9>& h) noexcept {

  samm::nonlinear_effects(array_at<9>(q.data()), array_at<9>(qd.data()), array_at<9>(h.data()));

}

inline void mass_matrix(const std::array<Real, 9>& q, std::array<Real, 81>& M) noexcept {

  samm::mass_matrix(array_at<9>(q.data()), array_at<81>(M.data()));

}

inline void forward_dynamics(const std::array<Real, 9>& q, const std::array<Real, 9>& qd,
    const std::array<Real, 9>& tau, std::array<Real, 9>& qdd) noexcept {

  samm::forward_dynamics(array_at<9>(q.data()), array_at<9>(qd.data()), array_at<9>(tau.data()),
      array_at<9>(qdd.data()));

}

inline void lambda_inverse(const std::array<Real, 9>& q, std::array<Real,
    36>& Lambda_inv) noexcept {

  samm::lambda_inverse(array_at<9>(q.data()), array_at<36>(Lambda_inv.data()));

}

inline void lambda(const std::array<Real, 9>& q, std::array<Real, 36>& Lambda) noexcept {

  samm::lambda(array_at<9>(q.data()), array_at<36>(Lambda.data()));

}

inline void control_torque(const std::array<Real, 9>& q, const std::array<Real, 9>& qd,
    const std::array<Real, 9>& qdd_0, const std::array<Real, 6>& xdd_cmd, std::array<Real,
    9>& tau) noexcept {

  samm::control_torque(array_at<9>(q.data()), array_at<9>(qd.data()), array_at<9>(qdd_0.data()),
      array_at<6>(xdd_cmd.data()), array_at<9>(tau.data()));

}

#undef SAMM_HAS_ARRAY
#endif

}  // namespace samm::calls

#endif  // TREELINE_SAMM_CALLS_HPP
