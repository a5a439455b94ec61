// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_CALLS_HPP
#define TREELINE_UR10E_CALLS_HPP
// ur10e: other ways to call the functions of ur10e.hpp.
// Generated; optional. With named inputs, so that q and qd cannot be swapped, with std::array, and
// with pointers. Nothing is copied but what a struct of inputs is filled with. They are in a
// namespace of their own so that a function's address is never ambiguous.
#if defined(__has_include)
#if __has_include(<array>)
#include <array>
#define UR10E_HAS_ARRAY
#endif
#endif

#include "ur10e.hpp"

namespace ur10e::calls {

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
  /// joint coordinates, rad
  Real q[6];
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
  ur10e::forward_kinematics(in.q, out.position, out.rotation);
  return out;
}

/// What jacobian takes.
struct JacobianInput {
  /// joint coordinates, rad
  Real q[6];
};

/// What jacobian gives.
struct JacobianOutput {
  /// 6 x 6, Jacobian
  Real J[36];
};

inline JacobianOutput jacobian(const JacobianInput& in) noexcept {
  JacobianOutput out;
  ur10e::jacobian(in.q, out.J);
  return out;
}

/// What bias_acceleration takes.
struct BiasAccelerationInput {
  /// joint coordinates, rad
  Real q[6];
  /// joint velocities, rad/s
  Real qd[6];
};

/// What bias_acceleration gives.
struct BiasAccelerationOutput {
  /// accelerations of the task rows at qdd = 0, m/s^2, rad/s^2
  Real bias[6];
};

inline BiasAccelerationOutput bias_acceleration(const BiasAccelerationInput& in) noexcept {
  BiasAccelerationOutput out;
  ur10e::bias_acceleration(in.q, in.qd, out.bias);
  return out;
}

/// What inverse_dynamics takes.
struct InverseDynamicsInput {
  /// joint coordinates, rad
  Real q[6];
  /// joint velocities, rad/s
  Real qd[6];
  /// joint accelerations, rad/s^2
  Real qdd[6];
};

/// What inverse_dynamics gives.
struct InverseDynamicsOutput {
  /// joint forces, N m
  Real tau[6];
};

inline InverseDynamicsOutput inverse_dynamics(const InverseDynamicsInput& in) noexcept {
  InverseDynamicsOutput out;
  ur10e::inverse_dynamics(in.q, in.qd, in.qdd, out.tau);
  return out;
}

/// What gravity takes.
struct GravityInput {
  /// joint coordinates, rad
  Real q[6];
};

/// What gravity gives.
struct GravityOutput {
  /// joint forces, N m
  Real g[6];
};

inline GravityOutput gravity(const GravityInput& in) noexcept {
  GravityOutput out;
  ur10e::gravity(in.q, out.g);
  return out;
}

/// What nonlinear_effects takes.
struct NonlinearEffectsInput {
  /// joint coordinates, rad
  Real q[6];
  /// joint velocities, rad/s
  Real qd[6];
};

/// What nonlinear_effects gives.
struct NonlinearEffectsOutput {
  /// joint forces, N m
  Real h[6];
};

inline NonlinearEffectsOutput nonlinear_effects(const NonlinearEffectsInput& in) noexcept {
  NonlinearEffectsOutput out;
  ur10e::nonlinear_effects(in.q, in.qd, out.h);
  return out;
}

/// What mass_matrix takes.
struct MassMatrixInput {
  /// joint coordinates, rad
  Real q[6];
};

/// What mass_matrix gives.
struct MassMatrixOutput {
  /// 6 x 6, joint-space inertia
  Real M[36];
};

inline MassMatrixOutput mass_matrix(const MassMatrixInput& in) noexcept {
  MassMatrixOutput out;
  ur10e::mass_matrix(in.q, out.M);
  return out;
}

/// What forward_dynamics takes.
struct ForwardDynamicsInput {
  /// joint coordinates, rad
  Real q[6];
  /// joint velocities, rad/s
  Real qd[6];
  /// joint forces, N m
  Real tau[6];
};

/// What forward_dynamics gives.
struct ForwardDynamicsOutput {
  /// joint accelerations, rad/s^2
  Real qdd[6];
};

inline ForwardDynamicsOutput forward_dynamics(const ForwardDynamicsInput& in) noexcept {
  ForwardDynamicsOutput out;
  ur10e::forward_dynamics(in.q, in.qd, in.tau, out.qdd);
  return out;
}

/// What lambda_inverse takes.
struct LambdaInverseInput {
  /// joint coordinates, rad
  Real q[6];
};

/// What lambda_inverse gives.
struct LambdaInverseOutput {
  /// 6 x 6, inverse operational-space inertia
  Real Lambda_inv[36];
};

