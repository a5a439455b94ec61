// Pinocchio: recursive Newton-Euler, articulated bodies, M, M^-1, derivatives, the regressor,
// momentum about the centre of mass, every route to J M^-1 J^T, and motion with rows held.
#include <pinocchio/config.hpp>

#include "bench/peers/make_peer.hpp"
#include "bench/peers/pinocchio/adapt.hpp"
#include "bench/peers/pinocchio/calls.hpp"
#include "bench/peers/pinocchio/read_solver.hpp"

namespace treeline::peer::pin {
namespace {

/// The ten columns of each moving link, by rows. Every joint but that of a floating base has one
/// velocity, so places of velocities tell those of joints.
void finish_regressor(void* solver, double* out) {
  const auto& s = *static_cast<const Solver<double>*>(solver);
  const Eigen::Index joints = s.model.njoints - 1;
  const Eigen::MatrixXd theirs = Eigen::Map<const Eigen::MatrixXd>(out, s.model.nv, 10 * joints);
  const Eigen::Index before = s.floating ? 5 : 0;
  Eigen::Map<Rows> ours(out, s.model.nv, 10 * joints);
  for (Eigen::Index i = 0; i < s.model.nv; ++i) {
    const Eigen::Index row = s.place[static_cast<std::size_t>(i)];
    for (Eigen::Index joint = 0; joint < joints; ++joint) {
      const bool base = s.floating && joint == 0;
      const Eigen::Index from =
          base ? 0 : s.place[static_cast<std::size_t>(joint + before)] - before;
      ours.block<1, 10>(i, 10 * joint) = theirs.block<1, 10>(row, 10 * from);
    }
  }
}

void finish_centroidal_map(void* solver, double* out) {
  const auto& s = *static_cast<const Solver<double>*>(solver);
  const Eigen::MatrixXd theirs = Eigen::Map<const Eigen::MatrixXd>(out, 6, s.model.nv);
  Eigen::Map<Rows> ours(out, 6, s.model.nv);
  for (Eigen::Index k = 0; k < s.model.nv; ++k) {
    ours.col(k) = theirs.col(s.place[static_cast<std::size_t>(k)]);
  }
}

void add_dynamics(Solver<double>& s, std::vector<Routine>& routines) {
  const Routine all[] = {
      {"inverse_dynamics", "", &s, call_rnea, nullptr},
      {"gravity", "", &s, call_gravity, nullptr},
      {"forward_dynamics", "", &s, call_aba, nullptr},
      {"forward_dynamics", "in world axes", &s, call_aba_in_world_axes, nullptr},
      {"mass_matrix", "", &s, call_crba, finish_symmetric},
      {"mass_matrix", "in world axes", &s, call_crba_in_world_axes, finish_symmetric},
      {"mass_matrix_inverse", "", &s, call_minverse, finish_symmetric},
      {"inverse_dynamics_derivatives", "", &s, call_rnea_derivatives, finish_derivatives},
      {"forward_dynamics_derivatives", "", &s, call_aba_derivatives, finish_derivatives},
      {"inverse_dynamics_regressor", "", &s, call_regressor, finish_regressor},
      {"centroidal_momentum_matrix", "", &s, call_centroidal_map, finish_centroidal_map},
      {"centroidal_momentum", "", &s, call_centroidal_momentum, nullptr},
      {"kinetic_energy", "", &s, call_kinetic_energy, nullptr}};
  routines.insert(routines.end(), std::begin(all), std::end(all));
}

void add_operational_space(Solver<double>& s, void* contacts, std::vector<Routine>& routines) {
  constexpr const char* kCholesky = "Cholesky of M";
  const Routine all[] = {
      {"lambda_inverse", kCholesky, &s, call_lambda_inverse_by_cholesky, finish_lambda},
      {"lambda_inverse", "computeMinverse", &s, call_lambda_inverse_by_minverse, finish_lambda},
      {"lambda_inverse", "EFPA", contacts, call_lambda_inverse_by_efpa, finish_lambda},
      {"lambda_inverse", "PV-OSIM", contacts, call_lambda_inverse_by_pv, finish_lambda},
      {"lambda", kCholesky, &s, call_lambda_by_cholesky, finish_lambda},
      {"control_torque", kCholesky, &s, call_control_torque, nullptr}};
  routines.insert(routines.end(), std::begin(all), std::end(all));
}

/// Adds constrained dynamics. Where rows depend on each other, the plain solve divides by a value
/// that vanishes; Pinocchio's header advises this mu there.
void add_constrained_dynamics(const Solver<double>& s, const std::vector<Held>& held,
                              Opened& opened) {
  const std::pair<const char*, ProximalWay> ways[] = {
      {"constraintDynamics", {}},
      {"constraintDynamics, mu 1e-12, at most 10 iterations", {1e-12, 1e-12, 10}}};
  for (const auto& [route, way] : ways) {
    opened.solvers.push_back(make_constraint_solver(s, held, way));
    opened.routines.push_back({"constrained_forward_dynamics", route, opened.solvers.back().get(),
                               call_constrained_dynamics, nullptr});
  }
}

Opened open(const Robot& robot, const Tell& tell) {
  const Description description = describe(robot, tell);
  auto read = read_solver(description);
  if (!read) {
    tell("does not read the robot as it is described");
    return {};
  }
  Opened opened;
  auto& s = opened.keep<Solver<double>>(*std::move(read));
  add_dynamics(s, opened.routines);
  if (!description.held.empty()) add_constrained_dynamics(s, description.held, opened);
  if (s.points.empty()) return opened;
  opened.solvers.push_back(make_contact_solver(s));
  add_operational_space(s, opened.solvers.back().get(), opened.routines);
  return opened;
}

constexpr Peer kPeer = make_peer<open>("Pinocchio", PINOCCHIO_VERSION);

}  // namespace
}  // namespace treeline::peer::pin

const treeline::peer::Peer* treeline_peer() {
  return &treeline::peer::pin::kPeer;
}
