#pragma once

#include <functional>
#include <vector>

#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "random_state.hpp"

/// Physical laws for any mechanism, computed from positions by differences in 50 digits where
/// possible, so that a test does not use the recursion that it tests.
namespace treeline::tests {

using interpreter::Digits50;
using Model50 = interpreter::Model<Digits50>;
using Points50 = interpreter::Points<Digits50>;
using Vector50 = interpreter::Vector<Digits50>;
using Matrix50 = interpreter::Matrix<Digits50>;

/// Tolerance of algebra in 50 digits, relative to the scale: 12 digits for the condition number of
/// M and the operations between.
inline const Digits50 kAlgebra("1e-38");
/// Tolerance of `derivative`, relative to the scale: the fourth power of its step times the size of
/// the fifth derivative.
inline const Digits50 kDifference("1e-28");

/// A random mechanism in 50 digits with a random state.
struct Case {
  Model50 model;
  Points50 points;
  Points50 external_points;
  Vector50 q, qd, qdd, tau, f_ext, xdd;
};

inline Case random_case(std::uint64_t seed, const RandomOptions& options) {
  const RandomMechanism made = random_mechanism(seed, options);
  Case c;
  c.model = model_from_robot<Digits50>(made.robot, made.scene);
  c.points = points_from_scene(c.model, made.scene.operational_points);
  c.external_points = points_from_scene(c.model, made.scene.external_forces);
  Rng rng(seed + 1000003);
  c.q = random_position(rng, c.model);
  c.qd = random_entries<Digits50>(rng, c.model.nv, 4);
  c.qdd = random_entries<Digits50>(rng, c.model.nv, 20);
  c.tau = random_entries<Digits50>(rng, c.model.nv, 50);
  c.f_ext = random_entries<Digits50>(rng, 6 * static_cast<int>(c.external_points.size()), 30);
  c.xdd = random_entries<Digits50>(rng, interpreter::row_count(c.points), 20);
  return c;
}

struct NamedOptions {
  const char* name;
  std::uint64_t seed;
  RandomOptions options;
};

inline std::ostream& operator<<(std::ostream& out, const NamedOptions& named) {
  return out << named.name << ", seed " << named.seed;
}

/// Chains and trees with every joint type, fixed and floating, with 1 to 60 joints.
inline std::vector<NamedOptions> assorted_mechanisms() {
  const JointMix even{1, 1, 1, 1, 1, 1};
  const JointMix hinges{1, 0, 0, 0, 0, 0};
  const JointMix planar{0, 0, 0, 0, 0, 1};
  const JointMix free_bodies{0, 0, 0, 0, 1, 0};
  const JointMix balls{0, 0, 0, 0, 0, 0, 1};
  const JointMix hinges_and_slides{3, 1, 2, 1, 0, 0};
  std::vector<NamedOptions> list;
  const auto add = [&](const char* name, RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) {
      list.push_back({name, 7919 * list.size() + 1, options});
    }
  };
  add("one_joint", {.joints = 1, .mix = even, .aligned = 0.2, .external_forces = 1}, 6);
  add("one_joint_floating_base", {.joints = 1, .mix = even, .floating_base = true}, 3);
  add("arm", {.joints = 6, .branching = 0, .mix = hinges, .external_forces = 1}, 3);
  add("planar_chain", {.joints = 3, .branching = 0, .mix = planar, .aligned = 0}, 2);
  add("free_chain", {.joints = 2, .branching = 0, .mix = free_bodies, .external_forces = 2}, 2);
  add("tree",
      {.joints = 9, .mix = even, .massless = 0.5, .operational_points = 2, .external_forces = 2},
      4);
  add("floating_tree",
      {.joints = 9, .mix = even, .floating_base = true, .operational_points = 3, .all_rows = false},
      4);
  add("mimic_tree", {.joints = 9, .mix = hinges_and_slides, .mimic = 0.6, .external_forces = 1}, 4);
  add("mimic_floating_tree",
      {.joints = 9, .mix = hinges_and_slides, .floating_base = true, .mimic = 0.5, .locked = 0.2},
      3);
  add("ball_chain", {.joints = 3, .branching = 0, .mix = balls, .external_forces = 1}, 2);
  add("ball_tree",
      {.joints = 8, .mix = {1, 1, 1, 1, 1, 1, 4}, .massless = 0.5, .external_forces = 2}, 3);
  add("ball_floating_tree", {.joints = 8, .mix = {2, 1, 1, 1, 0, 0, 4}, .floating_base = true}, 2);
  add("locked_tree", {.joints = 10, .mix = hinges_and_slides, .locked = 0.4}, 3);
  add("floating_thirty", {.joints = 30, .mix = even, .floating_base = true}, 1);
  add("sixty", {.joints = 60, .operational_points = 2, .all_rows = false}, 1);
  return list;
}

