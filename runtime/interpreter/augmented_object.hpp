#pragma once

#include "interpreter/lambda_inverse.hpp"
#include "interpreter/point_accelerations.hpp"
#include "interpreter/virtual_linkage.hpp"

namespace treeline::interpreter {

/// Equation of motion Lambda xdd + mu + p = F of the objects together with all robots that hold
/// them, at the objects' origins in world axes, six rows per object (Chang eq. 7.1).
template <class Scalar>
struct AugmentedObject {
  Matrix<Scalar> Lambda;
  Vector<Scalar> mu, p;
};

namespace detail {

/// Jbar^T tau = Lambda J A^-1 tau: the joint forces as they act at the points. `weightless` is the
/// model without gravity.
template <class Scalar>
Vector<Scalar> felt_at_points(const Model<Scalar>& weightless, const Points<Scalar>& points,
                              const Vector<Scalar>& q, const Vector<Scalar>& tau,
                              const Matrix<Scalar>& Lambda) {
  const Vector<Scalar> rest = Vector<Scalar>::Zero(weightless.nv);
  return Lambda * (jacobian<Scalar>(weightless, points, q) *
                   forward_dynamics<Scalar>(weightless, q, rest, tau));
}

}  // namespace detail

/// Sums the objects' own terms and C^T (...) C over the robots (Chang eq. 7.2, 7.6, 7.7; for
/// several robots 7.9 to 7.11). Precondition: independent hands, so that Lambda of each robot
/// exists at its grasps.
template <class Scalar>
AugmentedObject<Scalar> augmented_object(const ClosedChain<Scalar>& chain, PerRobotArg<Scalar> q,
                                         PerRobotArg<Scalar> qd) {
  const int size = 6 * static_cast<int>(chain.objects.size());
  AugmentedObject<Scalar> sum{Matrix<Scalar>::Zero(size, size), Vector<Scalar>::Zero(size),
                              Vector<Scalar>::Zero(size)};
  const auto poses = held_poses<Scalar>(chain, q, qd);
  for (std::size_t k = 0; k < chain.objects.size(); ++k) {
    const int at = 6 * static_cast<int>(k);
    const auto& first = poses[k].front();
    const auto bias = object_bias(chain.objects[k], first, chain.robots.front().gravity);
    sum.Lambda.template block<6, 6>(at, at) = object_inertia(chain.objects[k], first.R);
    sum.mu.template segment<6>(at) = bias.mu;
    sum.p.template segment<6>(at) = bias.p;
  }
  for (std::size_t r = 0; r < chain.robots.size(); ++r) {
    const auto points = object_points(chain, static_cast<int>(r));
    if (points.empty()) continue;
    const Model<Scalar> weightless = without_gravity<Scalar>(chain.robots[r]);
    const Matrix<Scalar> C = connectivity(chain, static_cast<int>(r));
    const Matrix<Scalar> Lambda = lambda<Scalar>(weightless, points, q[r]);
    const Vector<Scalar> b = nonlinear_effects<Scalar>(weightless, q[r], qd[r]);
    const Vector<Scalar> g = gravity<Scalar>(chain.robots[r], q[r]);
    const Vector<Scalar> bias = bias_acceleration<Scalar>(weightless, points, q[r], qd[r]);
    sum.Lambda += C.transpose() * Lambda * C;
    sum.mu += C.transpose() * (detail::felt_at_points(weightless, points, q[r], b, Lambda) -
                               Vector<Scalar>(Lambda * bias));
    sum.p += C.transpose() * detail::felt_at_points(weightless, points, q[r], g, Lambda);
  }
  return sum;
}

}  // namespace treeline::interpreter
