// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_HUMANOID24_CALLS_HPP
#define TREELINE_HUMANOID24_CALLS_HPP
// humanoid24: other ways to call the functions of humanoid24.hpp.
// Generated; optional. With named inputs, so that q and qd cannot be swapped, with std::array, and
// with pointers. Nothing is copied but what a struct of inputs is filled with. They are in a
// namespace of their own so that a function's address is never ambiguous.
#if defined(__has_include)
#if __has_include(<array>)
#include <array>
#define HUMANOID24_HAS_ARRAY
#endif
#endif

#include "humanoid24.hpp"

namespace humanoid24::calls {

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
  Real q[24];
};

/// What forward_kinematics gives.
struct ForwardKinematicsOutput {
  /// positions in the world, m, one point after the other
  Real position[6];
  /// rotation matrices, row-major, point's axes to world, one point after the other
  Real rotation[18];
};

inline ForwardKinematicsOutput forward_kinematics(const ForwardKinematicsInput& in) noexcept {
  ForwardKinematicsOutput out;
  humanoid24::forward_kinematics(in.q, out.position, out.rotation);
  return out;
}

/// What jacobian takes.
struct JacobianInput {
  /// joint coordinates, rad
  Real q[24];
};

/// What jacobian gives.
struct JacobianOutput {
  /// 12 x 24, Jacobian
  Real J[288];
};

inline JacobianOutput jacobian(const JacobianInput& in) noexcept {
  JacobianOutput out;
  humanoid24::jacobian(in.q, out.J);
  return out;
}

/// What bias_acceleration takes.
struct BiasAccelerationInput {
  /// joint coordinates, rad
  Real q[24];
  /// joint velocities, rad/s
  Real qd[24];
};

/// What bias_acceleration gives.
struct BiasAccelerationOutput {
  /// accelerations of the task rows at qdd = 0, m/s^2, rad/s^2
  Real bias[12];
};

inline BiasAccelerationOutput bias_acceleration(const BiasAccelerationInput& in) noexcept {
  BiasAccelerationOutput out;
  humanoid24::bias_acceleration(in.q, in.qd, out.bias);
  return out;
}

/// What inverse_dynamics takes.
struct InverseDynamicsInput {
  /// joint coordinates, rad
  Real q[24];
  /// joint velocities, rad/s
  Real qd[24];
  /// joint accelerations, rad/s^2
  Real qdd[24];
};

/// What inverse_dynamics gives.
struct InverseDynamicsOutput {
  /// joint forces, N m
  Real tau[24];
};

inline InverseDynamicsOutput inverse_dynamics(const InverseDynamicsInput& in) noexcept {
  InverseDynamicsOutput out;
  humanoid24::inverse_dynamics(in.q, in.qd, in.qdd, out.tau);
  return out;
}

/// What gravity takes.
struct GravityInput {
  /// joint coordinates, rad
  Real q[24];
};

/// What gravity gives.
struct GravityOutput {
  /// joint forces, N m
  Real g[24];
};

inline GravityOutput gravity(const GravityInput& in) noexcept {
  GravityOutput out;
  humanoid24::gravity(in.q, out.g);
  return out;
}

/// What nonlinear_effects takes.
struct NonlinearEffectsInput {
  /// joint coordinates, rad
  Real q[24];
  /// joint velocities, rad/s
  Real qd[24];
};

/// What nonlinear_effects gives.
struct NonlinearEffectsOutput {
  /// joint forces, N m
  Real h[24];
};

inline NonlinearEffectsOutput nonlinear_effects(const NonlinearEffectsInput& in) noexcept {
  NonlinearEffectsOutput out;
  humanoid24::nonlinear_effects(in.q, in.qd, out.h);
  return out;
}

/// What mass_matrix takes.
struct MassMatrixInput {
  /// joint coordinates, rad
  Real q[24];
};

/// What mass_matrix gives.
struct MassMatrixOutput {
  /// 24 x 24, joint-space inertia
  Real M[576];
};

inline MassMatrixOutput mass_matrix(const MassMatrixInput& in) noexcept {
  MassMatrixOutput out;
  humanoid24::mass_matrix(in.q, out.M);
  return out;
}

/// What forward_dynamics takes.
struct ForwardDynamicsInput {
  /// joint coordinates, rad
  Real q[24];
  /// joint velocities, rad/s
  Real qd[24];
  /// joint forces, N m
  Real tau[24];
};

/// What forward_dynamics gives.
struct ForwardDynamicsOutput {
  /// joint accelerations, rad/s^2
  Real qdd[24];
};

inline ForwardDynamicsOutput forward_dynamics(const ForwardDynamicsInput& in) noexcept {
  ForwardDynamicsOutput out;
  humanoid24::forward_dynamics(in.q, in.qd, in.tau, out.qdd);
  return out;
}

/// What lambda_inverse takes.
struct LambdaInverseInput {
  /// joint coordinates, rad
  Real q[24];
};

