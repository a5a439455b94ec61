#ifndef TREELINE_PUMA560_EIGEN_HPP
#define TREELINE_PUMA560_EIGEN_HPP
// puma560: the functions of puma560.hpp for fixed-size Eigen types, without a copy.
// Generated; optional, the only file here that needs Eigen.
#include <Eigen/Core>

#include "puma560.hpp"

namespace puma560::eigen {

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

inline void forward_kinematics(const Vector<6>& q, Vector<3>& position,
    Vector<9>& rotation) noexcept {
  puma560::forward_kinematics(input<6>(q), output<3>(position), output<9>(rotation));
}

inline void jacobian(const Vector<6>& q, Matrix<6, 6>& J) noexcept {
  puma560::jacobian(input<6>(q), output<36>(J));
}

inline void bias_acceleration(const Vector<6>& q, const Vector<6>& qd, Vector<6>& bias) noexcept {
  puma560::bias_acceleration(input<6>(q), input<6>(qd), output<6>(bias));
}

inline void inverse_dynamics(const Vector<6>& q, const Vector<6>& qd, const Vector<6>& qdd,
    Vector<6>& tau) noexcept {
  puma560::inverse_dynamics(input<6>(q), input<6>(qd), input<6>(qdd), output<6>(tau));
}

inline void gravity(const Vector<6>& q, Vector<6>& g) noexcept {
  puma560::gravity(input<6>(q), output<6>(g));
}

inline void nonlinear_effects(const Vector<6>& q, const Vector<6>& qd, Vector<6>& h) noexcept {
  puma560::nonlinear_effects(input<6>(q), input<6>(qd), output<6>(h));
}

inline void mass_matrix(const Vector<6>& q, Matrix<6, 6>& M) noexcept {
  puma560::mass_matrix(input<6>(q), output<36>(M));
}

inline void forward_dynamics(const Vector<6>& q, const Vector<6>& qd, const Vector<6>& tau,
    Vector<6>& qdd) noexcept {
  puma560::forward_dynamics(input<6>(q), input<6>(qd), input<6>(tau), output<6>(qdd));
}

inline void lambda_inverse(const Vector<6>& q, Matrix<6, 6>& Lambda_inv) noexcept {
  puma560::lambda_inverse(input<6>(q), output<36>(Lambda_inv));
}

inline void lambda(const Vector<6>& q, Matrix<6, 6>& Lambda) noexcept {
  puma560::lambda(input<6>(q), output<36>(Lambda));
}

inline void control_torque(const Vector<6>& q, const Vector<6>& qd, const Vector<6>& qdd_0,
    const Vector<6>& xdd_cmd, Vector<6>& tau) noexcept {
  puma560::control_torque(input<6>(q), input<6>(qd), input<6>(qdd_0), input<6>(xdd_cmd),
      output<6>(tau));
}

}  // namespace puma560::eigen

#endif  // TREELINE_PUMA560_EIGEN_HPP
