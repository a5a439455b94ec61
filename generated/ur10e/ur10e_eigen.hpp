// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_EIGEN_HPP
#define TREELINE_UR10E_EIGEN_HPP
// ur10e: the functions of ur10e.hpp for Eigen.
// Generated; optional, the only file here that needs Eigen. Takes fixed and dynamic sizes, row- and
// column-major, maps, blocks and expressions.
//
// Nothing is copied where elements lie one after the other, row after row, as in Vector and Matrix
// below, Eigen::VectorXd, or a map of an array. Where they do not, as in a column-major matrix, a
// local copy puts each into its place. An argument of one column also takes a matrix of as many
// elements, row after row. Results of a dynamic size are resized to what they have to be, which
// allocates unless they have it already. Sizes that are known and wrong do not compile; others are
// an eigen_assert.
#include <Eigen/Core>
#include <cstddef>
#include <type_traits>

#include "ur10e.hpp"

namespace ur10e::eigen {

template <int rows>
using Vector = Eigen::Matrix<Real, rows, 1>;
template <int rows, int cols>
using Matrix = Eigen::Matrix<Real, rows, cols, Eigen::RowMajor>;

namespace detail {

/// Whether the elements of an object lie one after the other, row after row.
template <class Object>
constexpr bool lies_in_order() {
  constexpr bool plain = std::is_base_of_v<Eigen::PlainObjectBase<Object>, Object>;
  constexpr int cols = Object::ColsAtCompileTime;
  constexpr bool rows_follow =
      Object::IsRowMajor && (plain || (cols != Eigen::Dynamic &&
                                       int(Object::OuterStrideAtCompileTime) == cols));
  return (int(Object::Flags) & Eigen::DirectAccessBit) != 0 &&
         int(Object::InnerStrideAtCompileTime) == 1 &&
         (Object::IsVectorAtCompileTime || rows_follow);
}

/// Whether an object may be an argument of so many rows and columns, as far as its type tells.
template <class Object, int rows, int cols>
constexpr void check_type() {
  constexpr auto fits = [](int known, int wanted) {
    return known == Eigen::Dynamic || known == wanted;
  };
  static_assert(std::is_same_v<typename Object::Scalar, Real>, "use .cast<ur10e::Real>()");
  static_assert(cols == 1 ? fits(Object::SizeAtCompileTime, rows)
                          : fits(Object::RowsAtCompileTime, rows) &&
                                fits(Object::ColsAtCompileTime, cols),
                "this argument has another size");
}

template <int rows, int cols, class Object>
bool has_size(const Object& object) {
  return cols == 1 ? object.size() == rows : object.rows() == rows && object.cols() == cols;
}

/// Gives an object the size that an argument has, if its type leaves it open.
template <int rows, int cols, class Object>
void resize(Object& object) {
  if (has_size<rows, cols>(object)) return;
  if constexpr (Object::IsVectorAtCompileTime) {
    object.resize(rows * cols);
  } else {
    object.resize(rows, cols);
  }
}

/// What a function takes.
template <int rows, int cols>
using Array = Real[static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols)];

/// The elements of an object as the array that a function takes: its own, or a copy.
template <int rows, int cols, class Object, bool in_order = lies_in_order<Object>()>
class Input {
 public:
  explicit Input(const Object& object) {
    eigen_assert((has_size<rows, cols>(object)));
    if constexpr ((int(Object::Flags) & Eigen::DirectAccessBit) != 0) {
      copy(object);
    } else {
      copy(object.eval());
    }
  }
  const Array<rows, cols>& array() const { return copy_; }

 private:
  template <class Elements>
  void copy(const Elements& elements) {
    for (Eigen::Index i = 0; i < elements.size(); ++i) {
      copy_[i] = elements.coeff(i / elements.cols(), i % elements.cols());
    }
  }

  Array<rows, cols> copy_;
};

template <int rows, int cols, class Object>
class Input<rows, cols, Object, true> {
 public:
  explicit Input(const Object& object) : object_(object) {
    eigen_assert((has_size<rows, cols>(object)));
  }
  const Array<rows, cols>& array() const {
    return *reinterpret_cast<const Array<rows, cols>*>(object_.data());
  }