/// What lambda_inverse gives.
struct LambdaInverseOutput {
  /// 12 x 12, inverse operational-space inertia
  Real Lambda_inv[144];
};

inline LambdaInverseOutput lambda_inverse(const LambdaInverseInput& in) noexcept {
  LambdaInverseOutput out;
  humanoid24::lambda_inverse(in.q, out.Lambda_inv);
  return out;
}

/// What lambda takes.
struct LambdaInput {
  /// joint coordinates, rad
  Real q[24];
};

/// What lambda gives.
struct LambdaOutput {
  /// 12 x 12, operational-space inertia
  Real Lambda[144];
};

inline LambdaOutput lambda(const LambdaInput& in) noexcept {
  LambdaOutput out;
  humanoid24::lambda(in.q, out.Lambda);
  return out;
}

/// What control_torque takes.
struct ControlTorqueInput {
  /// joint coordinates, rad
  Real q[24];
  /// joint velocities, rad/s
  Real qd[24];
  /// joint accelerations that the posture asks for, rad/s^2
  Real qdd_0[24];
  /// commanded accelerations of the task rows, m/s^2, rad/s^2
  Real xdd_cmd[12];
};

/// What control_torque gives.
struct ControlTorqueOutput {
  /// joint forces, N m
  Real tau[24];
};

inline ControlTorqueOutput control_torque(const ControlTorqueInput& in) noexcept {
  ControlTorqueOutput out;
  humanoid24::control_torque(in.q, in.qd, in.qdd_0, in.xdd_cmd, out.tau);
  return out;
}

#ifdef HUMANOID24_HAS_ARRAY

inline void forward_kinematics(const std::array<Real, 24>& q, std::array<Real, 6>& position,
    std::array<Real, 18>& rotation) noexcept {

  humanoid24::forward_kinematics(array_at<24>(q.data()), array_at<6>(position.data()),
      array_at<18>(rotation.data()));

}

inline void jacobian(const std::array<Real, 24>& q, std::array<Real, 288>& J) noexcept {

  humanoid24::jacobian(array_at<24>(q.data()), array_at<288>(J.data()));

}

inline void bias_acceleration(const std::array<Real, 24>& q, const std::array<Real, 24>& qd,
    std::array<Real, 12>& bias) noexcept {

  humanoid24::bias_acceleration(array_at<24>(q.data()), array_at<24>(qd.data()),
      array_at<12>(bias.data()));

}

inline void inverse_dynamics(const std::array<Real, 24>& q, const std::array<Real, 24>& qd,
    const std::array<Real, 24>& qdd, std::array<Real, 24>& tau) noexcept {

  humanoid24::inverse_dynamics(array_at<24>(q.data()), array_at<24>(qd.data()),
      array_at<24>(qdd.data()), array_at<24>(tau.data()));

}

inline void gravity(const std::array<Real, 24>& q, std::array<Real, 24>& g) noexcept {

  humanoid24::gravity(array_at<24>(q.data()), array_at<24>(g.data()));

}

inline void nonlinear_effects(const std::array<Real, 24>& q, const std::array<Real, 24>& qd,
    std::array<Real, 24>& h) noexcept {

  humanoid24::nonlinear_effects(array_at<24>(q.data()), array_at<24>(qd.data()),
      array_at<24>(h.data()));

}

inline void mass_matrix(const std::array<Real, 24>& q, std::array<Real, 576>& M) noexcept {

  humanoid24::mass_matrix(array_at<24>(q.data()), array_at<576>(M.data()));

}

inline void forward_dynamics(const std::array<Real, 24>& q, const std::array<Real, 24>& qd,
    const std::array<Real, 24>& tau, std::array<Real, 24>& qdd) noexcept {

  humanoid24::forward_dynamics(array_at<24>(q.data()), array_at<24>(qd.data()),
      array_at<24>(tau.data()), array_at<24>(qdd.data()));

}

inline void lambda_inverse(const std::array<Real, 24>& q, std::array<Real,
    144>& Lambda_inv) noexcept {

  humanoid24::lambda_inverse(array_at<24>(q.data()), array_at<144>(Lambda_inv.data()));

}

inline void lambda(const std::array<Real, 24>& q, std::array<Real, 144>& Lambda) noexcept {

  humanoid24::lambda(array_at<24>(q.data()), array_at<144>(Lambda.data()));

}

inline void control_torque(const std::array<Real, 24>& q, const std::array<Real, 24>& qd,
    const std::array<Real, 24>& qdd_0, const std::array<Real, 12>& xdd_cmd, std::array<Real,
    24>& tau) noexcept {

  humanoid24::control_torque(array_at<24>(q.data()), array_at<24>(qd.data()),
      array_at<24>(qdd_0.data()), array_at<12>(xdd_cmd.data()), array_at<24>(tau.data()));

}

#undef HUMANOID24_HAS_ARRAY
#endif

}  // namespace humanoid24::calls

#endif  // TREELINE_HUMANOID24_CALLS_HPP
