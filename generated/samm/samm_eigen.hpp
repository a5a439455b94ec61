#ifndef TREELINE_SAMM_EIGEN_HPP
#define TREELINE_SAMM_EIGEN_HPP
// samm: the functions of samm.hpp for fixed-size Eigen types, without a copy.
// Generated; optional, the only file here that needs Eigen.
#include <Eigen/Core>

#include "samm.hpp"

namespace samm::eigen {

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

inline void forward_kinematics(const Vector<9>& q, Vector<3>& position,
    Vector<9>& rotation) noexcept {
  samm::forward_kinematics(input<9>(q), output<3>(position), output<9>(rotation));
}

inline void jacobian(const Vector<9>& q, Matrix<6, 9>& J) noexcept {
  samm::jacobian(input<9>(q), output<54>(J));
}

inline void bias_acceleration(const Vector<9>& q, const Vector<9>& qd, Vector<6>& bias) noexcept {
  samm::bias_acceleration(input<9>(q), input<9>(qd), output<6>(bias));
}

inline void inverse_dynamics(const Vector<9>& q, const Vector<9>& qd, const Vector<9>& qdd,
    Vector<9>& tau) noexcept {
  samm::inverse_dynamics(input<9>(q), input<9>(qd), input<9>(qdd), output<9>(tau));
}

inline void gravity(const Vector<9>& q, Vector<9>& g) noexcept {
  samm::gravity(input<9>(q), output<9>(g));
}

inline void nonlinear_effects(const Vector<9>& q, const Vector<9>& qd, Vector<9>& h) noexcept {
  samm::nonlinear_effects(input<9>(q), input<9>(qd), output<9>(h));
}

inline void mass_matrix(const Vector<9>& q, Matrix<9, 9>& M) noexcept {
  samm::mass_matrix(input<9>(q), output<81>(M));
}

inline void forward_dynamics(const Vector<9>& q, const Vector<9>& qd, const Vector<9>& tau,
    Vector<9>& qdd) noexcept {
  samm::forward_dynamics(input<9>(q), input<9>(qd), input<9>(tau), output<9>(qdd));
}

inline void lambda_inverse(const Vector<9>& q, Matrix<6, 6>& Lambda_inv) noexcept {
  samm::lambda_inverse(input<9>(q), output<36>(Lambda_inv));
}

inline void lambda(const Vector<9>& q, Matrix<6, 6>& Lambda) noexcept {
  samm::lambda(input<9>(q), output<36>(Lambda));
}

inline void control_torque(const Vector<9>& q, const Vector<9>& qd, const Vector<9>& qdd_0,
    const Vector<6>& xdd_cmd, Vector<9>& tau) noexcept {
  samm::control_torque(input<9>(q), input<9>(qd), input<9>(qdd_0), input<6>(xdd_cmd),
      output<9>(tau));
}

}  // namespace samm::eigen

#endif  // TREELINE_SAMM_EIGEN_HPP
