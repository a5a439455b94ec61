#pragma once

#include <vector>

#include "choice/generated_function.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Inputs from which `damped_control_torque` is composed at one state; matrices are row-major.
template <class Scalar>
struct DampedInputsIn {
  std::vector<Scalar> Lambda_inverse, J, bias;
  std::vector<Scalar> tau;  ///< inverse dynamics at qdd_0
  std::vector<Scalar> qdd_0, xdd_cmd, mass_limits;
};
using DampedInputs = DampedInputsIn<double>;

/// Evaluates the torques, followed by the smallest eigenvalue of the scaled Lambda^-1, with the
/// same operations in `Scalar` as the emitted header, using the headers of runtime/core from which
/// it is made. Empty for more than 36 rows. For float, double and, as a reference for these, long
/// double.
template <class Scalar>
std::vector<Scalar> evaluate_damped_in(DampedInputsIn<Scalar> inputs);

extern template std::vector<float> evaluate_damped_in(DampedInputsIn<float>);
extern template std::vector<double> evaluate_damped_in(DampedInputsIn<double>);
extern template std::vector<long double> evaluate_damped_in(DampedInputsIn<long double>);

/// Evaluates the torques and the smallest eigenvalue in `real`, with each input rounded to it.
std::vector<double> evaluate_damped(Real real, const DampedInputs& inputs);

/// Makes `damped_control_torque` callable like other functions. It has the arguments and results of
/// NAME_damped.hpp; its return value, the smallest eigenvalue of the scaled Lambda^-1, is the last
/// result. Its program has no graph: it is composed of loops and of `functions`, which must include
/// `kDampedFunctions`.
GeneratedFunction compose_damped(const std::vector<GeneratedFunction>& functions);

}  // namespace treeline
