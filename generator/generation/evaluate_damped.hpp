#pragma once

#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// What `damped_control_torque` is composed from at one state, matrices row by row.
template <class Scalar>
struct DampedInputsIn {
  std::vector<Scalar> Lambda_inverse, J, bias;
  std::vector<Scalar> tau;  ///< inverse dynamics at qdd_0
  std::vector<Scalar> qdd_0, xdd_cmd, heaviest;
};
using DampedInputs = DampedInputsIn<double>;

/// Torques, then the least ease, operation by operation as the emitted header has them in `Scalar`,
/// by the headers of runtime/core that it is made from. Empty for more than 36 rows. For float,
/// double and, as a truth for these, long double.
template <class Scalar>
std::vector<Scalar> evaluate_damped_in(DampedInputsIn<Scalar> inputs);

extern template std::vector<float> evaluate_damped_in(DampedInputsIn<float>);
extern template std::vector<double> evaluate_damped_in(DampedInputsIn<double>);
extern template std::vector<long double> evaluate_damped_in(DampedInputsIn<long double>);

/// The same in `real`, each input rounded to it.
std::vector<double> evaluate_damped(Real real, const DampedInputs& inputs);

}  // namespace treeline
