#pragma once

#include <memory>

#include "bench/peers/pinocchio/solver.hpp"

/// The algorithms behind the benchmark's plain calls, in double. `solver` is a Solver<double>; for
/// `by_efpa` and `by_pv` it is what `make_contact_solver` makes from one.
namespace treeline::peer::pin {

#define TREELINE_BENCH_CALL(name) \
  void call_##name(void* solver, const double* const* in, double* out);
TREELINE_BENCH_CALL(rnea)
TREELINE_BENCH_CALL(aba)
TREELINE_BENCH_CALL(aba_in_world_axes)
TREELINE_BENCH_CALL(minverse)
TREELINE_BENCH_CALL(crba)
TREELINE_BENCH_CALL(crba_in_world_axes)
TREELINE_BENCH_CALL(rnea_derivatives)
TREELINE_BENCH_CALL(aba_derivatives)
TREELINE_BENCH_CALL(lambda_inverse_by_cholesky)
TREELINE_BENCH_CALL(lambda_by_cholesky)
TREELINE_BENCH_CALL(lambda_inverse_by_minverse)
TREELINE_BENCH_CALL(lambda_inverse_by_efpa)
TREELINE_BENCH_CALL(lambda_inverse_by_pv)
TREELINE_BENCH_CALL(control_torque)
TREELINE_BENCH_CALL(regressor)
TREELINE_BENCH_CALL(centroidal_map)
TREELINE_BENCH_CALL(centroidal_momentum)
TREELINE_BENCH_CALL(kinetic_energy)
#undef TREELINE_BENCH_CALL

std::shared_ptr<void> make_contact_solver(const Solver<double>& solver);

}  // namespace treeline::peer::pin
