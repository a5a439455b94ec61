#include <algorithm>
#include <pinocchio/algorithm/centroidal.hpp>
#include <pinocchio/algorithm/energy.hpp>
#include <pinocchio/algorithm/regressor.hpp>

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

/// `out` receives Y by columns, ten of each joint, in Pinocchio's order.
void call_regressor(void* solver, const double* const* in, double* out) {
  auto& s = *static_cast<Solver<double>*>(solver);
  s.load_motion(in);
  const auto& Y = pinocchio::computeJointTorqueRegressor(s.model, s.data, s.q, s.qd, s.drive);
  std::copy_n(Y.data(), Y.size(), out);
}

/// `out` receives A_G by columns, in Pinocchio's order.
void call_centroidal_map(void* solver, const double* const* in, double* out) {
  auto& s = *static_cast<Solver<double>*>(solver);
  s.load_position(in[0]);
  const auto& A = pinocchio::computeCentroidalMap(s.model, s.data, s.q);
  std::copy_n(A.data(), A.size(), out);
}

void call_centroidal_momentum(void* solver, const double* const* in, double* out) {
  auto& s = *static_cast<Solver<double>*>(solver);
  s.load_position(in[0]);
  s.load(in[1], s.qd);
  const auto& h = pinocchio::computeCentroidalMomentum(s.model, s.data, s.q, s.qd);
  std::copy_n(h.toVector().data(), 6, out);
}

void call_kinetic_energy(void* solver, const double* const* in, double* out) {
  auto& s = *static_cast<Solver<double>*>(solver);
  s.load_position(in[0]);
  s.load(in[1], s.qd);
  *out = pinocchio::computeKineticEnergy(s.model, s.data, s.q, s.qd);
}

}  // namespace treeline::peer::pin
