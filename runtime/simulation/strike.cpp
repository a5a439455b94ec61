#include "simulation/strike.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

#include "interpreter/instances.hpp"

namespace treeline::simulation {
namespace {

using interpreter::Matrix;

/// Points of the bodies of all touches, followed by the points of the bodies that they touch.
interpreter::Points<double> points_of(const Model& model, const std::vector<Touch>& touches,
                                      const Vector& q) {
  const auto k = interpreter::kinematics<double>(model, q, Vector::Zero(model.nv));
  interpreter::Points<double> points;
  const auto add = [&](int body, const Vector3& position) {
    const Vector3 in_body = k.R_world[body].transpose() * (position - k.p_world[body]);
    points.push_back(interpreter::contact_point<double>(body, in_body));
  };
  for (const Touch& touch : touches) add(touch.body, touch.position);
  for (const Touch& touch : touches) add(touch.other_body, touch.position);
  return points;
}

/// Applies E = [1 -1], in which common motion of both bodies cancels.
Matrix<double> relative(const Matrix<double>& A) {
  const Eigen::Index n = A.rows() / 2;
  return A.topLeftCorner(n, n) - A.topRightCorner(n, n) - A.bottomLeftCorner(n, n) +
         A.bottomRightCorner(n, n);
}

std::vector<core::ContactLaw<double>> laws_of(const Blow& blow, const Surface& surface) {
  std::vector<core::ContactLaw<double>> laws;
  for (std::size_t i = 0; i < blow.touches.size(); ++i) {
    const Touch& touch = blow.touches[i];
    core::ContactLaw<double> law;
    Vector3::Map(law.normal) = touch.normal;
    const double speed = touch.normal.dot(blow.before.segment<3>(3 * static_cast<int>(i)));
    law.restitution = std::abs(speed) >= surface.slow ? surface.restitution : 0.0;
    law.friction = surface.friction;
    laws.push_back(law);
  }
  return laws;
}

core::ContactSolution<double> solve(const Matrix<double>& A,
                                    const std::vector<core::ContactLaw<double>>& laws, Vector& v,
                                    Vector& impulses) {
  constexpr int kFew = 8, kMost = 64;
  const int count = static_cast<int>(laws.size());
  if (count > kMost) throw std::length_error("more than 64 shapes touch at once");
  if (count <= kFew) {
    core::ContactSolver<double, kFew> solver;
    return solver.solve(count, A.data(), laws.data(), v.data(), impulses.data());
  }
  const auto solver = std::make_unique<core::ContactSolver<double, kMost>>();
  return solver->solve(count, A.data(), laws.data(), v.data(), impulses.data());
}

bool can_move(const Model& model, const Touch& touch, const Vector& q) {
  const auto points = points_of(model, {touch}, q);
  const auto A = relative(interpreter::contact_inverse_inertia<double>(model, points, q));
  return touch.normal.dot(A * touch.normal) > 0;
}

}  // namespace

Blow strike(const Model& model, std::vector<Touch> touches, const Surface& surface, State& state) {
  std::erase_if(touches, [&](const Touch& touch) { return !can_move(model, touch, state.q); });
  Blow blow;
  blow.touches = std::move(touches);
  const auto n = 3 * static_cast<Eigen::Index>(blow.touches.size());
  if (n == 0) return blow;
  const auto points = points_of(model, blow.touches, state.q);
  const Matrix<double> A =
      relative(interpreter::contact_inverse_inertia<double>(model, points, state.q));
  const Vector v = interpreter::contact_motion<double>(model, points, state.q, state.qd).velocity;
  blow.before = v.head(n) - v.tail(n);
  blow.after = blow.before;
  blow.impulses = Vector::Zero(n);
  const auto laws = laws_of(blow, surface);
  blow.solution = solve(A, laws, blow.after, blow.impulses);
  blow.work = 0.5 * blow.impulses.dot(blow.before + blow.after);
  blow.restitution = surface.restitution;
  blow.energy = -kinetic_energy(model, state);
  blow.momentum = -momentum(model, state);
  Vector both(2 * n);
  both << blow.impulses, -blow.impulses;
  state.qd += interpreter::impulse_response<double>(model, points, state.q, both).dqd;
  blow.energy += kinetic_energy(model, state);
  blow.momentum += momentum(model, state);
  return blow;
}

}  // namespace treeline::simulation