inline LambdaInverseOutput lambda_inverse(const LambdaInverseInput& in) noexcept {
  LambdaInverseOutput out;
  ur10e::lambda_inverse(in.q, out.Lambda_inv);
  return out;
}

/// What lambda takes.
struct LambdaInput {
  /// joint coordinates, rad
  Real q[6];
};

/// What lambda gives.
struct LambdaOutput {
  /// 6 x 6, operational-space inertia
  Real Lambda[36];
};

inline LambdaOutput lambda(const LambdaInput& in) noexcept {
  LambdaOutput out;
  ur10e::lambda(in.q, out.Lambda);
  return out;
}

/// What control_torque takes.
struct ControlTorqueInput {
  /// joint coordinates, rad
  Real q[6];
  /// joint velocities, rad/s
  Real qd[6];
  /// joint accelerations that the posture asks for, rad/s^2
  Real qdd_0[6];
  /// commanded accelerations of the task rows, m/s^2, rad/s^2
  Real xdd_cmd[6];
};

/// What control_torque gives.
struct ControlTorqueOutput {
  /// joint forces, N m
  Real tau[6];
};

inline ControlTorqueOutput control_torque(const ControlTorqueInput& in) noexcept {
  ControlTorqueOutput out;
  ur10e::control_torque(in.q, in.qd, in.qdd_0, in.xdd_cmd, out.tau);
  return out;
}

#ifdef UR10E_HAS_ARRAY

inline void forward_kinematics(const std::array<Real, 6>& q, std::array<Real, 3>& position,
    std::array<Real, 9>& rotation) noexcept {

  ur10e::forward_kinematics(array_at<6>(q.data()), array_at<3>(position.data()),
      array_at<9>(rotation.data()));

}

inline void jacobian(const std::array<Real, 6>& q, std::array<Real, 36>& J) noexcept {

  ur10e::jacobian(array_at<6>(q.data()), array_at<36>(J.data()));

}

inline void bias_acceleration(const std::array<Real, 6>& q, const std::array<Real, 6>& qd,
    std::array<Real, 6>& bias) noexcept {

  ur10e::bias_acceleration(array_at<6>(q.data()), array_at<6>(qd.data()), array_at<6>(bias.data()));

}

inline void inverse_dynamics(const std::array<Real, 6>& q, const std::array<Real, 6>& qd,
    const std::array<Real, 6>& qdd, std::array<Real, 6>& tau) noexcept {

  ur10e::inverse_dynamics(array_at<6>(q.data()), array_at<6>(qd.data()), array_at<6>(qdd.data()),
      array_at<6>(tau.data()));

}

inline void gravity(const std::array<Real, 6>& q, std::array<Real, 6>& g) noexcept {

  ur10e::gravity(array_at<6>(q.data()), array_at<6>(g.data()));

}

inline void nonlinear_effects(const std::array<Real, 6>& q, const std::array<Real, 6>& qd,
    std::array<Real, 6>& h) noexcept {

  ur10e::nonlinear_effects(array_at<6>(q.data()), array_at<6>(qd.data()), array_at<6>(h.data()));

}

inline void mass_matrix(const std::array<Real, 6>& q, std::array<Real, 36>& M) noexcept {

  ur10e::mass_matrix(array_at<6>(q.data()), array_at<36>(M.data()));

}

inline void forward_dynamics(const std::array<Real, 6>& q, const std::array<Real, 6>& qd,
    const std::array<Real, 6>& tau, std::array<Real, 6>& qdd) noexcept {

  ur10e::forward_dynamics(array_at<6>(q.data()), array_at<6>(qd.data()), array_at<6>(tau.data()),
      array_at<6>(qdd.data()));

}

inline void lambda_inverse(const std::array<Real, 6>& q, std::array<Real,
    36>& Lambda_inv) noexcept {

  ur10e::lambda_inverse(array_at<6>(q.data()), array_at<36>(Lambda_inv.data()));

}

inline void lambda(const std::array<Real, 6>& q, std::array<Real, 36>& Lambda) noexcept {

  ur10e::lambda(array_at<6>(q.data()), array_at<36>(Lambda.data()));

}

inline void control_torque(const std::array<Real, 6>& q, const std::array<Real, 6>& qd,
    const std::array<Real, 6>& qdd_0, const std::array<Real, 6>& xdd_cmd, std::array<Real,
    6>& tau) noexcept {

  ur10e::control_torque(array_at<6>(q.data()), array_at<6>(qd.data()), array_at<6>(qdd_0.data()),
      array_at<6>(xdd_cmd.data()), array_at<6>(tau.data()));

}

#undef UR10E_HAS_ARRAY
#endif

}  // namespace ur10e::calls

#endif  // TREELINE_UR10E_CALLS_HPP
