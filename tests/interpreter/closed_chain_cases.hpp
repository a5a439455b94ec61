#pragma once

#include <Eigen/LU>

#include "interpreter/object_forward_dynamics.hpp"
#include "interpreter/physics.hpp"

/// Random robots that hold random objects, in states that close the chain, and the dense equations
/// of motion with every constraint, in 50 digits.
namespace treeline::tests {

using Chain50 = interpreter::ClosedChain<Digits50>;
using PerRobot50 = interpreter::PerRobot<Digits50>;

struct ChainCase {
  Chain50 chain;
  PerRobot50 q, qd, qdd_0, tau;
  Vector50 xdd, internal;
  Digits50 condition = 1;  ///< largest of all Lambda_e^-1
};

struct ChainOptions {
  std::vector<int> grasps;  ///< number of grasps per robot, all on one object
  bool floating_base = false;
  double mimic = 0;
  int loose_objects = 0;  ///< further objects, each in one hand of the first robot
};

inline interpreter::Matrix3<Digits50> random_rotation(Rng& rng) {
  Eigen::Vector4d x(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1), 1);
  const interpreter::Vector<Digits50> u = x.cast<Digits50>() / Digits50(sqrt(x.squaredNorm()));
  const interpreter::Vector3<Digits50> v = u.head<3>() / Digits50(sqrt(u.squaredNorm()));
  const interpreter::Matrix3<Digits50> V = interpreter::cross_matrix(v);
  const Digits50 w = u(3) / Digits50(sqrt(u.squaredNorm()));
  return interpreter::Matrix3<Digits50>::Identity() + 2 * (w * V + V * V);
}

inline interpreter::GraspedObject<Digits50> random_object(Rng& rng) {
  interpreter::GraspedObject<Digits50> object;
  const Inertial drawn = detail::random_inertial(rng, 0.3);
  object.mass = drawn.mass;
  object.com = random_entries<Digits50>(rng, 3, 0.2);
  object.inertia << drawn.ixx, drawn.ixy, drawn.ixz, drawn.ixy, drawn.iyy, drawn.iyz, drawn.ixz,
      drawn.iyz, drawn.izz;
  return object;
}

/// A grasp at `point` in which the object has the pose (R, p) in the world.
inline interpreter::Grasp<Digits50> closing_grasp(
    int robot, const interpreter::OperationalPoint<Digits50>& point,
    const interpreter::PointPose<Digits50>& pose, const interpreter::Matrix3<Digits50>& R,
    const interpreter::Vector3<Digits50>& p) {
  return {robot, point, pose.rotation.transpose() * R,
          pose.rotation.transpose() * (p - pose.position)};
}

/// Rows and joints of all robots together: J is block diagonal, C is stacked.
struct Stacked {
  Matrix50 M, J, C;
  Vector50 h, bias, qd;
};

inline Stacked stacked(const Chain50& chain, const PerRobot50& q, const PerRobot50& qd) {
  int nv = 0, rows = 0;
  for (std::size_t r = 0; r < chain.robots.size(); ++r) {
    nv += chain.robots[r].nv;
    rows += 6 * static_cast<int>(object_points(chain, static_cast<int>(r)).size());
  }
  const int columns = 6 * static_cast<int>(chain.objects.size());
  Stacked all{Matrix50::Zero(nv, nv), Matrix50::Zero(rows, nv), Matrix50::Zero(rows, columns),
              Vector50(nv),           Vector50(rows),           Vector50(nv)};
  int v = 0, row = 0;
  for (std::size_t r = 0; r < chain.robots.size(); ++r) {
    const Model50& model = chain.robots[r];
    const auto points = object_points(chain, static_cast<int>(r));
    const int own = 6 * static_cast<int>(points.size());
    all.M.block(v, v, model.nv, model.nv) = interpreter::mass_matrix<Digits50>(model, q[r]);
    all.J.block(row, v, own, model.nv) = interpreter::jacobian<Digits50>(model, points, q[r]);
    all.C.middleRows(row, own) = connectivity(chain, static_cast<int>(r));
    all.h.segment(v, model.nv) = interpreter::nonlinear_effects<Digits50>(model, q[r], qd[r]);
    all.bias.segment(row, own) =
        interpreter::bias_acceleration<Digits50>(model, points, q[r], qd[r]);
    all.qd.segment(v, model.nv) = qd[r];
    v += model.nv;
    row += own;
  }
  return all;
}

inline Vector50 joined(const PerRobot50& parts) {
  Vector50 all(0);
  for (const Vector50& part : parts) {
    const Eigen::Index at = all.size();
    all.conservativeResize(at + part.size());
    all.tail(part.size()) = part;
  }
  return all;
}

inline PerRobot50 split(const Vector50& all, const Chain50& chain) {
  PerRobot50 parts;
  Eigen::Index at = 0;
  for (const Model50& model : chain.robots) {
    parts.emplace_back(all.segment(at, model.nv));
    at += model.nv;
  }
  return parts;
}

