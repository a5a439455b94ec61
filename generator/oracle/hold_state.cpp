#include "oracle/hold_state.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "interpreter/constrained_forward_dynamics.hpp"
#include "interpreter/loop_instances.hpp"
#include "oracle/entries.hpp"

namespace treeline {
namespace {

using interpreter::Matrix;
using interpreter::Vector;
using interpreter::detail::solve_consistent;

constexpr double kClosed = 1e-10;  ///< m, and the sine of an angle: one step of Newton's from zero

/// The nearest pose with closed loops.
std::optional<Vector<double>> close(const Subject<double>& subject, const Vector<double>& from) {
  const auto& model = subject.model;
  const auto& loops = subject.loops;
  if (loops.empty()) return from;
  std::vector<int> all(static_cast<std::size_t>(model.nv));
  std::iota(all.begin(), all.end(), 0);
  const auto near = interpreter::close_loops<double>(model, loops, from, all, kClosed);
  if (!near) return std::nullopt;
  const Matrix<double> J = interpreter::loop_jacobian<double>(model, loops, *near);
  const Vector<double> errors = interpreter::loop_errors<double>(model, loops, *near);
  return interpreter::move_coordinates<double>(model, *near, -solve_consistent<double>(J, errors),
                                               1);
}

bool is_within_limits(const std::vector<Coordinate>& coordinates, const Vector<double>& q) {
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const double at = q[static_cast<Eigen::Index>(i)];
    if (at < coordinates[i].lower || at > coordinates[i].upper) return false;
  }
  return true;
}

/// The nearest velocities that hold the rows. The second projection removes what rounding leaves
/// of large ones.
Vector<double> permitted(const Subject<double>& subject, const Vector<double>& q,
                         Vector<double> qd) {
  const Matrix<double> J = interpreter::detail::held_jacobian<double>(
      subject.model, subject.constraints, subject.loops, q);
  for (int pass = 0; pass < 2; ++pass) qd -= solve_consistent<double>(J, J * qd);
  return qd;
}

}  // namespace

bool hold_state(const StateSpace& space, State& state) {
  const auto q = close(space.subject, vector_of<double>(state.q));
  if (!q || !is_within_limits(space.coordinates, *q)) return false;
  state.qd = entries_of(permitted(space.subject, *q, vector_of<double>(state.qd)));
  state.q = entries_of(*q);
  std::transform(q->begin(), q->end(), state.sin_q.begin(), [](double x) { return std::sin(x); });
  std::transform(q->begin(), q->end(), state.cos_q.begin(), [](double x) { return std::cos(x); });
  for (const Quantity quantity : {Quantity::stabilisation, Quantity::drift}) {
    const auto found = state.others.find(quantity);
    if (found != state.others.end()) std::fill(found->second.begin(), found->second.end(), 0);
  }
  return true;
}

}  // namespace treeline
