#include "simulation/strike.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "interpreter/instances.hpp"

namespace treeline::simulation {
namespace {

using interpreter::Matrix;

/// J of the velocities of all touching points, relative to what they touch: three rows each. Of a
/// joint at its stop the first row has its velocity.
Matrix<double> relative_jacobian(const Model& model, const std::vector<Touch>& touches,
                                 const Vector& q) {
  const auto k = interpreter::kinematics<double>(model, q, Vector::Zero(model.nv));
  interpreter::Points<double> points;
  const auto add = [&](int body, const Vector3& position) {
    const Vector3 in_body = k.R_world[body].transpose() * (position - k.p_world[body]);
    points.push_back(interpreter::contact_point<double>(body, in_body));
  };
  const auto in_world = [](const Touch& touch) { return touch.other_body == interpreter::kWorld; };
  for (const Touch& touch : touches) add(touch.body, touch.position);
  const auto rows = 3 * static_cast<Eigen::Index>(touches.size());
  if (!std::all_of(touches.begin(), touches.end(), in_world)) {
    for (const Touch& touch : touches) add(touch.other_body, touch.position);
  }
  const Matrix<double> all = interpreter::jacobian<double>(model, points, q);
  Matrix<double> J = all.topRows(rows);
  if (all.rows() > rows) J -= all.bottomRows(rows);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (touches[i].joint >= 0) J(3 * static_cast<Eigen::Index>(i), touches[i].joint) = 1;
  }
  return J;
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
    if (touch.joint >= 0) law.restitution = law.friction = 0;
    laws.push_back(law);
  }
  return laws;
}

template <int room, int digits>
core::ContactSolution<double> solve_with_room(const Matrix<double>& A,
                                              const std::vector<core::ContactLaw<double>>& laws,
                                              Vector& v, Vector& impulses) {
  const auto solver = std::make_unique<core::ContactSolver<double, room, digits>>();
  return solver->solve(static_cast<int>(laws.size()), A.data(), laws.data(), v.data(),
                       impulses.data());
}

core::ContactSolution<double> solve(const Matrix<double>& A,
                                    const std::vector<core::ContactLaw<double>>& laws, Vector& v,
                                    Vector& impulses) {
  if (laws.size() > kMostTouches) throw std::length_error("more than 64 touches at once");
  if (laws.size() <= 8) return solve_with_room<8, 12>(A, laws, v, impulses);
  if (laws.size() <= 16) return solve_with_room<16, 8>(A, laws, v, impulses);
  return solve_with_room<kMostTouches, 8>(A, laws, v, impulses);
}

/// Leaves out touches that no impulse can separate, and their rows of J.
void keep_movable(const Eigen::LDLT<Matrix<double>>& M, std::vector<Touch>& touches,
                  Matrix<double>& J) {
  constexpr double kRounding = 1e-16;  // of squares of entries of J
  std::vector<Eigen::Index> rows;
  std::vector<Touch> kept;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Matrix<double> own = J.middleRows(row, 3);
    const Matrix<double> A = own * M.solve(own.transpose());
    const Vector3& n = touches[i].normal;
    if (!(n.dot(A * n) > kRounding * A.trace())) continue;
    rows.insert(rows.end(), {row, row + 1, row + 2});
    kept.push_back(touches[i]);
  }
  if (kept.size() < touches.size()) J = Matrix<double>(J(rows, Eigen::all));
  touches = std::move(kept);
}

}  // namespace

Blow strike(const Model& model, std::vector<Touch> touches, const Surface& surface, State& state) {
  Matrix<double> J = relative_jacobian(model, touches, state.q);
  const Matrix<double> M = interpreter::mass_matrix<double>(model, state.q);
  const Eigen::LDLT<Matrix<double>> factors(M);
  keep_movable(factors, touches, J);
  Blow blow;
  blow.touches = std::move(touches);
  blow.dqd = Vector::Zero(model.nv);
  if (blow.touches.empty()) return blow;
  const Matrix<double> response = factors.solve(J.transpose());
  const Matrix<double> A = J * response;
  blow.before = J * state.qd;
  const auto laws = laws_of(blow, surface);
  Vector v = blow.before;
  blow.impulses = Vector::Zero(J.rows());
  for (std::size_t i = 0; i < blow.touches.size(); ++i) {
    const Touch& touch = blow.touches[i];
    v.segment<3>(3 * static_cast<Eigen::Index>(i)) += touch.allowed * touch.normal;
    blow.impulses.segment<3>(3 * static_cast<Eigen::Index>(i)) = touch.start;
  }
  blow.solution = solve(A, laws, v, blow.impulses);
  blow.dqd = response * blow.impulses;
  blow.after = blow.before + A * blow.impulses;
  blow.work = 0.5 * blow.impulses.dot(blow.before + blow.after);
  blow.restitution = surface.restitution;
  blow.energy = blow.dqd.dot(M * (state.qd + 0.5 * blow.dqd));
  blow.momentum = momentum(model, {state.q, blow.dqd});
  state.qd += blow.dqd;
  return blow;
}

}  // namespace treeline::simulation
