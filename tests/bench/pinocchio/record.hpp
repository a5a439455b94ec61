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

/// Number of entries of each argument.
struct Shape {
  std::vector<std::size_t> inputs;
  std::size_t output = 0;
};

/// Returns the statements that CppADCodeGen makes from one call: `y[i] = ...` in terms of `in0[i]`,
/// `in1[i]`, with declarations of their temporaries.
std::string record(const Solver<double>& solver, const Shape& shape, Route route);

/// The routes that are timed in double; symmetric matrices are complete, in our order of joints.
std::string record_rnea(const Solver<double>& solver);
std::string record_aba(const Solver<double>& solver);
std::string record_mass_matrix(const Solver<double>& solver);
std::string record_lambda_inverse(const Solver<double>& solver);
std::string record_lambda(const Solver<double>& solver);
std::string record_control_torque(const Solver<double>& solver);

}  // namespace treeline::peer::pin
