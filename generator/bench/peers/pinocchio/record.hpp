#pragma once

#ifdef TREELINE_RECORD_BY_CASADI
#include <pinocchio/autodiff/casadi.hpp>
#else
#include <pinocchio/codegen/cppadcg.hpp>
#endif
// Pinocchio's scalars before its models.
#include <cstddef>
#include <string>
#include <vector>

#include "bench/peers/pinocchio/solver.hpp"

/// Pinocchio's algorithms as code: a scalar that records is put into the templates that are timed
/// in double, by CasADi or by CppADCodeGen.
namespace treeline::peer::pin {

#ifdef TREELINE_RECORD_BY_CASADI
using Recorded = casadi::SX;
#else
using Code = CppAD::cg::CG<double>;
using Recorded = CppAD::AD<Code>;
#endif
using Route = void (*)(Solver<Recorded>& solver, const Recorded* const* in, Recorded* out);

/// Number of entries of each argument.
struct Shape {
  std::vector<std::size_t> inputs;
  std::size_t output = 0;
};

/// What records.
struct Tool {
  const char* name;
  const char* release;
};
Tool recording_tool();

/// Returns the tool's code of one call, in C: `void recorded(void*, const double* const* in,
/// double* y)`, whose first argument is not used.
std::string record(const Solver<double>& solver, const Shape& shape, Route route);

/// The routes that are timed in double, with the same results: of symmetric matrices the upper
/// triangle, by columns, in Pinocchio's order of joints.
std::string record_rnea(const Solver<double>& solver);
std::string record_gravity(const Solver<double>& solver);
std::string record_aba(const Solver<double>& solver);
std::string record_crba(const Solver<double>& solver);
std::string record_rnea_derivatives(const Solver<double>& solver);
std::string record_aba_derivatives(const Solver<double>& solver);
std::string record_lambda_inverse(const Solver<double>& solver);
std::string record_lambda(const Solver<double>& solver);
std::string record_control_torque(const Solver<double>& solver);

}  // namespace treeline::peer::pin
