#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "cli/simulate_motion.hpp"
#include "interpreter/instances.hpp"

namespace treeline {
namespace {

using simulation::Vector;

/// M^-1
Eigen::MatrixXd mobility(const simulation::Model& model, const Vector& q) {
  const auto M = interpreter::mass_matrix<double>(model, q);
  return Eigen::LDLT<Eigen::MatrixXd>(M).solve(Eigen::MatrixXd::Identity(model.nv, model.nv));
}

/// Coefficients of which none is more than `share` of what its joint would bear alone: 1 / (w_ii
/// time).
Vector limited(const Vector& wanted, const Eigen::MatrixXd& w, double share, double time) {
  return wanted.cwiseMin((share / time * w.diagonal().cwiseInverse()).eval());
}

/// The largest coefficients of these with which `time` times the largest eigenvalue of w diag(c) is
/// at most 1: shares of 1, 1/2, 1/4 and so on of what each joint would bear alone.
Vector stable(const Vector& wanted, const Eigen::MatrixXd& w, double time) {
  for (double share = 1;; share /= 2) {
    const Vector c = limited(wanted, w, share, time);
    const Vector root = c.cwiseSqrt();
    const Eigen::MatrixXd scaled = time * root.asDiagonal() * w * root.asDiagonal();
    const double largest =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .maxCoeff();
    if (!(largest > 1)) return c;
  }
}

void limit(const simulation::Model& model, double step, const Vector& q, JointSprings& springs,
           Diagnostics& diagnostics) {
  const Eigen::MatrixXd w = mobility(model, q);
  const Vector stiffness = stable(springs.stiffness, w, step * step);
  const Vector damping = stable(springs.damping, w, step);
  int weaker = 0;
  for (int v = 0; v < model.nv; ++v) {
    const bool is_joint = springs.coordinates[static_cast<std::size_t>(v)] >= 0;
    const bool is_weaker = stiffness[v] < springs.stiffness[v] || damping[v] < springs.damping[v];
    weaker += is_joint && is_weaker ? 1 : 0;
  }
  springs.stiffness = stiffness;
  springs.damping = damping;
  if (weaker == 0) return;
  diagnostics.add({Severity::note, "", 0, "--stiffness",
                   fmt::format("{} joints are too light for the step and have weaker springs or "
                               "dampers",
                               weaker),
                   "give a shorter --step where they yield too much"});
}

}  // namespace

JointSprings make_springs(const simulation::Model& model, const MotionSettings& settings,
                          const simulation::State& start, Diagnostics& diagnostics) {
  JointSprings springs{Vector::Zero(model.nv), Vector::Zero(model.nv),
                       Vector::Constant(model.nv, settings.damping),
                       std::vector<int>(static_cast<std::size_t>(model.nv), -1)};
  if (settings.stiffness == 0) return springs;
  for (const auto& body : model.bodies) {
    if (interpreter::velocity_count(body.kind) != 1 || body.mimics) continue;
    springs.stiffness[body.v] = settings.stiffness;
    springs.rest[body.v] = start.q[body.q];
    springs.coordinates[static_cast<std::size_t>(body.v)] = body.q;
  }
  limit(model, settings.step, start.q, springs, diagnostics);
  return springs;
}

Vector force_of(const JointSprings& springs, const simulation::State& state) {
  Vector tau = -springs.damping.cwiseProduct(state.qd);
  for (int v = 0; v < tau.size(); ++v) {
    const int q = springs.coordinates[static_cast<std::size_t>(v)];
    if (q >= 0) tau[v] += springs.stiffness[v] * (springs.rest[v] - state.q[q]);
  }
  return tau;
}

}  // namespace treeline