 private:
  const Object& object_;
};

/// The array that a function writes: the elements of an object, or numbers that go there at the
/// end of the call.
template <int rows, int cols, class Object, bool in_order = lies_in_order<Object>()>
class Output {
 public:
  explicit Output(Object& object) : object_(object) { resize<rows, cols>(object); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() {
    for (Eigen::Index i = 0; i < object_.size(); ++i) {
      object_.coeffRef(i / object_.cols(), i % object_.cols()) = numbers_[i];
    }
  }
  Array<rows, cols>& array() { return numbers_; }

 private:
  Object& object_;
  Array<rows, cols> numbers_;
};

template <int rows, int cols, class Object>
class Output<rows, cols, Object, true> {
 public:
  explicit Output(Object& object) : object_(object) { resize<rows, cols>(object); }
  Array<rows, cols>& array() {
    return *reinterpret_cast<Array<rows, cols>*>(object_.data());
  }

 private:
  Object& object_;
};

template <int rows, int cols = 1, class Object>
Input<rows, cols, Object> input(const Eigen::MatrixBase<Object>& object) {
  check_type<Object, rows, cols>();
  return Input<rows, cols, Object>(object.derived());
}

/// Results are taken as constant, as Eigen does it, so that blocks and maps can be passed where
/// they are made.
template <int rows, int cols = 1, class Object>
Output<rows, cols, Object> output(const Eigen::MatrixBase<Object>& object) {
  check_type<Object, rows, cols>();
  static_assert((int(Object::Flags) & Eigen::LvalueBit) != 0, "a result has to be written to");
  return Output<rows, cols, Object>(object.const_cast_derived());
}

}  // namespace detail

template <class T0, class T1, class T2>
void forward_kinematics(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& position,
    const Eigen::MatrixBase<T2>& rotation) {
  ur10e::forward_kinematics(detail::input<6>(q).array(), detail::output<3>(position).array(),
      detail::output<9>(rotation).array());
}

template <class T0, class T1>
void jacobian(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& J) {
  ur10e::jacobian(detail::input<6>(q).array(), detail::output<6, 6>(J).array());
}

template <class T0, class T1, class T2>
void bias_acceleration(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& qd,
    const Eigen::MatrixBase<T2>& bias) {
  ur10e::bias_acceleration(detail::input<6>(q).array(), detail::input<6>(qd).array(),
      detail::output<6>(bias).array());
}

template <class T0, class T1, class T2, class T3>
void inverse_dynamics(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& qd,
    const Eigen::MatrixBase<T2>& qdd, const Eigen::MatrixBase<T3>& tau) {
  ur10e::inverse_dynamics(detail::input<6>(q).array(), detail::input<6>(qd).array(),
      detail::input<6>(qdd).array(), detail::output<6>(tau).array());
}

template <class T0, class T1>
void gravity(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& g) {
  ur10e::gravity(detail::input<6>(q).array(), detail::output<6>(g).array());
}

template <class T0, class T1, class T2>
void nonlinear_effects(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& qd,
    const Eigen::MatrixBase<T2>& h) {
  ur10e::nonlinear_effects(detail::input<6>(q).array(), detail::input<6>(qd).array(),
      detail::output<6>(h).array());
}

template <class T0, class T1>
void mass_matrix(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& M) {
  ur10e::mass_matrix(detail::input<6>(q).array(), detail::output<6, 6>(M).array());
}

template <class T0, class T1, class T2, class T3>
void forward_dynamics(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& qd,
    const Eigen::MatrixBase<T2>& tau, const Eigen::MatrixBase<T3>& qdd) {
  ur10e::forward_dynamics(detail::input<6>(q).array(), detail::input<6>(qd).array(),
      detail::input<6>(tau).array(), detail::output<6>(qdd).array());
}

template <class T0, class T1>
void lambda_inverse(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& Lambda_inv) {
  ur10e::lambda_inverse(detail::input<6>(q).array(), detail::output<6, 6>(Lambda_inv).array());
}

template <class T0, class T1>
void lambda(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& Lambda) {
  ur10e::lambda(detail::input<6>(q).array(), detail::output<6, 6>(Lambda).array());
}

template <class T0, class T1, class T2, class T3, class T4>
void control_torque(const Eigen::MatrixBase<T0>& q, const Eigen::MatrixBase<T1>& qd,
    const Eigen::MatrixBase<T2>& qdd_0, const Eigen::MatrixBase<T3>& xdd_cmd,
    const Eigen::MatrixBase<T4>& tau) {
  ur10e::control_torque(detail::input<6>(q).array(), detail::input<6>(qd).array(),
      detail::input<6>(qdd_0).array(), detail::input<6>(xdd_cmd).array(),
      detail::output<6>(tau).array());
}

}  // namespace ur10e::eigen

#endif  // TREELINE_UR10E_EIGEN_HPP
