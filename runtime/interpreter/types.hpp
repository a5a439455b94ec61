#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>
#include <vector>

/// Generic dynamics of any robot with sizes known at run time: the tables of Chang's thesis as they
/// stand, for any `Scalar` that has + - * /, sqrt, sin and cos. Spatial vectors are linear over
/// angular. Units are SI and radians.
namespace treeline::interpreter {

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Vector6 = Eigen::Matrix<Scalar, 6, 1>;
template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;
template <class Scalar>
using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
/// Row-major matrix, as in generated code.
template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// 6 x d matrix, d = 0..6, with one column for each velocity of a joint.
template <class Scalar>
using JointMatrix = Eigen::Matrix<Scalar, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
/// The coordinates of one joint.
template <class Scalar>
using JointVector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1, Eigen::ColMajor, 7, 1>;

/// A function argument from which `Scalar` is not deduced, so that any Eigen vector expression
/// fits.
template <class Scalar>
using VectorArg = const std::type_identity_t<Vector<Scalar>>&;

/// Index of the world among the bodies: the parent of bodies that are not carried by another one.
inline constexpr int kWorld = -1;

/// One value for each body, and one for the world with the index kWorld.
template <class T>
class PerBody {
 public:
  PerBody(int bodies, const T& value) : values_(static_cast<std::size_t>(bodies) + 1, value) {}

  [[nodiscard]] T& operator[](int body) { return values_[static_cast<std::size_t>(body + 1)]; }
  [[nodiscard]] const T& operator[](int body) const {
    return values_[static_cast<std::size_t>(body + 1)];
  }

 private:
  std::vector<T> values_;
};

}  // namespace treeline::interpreter