/// The nearest joint velocities that keep the chain closed: J qd = C xd for some xd.
inline PerRobot50 closed_velocity(const Chain50& chain, const PerRobot50& q, const PerRobot50& qd) {
  const Stacked all = stacked(chain, q, qd);
  const Matrix50 P =
      Matrix50::Identity(all.C.rows(), all.C.rows()) -
      all.C * Matrix50((all.C.transpose() * all.C).ldlt().solve(Matrix50(all.C.transpose())));
  const Matrix50 K = P * all.J;  // K qd = 0; K K^T has the rank of P
  const Vector50 reach = Matrix50(K * K.transpose()).fullPivLu().solve(Vector50(K * all.qd));
  return split(all.qd - K.transpose() * reach, chain);
}

/// Forces, moments and accelerations from the dense system
/// [M 0 J^T; 0 I -C^T; J -C 0] [qdd; xdd; f] = [tau - h; -mu - p; -Jd qd + correction].
struct DenseMotion {
  Vector50 qdd, xdd, f;
};

inline DenseMotion dense_motion(const ChainCase& c, const Vector50& correction) {
  const Stacked all = stacked(c.chain, c.q, c.qd);
  const Eigen::Index n = all.M.rows(), m = all.J.rows(), o = all.C.cols();
  const auto poses = interpreter::held_poses<Digits50>(c.chain, c.q, c.qd);
  Matrix50 K = Matrix50::Zero(n + o + m, n + o + m);
  Vector50 rhs(n + o + m);
  K.topLeftCorner(n, n) = all.M;
  K.topRightCorner(n, m) = all.J.transpose();
  K.block(n, n + o, o, m) = -all.C.transpose();
  K.bottomLeftCorner(m, n) = all.J;
  K.block(n + o, n, m, o) = -all.C;
  rhs.head(n) = joined(c.tau) - all.h;
  rhs.tail(m) = correction - all.bias;
  for (std::size_t k = 0; k < c.chain.objects.size(); ++k) {
    const auto at = n + 6 * static_cast<Eigen::Index>(k);
    const auto& object = c.chain.objects[k];
    K.block<6, 6>(at, at) = object_inertia(object, poses[k].front().R);
    const auto bias = object_bias(object, poses[k].front(), c.chain.robots.front().gravity);
    rhs.segment<6>(at) = -bias.mu - bias.p;
  }
  const Vector50 x = K.fullPivLu().solve(rhs);
  return {x.head(n), x.segment(n, o), x.tail(m)};
}

inline Digits50 worst_condition(const ChainCase& c) {
  Digits50 worst = 1;
  for (std::size_t r = 0; r < c.chain.robots.size(); ++r) {
    const auto points = object_points(c.chain, static_cast<int>(r));
    const Vector50 pivots = interpreter::lambda_inverse<Digits50>(c.chain.robots[r], points, c.q[r])
                                .ldlt()
                                .vectorD()
                                .cwiseAbs();
    const Digits50 least = pivots.minCoeff();
    const Digits50 ratio = least == 0 ? Digits50("1e60") : Digits50(pivots.maxCoeff() / least);
    worst = ratio > worst ? ratio : worst;
  }
  return worst;
}

/// Draws a case. Its hands may depend on each other.
inline ChainCase draw_chain(std::uint64_t seed, const ChainOptions& options) {
  Rng rng(seed + 77);
  ChainCase c;
  c.chain.objects.push_back(random_object(rng));
  const auto R = random_rotation(rng);
  const interpreter::Vector3<Digits50> p = random_entries<Digits50>(rng, 3, 0.7);
  for (std::size_t r = 0; r < options.grasps.size(); ++r) {
    const int loose = r == 0 ? options.loose_objects : 0;
    const int points = options.grasps[r] + loose;
    const Case drawn = random_case(seed + 1000 * r, {.joints = 9 * points,
                                                     .branching = 0.15,
                                                     .mix = {5, 1, 2, 0, 0.2, 0.5},
                                                     .floating_base = options.floating_base,
                                                     .mimic = options.mimic,
                                                     .aligned = 0.3,
                                                     .operational_points = points});
    const auto poses =
        interpreter::forward_kinematics<Digits50>(drawn.model, drawn.points, drawn.q);
    for (int i = 0; i < points; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const int robot = static_cast<int>(r);
      if (i < options.grasps[r]) {
        c.chain.objects[0].grasps.push_back(
            closing_grasp(robot, drawn.points[at], poses[at], R, p));
      } else {
        c.chain.objects.push_back(random_object(rng));
        c.chain.objects.back().grasps.push_back(
            {robot, drawn.points[at], random_rotation(rng), random_entries<Digits50>(rng, 3, 0.3)});
      }
    }
    c.chain.robots.push_back(drawn.model);
    c.chain.robots.back().gravity = c.chain.robots.front().gravity;
    c.q.push_back(drawn.q);
    c.qd.push_back(drawn.qd);
    c.qdd_0.push_back(drawn.qdd);
    c.tau.push_back(drawn.tau);
  }
  c.xdd = random_entries<Digits50>(rng, 6 * static_cast<int>(c.chain.objects.size()), 10);
  c.internal = random_entries<Digits50>(rng, interpreter::internal_force_count(c.chain), 20);
  return c;
}

/// The first case from this seed on whose hands move independently, with closed velocities.
inline ChainCase chain_case(std::uint64_t seed, const ChainOptions& options) {
  for (;; seed += 17) {
    ChainCase c = draw_chain(seed, options);
    c.condition = worst_condition(c);
    if (c.condition > Digits50(1e8)) continue;
    c.qd = closed_velocity(c.chain, c.q, c.qd);
    return c;
  }
}

}  // namespace treeline::tests
