#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

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

/// The joints of velocities: `elbow`, or `elbow and 2 more`.
std::string name_joints(const std::vector<Coordinate>& coordinates, const simulation::Model& model,
                        const std::vector<bool>& velocities) {
  std::vector<std::string> names;
  for (const auto& body : model.bodies) {
    const int count = body.mimics ? 0 : interpreter::velocity_count(body.kind);
    const auto first = velocities.begin() + body.v;
    if (std::none_of(first, first + count, [](bool is_meant) { return is_meant; })) continue;
    names.push_back(coordinates[static_cast<std::size_t>(body.q)].joint);
  }
  if (names.empty()) return {};
  return names.size() == 1 ? names.front()
                           : fmt::format("{} and {} more", names.front(), names.size() - 1);
}

void limit(const simulation::Model& model, const std::vector<Coordinate>& coordinates, double step,
           JointSprings& springs, Diagnostics& diagnostics) {
  const Eigen::MatrixXd w = mobility(model, springs.rest);
  const Vector stiffness = stable(springs.stiffness, w, step * step);
  const Vector damping = stable(springs.damping, w, step);
  std::vector<bool> weaker;
  for (int v = 0; v < model.nv; ++v) {
    weaker.push_back(stiffness[v] < springs.stiffness[v] || damping[v] < springs.damping[v]);
  }
  springs.stiffness = stiffness;
  springs.damping = damping;
  const std::string names = name_joints(coordinates, model, weaker);
  if (names.empty()) return;
  diagnostics.add({Severity::note, "", 0, "--stiffness",
                   "too light for the step, with weaker springs or dampers: " + names,
                   "give a shorter --step where they yield too much, or --integrator adaptive"});
}

}  // namespace

JointSprings make_springs(const simulation::Model& model,
                          const std::vector<Coordinate>& coordinates,
                          const MotionSettings& settings, const simulation::State& start,
                          bool on_ground, Diagnostics& diagnostics) {
  JointSprings springs{simulation::coordinates_of(model),
                       Vector::Constant(model.nv, settings.stiffness),
                       Vector::Constant(model.nv, settings.damping), start.q};
  for (const auto& body : model.bodies) {
    if (!on_ground || body.kind != interpreter::JointKind::floating) continue;
    springs.stiffness.segment<6>(body.v).setZero();
    springs.damping.segment<6>(body.v).setZero();
  }
  if (settings.stiffness > 0 && settings.integrator != Integrator::adaptive) {
    limit(model, coordinates, settings.step, springs, diagnostics);
  }
  return springs;
}

Vector force_of(const JointSprings& springs, const simulation::State& state) {
  Vector tau = -springs.damping.cwiseProduct(state.qd);
  if (springs.stiffness.isZero(0)) return tau;
  return tau - springs.stiffness.cwiseProduct(
                   simulation::displacement(springs.coordinates, springs.rest, state.q));
}

}  // namespace treeline