/// df/dt at t = 0 by a central difference of fourth order in 50 digits.
template <class F>
auto derivative(const F& f) {
  const Digits50 h("1e-9");
  using Value = std::decay_t<decltype(f(h))>;
  const Value far = f(2 * h) - f(-2 * h);
  const Value near = f(h) - f(-h);
  return Value((Digits50(8) * near - far) / (Digits50(12) * h));
}

/// q after a short time of moving with qd, to first order in t. Higher odd terms cancel, or are
/// part of the error in uses of `derivative`, which compare first derivatives only.
inline Vector50 moved(const Model50& model, const Vector50& q, const Vector50& qd,
                      const Digits50& t) {
  return q + t * interpreter::position_derivative<Digits50>(model, q, qd);
}

inline interpreter::Kinematics<Digits50> kinematics_of(const Case& c, const Vector50& q,
                                                       const Vector50& qd) {
  return interpreter::kinematics<Digits50>(c.model, q, qd);
}

/// Kinetic energy, J, from each body's velocity.
inline Digits50 kinetic_energy(const Model50& model, const Vector50& q, const Vector50& qd) {
  const auto k = interpreter::kinematics<Digits50>(model, q, qd);
  Digits50 energy = 0;
  for (int i = 0; i < model.size(); ++i) {
    const auto& b = model.body(i);
    const interpreter::Vector3<Digits50> v = interpreter::linear(k.v[i]);
    const interpreter::Vector3<Digits50> w = interpreter::angular(k.v[i]);
    energy += b.mass * v.dot(v) / 2 + b.mass * v.dot(w.cross(b.com)) +
              w.dot(interpreter::Vector3<Digits50>(b.inertia * w)) / 2;
  }
  return energy;
}

/// Potential energy, J; zero if the centre of mass is at the world's origin.
inline Digits50 potential_energy(const Model50& model, const Vector50& q) {
  const auto k = interpreter::kinematics<Digits50>(model, q, Vector50::Zero(model.nv));
  Digits50 energy = 0;
  for (int i = 0; i < model.size(); ++i) {
    const auto& b = model.body(i);
    const interpreter::Vector3<Digits50> com = k.p_world[i] + k.R_world[i] * b.com;
    energy -= b.mass * model.gravity.dot(com);
  }
  return energy;
}

/// [momentum; angular momentum about the world's origin], world axes.
inline interpreter::Vector6<Digits50> momentum(const Model50& model, const Vector50& q,
                                               const Vector50& qd) {
  using interpreter::Vector3;
  const auto k = interpreter::kinematics<Digits50>(model, q, qd);
  interpreter::Vector6<Digits50> total = interpreter::Vector6<Digits50>::Zero();
  for (int i = 0; i < model.size(); ++i) {
    const auto& b = model.body(i);
    const Vector3<Digits50> v = interpreter::linear(k.v[i]);
    const Vector3<Digits50> w = interpreter::angular(k.v[i]);
    const Vector3<Digits50> P = k.R_world[i] * (b.mass * (v + w.cross(b.com)));
    const Vector3<Digits50> L = k.R_world[i] * (b.mass * b.com.cross(v) + b.inertia * w);
    total += interpreter::stack<Digits50>(P, L + k.p_world[i].cross(P));
  }
  return total;
}

/// The largest entry, but at least `floor`: the scale to which errors are relative.
template <class Derived>
Digits50 scale(const Eigen::MatrixBase<Derived>& x, const Digits50& floor = Digits50(1)) {
  if (x.size() == 0) return floor;
  const Digits50 largest = x.cwiseAbs().maxCoeff();
  return largest > floor ? largest : floor;
}

/// The largest difference relative to the scale of `expected`.
template <class A, class B>
Digits50 relative_error(const Eigen::MatrixBase<A>& actual, const Eigen::MatrixBase<B>& expected) {
  if (expected.size() == 0) return Digits50(actual.size());
  return Digits50((actual - expected).cwiseAbs().maxCoeff() / scale(expected));
}

}  // namespace treeline::tests
