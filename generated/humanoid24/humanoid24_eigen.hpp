#ifndef TREELINE_HUMANOID24_EIGEN_HPP
#define TREELINE_HUMANOID24_EIGEN_HPP
// humanoid24: the functions of humanoid24.hpp for fixed-size Eigen types, without a copy.
// Generated; optional, the only file here that needs Eigen.
#include <Eigen/Core>

#include "humanoid24.hpp"

namespace humanoid24::eigen {

template <int rows>
using Vector = Eigen::Matrix<Real, rows, 1>;
template <int rows, int cols>
using Matrix = Eigen::Matrix<Real, rows, cols, Eigen::RowMajor>;

/// The elements of a fixed-size Eigen object as the array that the functions take.
template <int size, class Object>
const Real (&input(const Object& object))[size] {
  return *reinterpret_cast<const Real(*)[size]>(object.data());
}
template <int size, class Object>
Real (&output(Object& object))[size] {
  return *reinterpret_cast<Real(*)[size]>(object.data());
}

inline void forward_kinematics(const Vector<24>& q, Vector<6>& position,
    Vector<18>& rotation) noexcept {
  humanoid24::forward_kinematics(input<24>(q), output<6>(position), output<18>(rotation));
}

inline void jacobian(const Vector<24>& q, Matrix<12, 24>& J) noexcept {
  humanoid24::jacobian(input<24>(q), output<288>(J));
}

inline void bias_acceleration(const Vector<24>& q, const Vector<24>& qd,
    Vector<12>& bias) noexcept {
  humanoid24::bias_acceleration(input<24>(q), input<24>(qd), output<12>(bias));
}

inline void inverse_dynamics(const Vector<24>& q, const Vector<24>& qd, const Vector<24>& qdd,
    Vector<24>& tau) noexcept {
  humanoid24::inverse_dynamics(input<24>(q), input<24>(qd), input<24>(qdd), output<24>(tau));
}

inline void gravity(const Vector<24>& q, Vector<24>& g) noexcept {
  humanoid24::gravity(input<24>(q), output<24>(g));
}

inline void nonlinear_effects(const Vector<24>& q, const Vector<24>& qd, Vector<24>& h) noexcept {
  humanoid24::nonlinear_effects(input<24>(q), input<24>(qd), output<24>(h));
}

inline void mass_matrix(const Vector<24>& q, Matrix<24, 24>& M) noexcept {
  humanoid24::mass_matrix(input<24>(q), output<576>(M));
}

inline void forward_dynamics(const Vector<24>& q, const Vector<24>& qd, const Vector<24>& tau,
    Vector<24>& qdd) noexcept {
  humanoid24::forward_dynamics(input<24>(q), input<24>(qd), input<24>(tau), output<24>(qdd));
}

inline void lambda_inverse(const Vector<24>& q, Matrix<12, 12>& Lambda_inv) noexcept {
  humanoid24::lambda_inverse(input<24>(q), output<144>(Lambda_inv));
}

inline void lambda(const Vector<24>& q, Matrix<12, 12>& Lambda) noexcept {
  humanoid24::lambda(input<24>(q), output<144>(Lambda));
}

inline void control_torque(const Vector<24>& q, const Vector<24>& qd, const Vector<24>& qdd_0,
    const Vector<12>& xdd_cmd, Vector<24>& tau) noexcept {
  humanoid24::control_torque(input<24>(q), input<24>(qd), input<24>(qdd_0), input<12>(xdd_cmd),
      output<24>(tau));
}

}  // namespace humanoid24::eigen

#endif  // TREELINE_HUMANOID24_EIGEN_HPP
