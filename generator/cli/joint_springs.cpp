#include "cli/joint_springs.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "interpreter/instances.hpp"

namespace treeline {
namespace {

using simulation::Vector;

/// The diagonal of M^-1.
Vector mobilities(const simulation::Model& model, const Vector& q) {
  const auto M = interpreter::mass_matrix<double>(model, q);
  const Eigen::MatrixXd inverse =
      Eigen::LDLT<Eigen::MatrixXd>(M).solve(Eigen::MatrixXd::Identity(model.nv, model.nv));
  return inverse.diagonal();
}

void limit(const simulation::Model& model, double step, const Vector& q, JointSprings& springs,
           Diagnostics& diagnostics) {
  const Vector w = model.nv * mobilities(model, q);
  int weaker = 0;
  for (int v = 0; v < model.nv; ++v) {
    const double most_stiffness = 1 / (w[v] * step * step);
    const double most_damping = 1 / (w[v] * step);
    const bool is_joint = springs.coordinates[static_cast<std::size_t>(v)] >= 0;
    const bool is_weaker =
        springs.stiffness[v] > most_stiffness || springs.damping[v] > most_damping;
    weaker += is_joint && is_weaker ? 1 : 0;
    springs.stiffness[v] = std::min(springs.stiffness[v], most_stiffness);
    springs.damping[v] = std::min(springs.damping[v], most_damping);
  }
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
