#pragma once

#include <pinocchio/codegen/cppadcg.hpp>
// Pinocchio's scalars before its models.
#include <cstddef>
#include <string>
#include <vector>

#include "bench/peers/pinocchio/solver.hpp"

namespace treeline::peer::pin {

using Code = CppAD::cg::CG<double>;
using Recorded = CppAD::AD<Code>;
using Route = void (*)(Solver<Recorded>& solver, const Recorded* const* in, Recorded* out);

/// How many numbers each argument has.
struct Shape {
  std::vector<std::size_t> inputs;
  std::size_t output = 0;
};

/// The statements that CppADCodeGen makes of one call: `y[i] = ...` of `in0[i]`, `in1[i]`, with
/// their temporaries declared.
std::string record(const Solver<double>& solver, const Shape& shape, Route route);

/// The same routes as are timed in double; symmetric matrices whole, in our order of joints.
std::string record_rnea(const Solver<double>& solver);
std::string record_aba(const Solver<double>& solver);
std::string record_mass_matrix(const Solver<double>& solver);
std::string record_lambda_inverse(const Solver<double>& solver);
std::string record_lambda(const Solver<double>& solver);
std::string record_control_torque(const Solver<double>& solver);

}  // namespace treeline::peer::pin
