#pragma once

#include <memory>

#include "bench/peers/pinocchio/description.hpp"
#include "bench/peers/pinocchio/solver.hpp"

/// The algorithms behind the benchmark's plain calls, in double. `solver` is a Solver<double>; for
/// `by_efpa` and `by_pv` it is what `make_contact_solver` makes from one, for
/// `constrained_dynamics` what `make_constraint_solver` makes.
namespace treeline::peer::pin {

#define TREELINE_BENCH_CALL(name) \
  void call_##name(void* solver, const double* const* in, double* out);
TREELINE_BENCH_CALL(rnea)
TREELINE_BENCH_CALL(gravity)
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
TREELINE_BENCH_CALL(constrained_dynamics)
#undef TREELINE_BENCH_CALL

std::shared_ptr<void> make_contact_solver(const Solver<double>& solver);

/// How the system of motion and forces is solved: mu is added to the diagonal of J M^-1 J^T, and
/// iterations remove what it changes until the rows' accelerations have this accuracy.
struct ProximalWay {
  double mu = 0;
  double accuracy = 1e-12;
  int iterations = 1;
};
std::shared_ptr<void> make_constraint_solver(const Solver<double>& solver,
                                             const std::vector<Held>& held, const ProximalWay& way);

}  // namespace treeline::peer::pin
