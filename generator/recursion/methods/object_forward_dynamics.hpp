#pragma once

#include <vector>

#include "recursion/methods/forces_of_rows.hpp"
#include "recursion/methods/forward_dynamics.hpp"
#include "recursion/methods/lambda_routes.hpp"
#include "recursion/methods/object_control_torque.hpp"
#include "recursion/methods/object_state.hpp"

namespace treeline {

/// State of the objects before their forces are known, with one entry per object or per grasp.
template <class Scalar>
struct HeldObjects {
  std::vector<std::vector<HeldObject<Scalar>>> held;
  std::vector<Scalar> corrections;  ///< by row of the grasps: commanded by stabilisation
};

template <class Scalar>
HeldObjects<Scalar> held_objects(const Tree<Scalar>& tree,
                                 const std::vector<TreeObject<Scalar>>& objects,
                                 const std::vector<JointTransform<Scalar>>& X,
                                 std::span<const Scalar> qd, std::span<const Scalar> gains) {
  const auto poses = world_poses(tree, X);
  const auto velocities = link_velocities(tree, X, {qd, {}});
  HeldObjects<Scalar> result;
  for (const TreeObject<Scalar>& object : objects) {
    std::vector<HeldObject<Scalar>> held;
    for (const TreeGrasp<Scalar>& grasp : object.grasps) {
      held.push_back(held_object(poses, velocities, grasp));
      Drift<Scalar> drift;
      if (held.size() > 1) {
        drift = drift_between(held.front(), held.back());
      }
      append(-(drift.velocity * gains[0] + drift.position * gains[1]), result.corrections);
      append(-(drift.angular_velocity * gains[0] + drift.turn * gains[1]), result.corrections);
    }
    result.held.push_back(std::move(held));
  }
  return result;
}

/// Lambda_obj^-1 of an object, and its acceleration if nobody holds it, at its origin in world
/// axes.
template <class Scalar>
struct FreeObject {
  DenseMatrix<Scalar> inverse_Lambda;
  std::vector<Scalar> acceleration;
};

template <class Scalar>
FreeObject<Scalar> free_object(const Tree<Scalar>& tree, const TreeObject<Scalar>& object,
                               const HeldObject<Scalar>& held) {
  const Symmetric3<Scalar> K = congruent(held.R, object.central_inverse);
  const Vector3<Scalar> c = held.R * object.center;
  const Vector3<Scalar> K_rows[3] = {{K.xx, K.xy, K.xz}, {K.xy, K.yy, K.yz}, {K.xz, K.yz, K.zz}};
  // Effect of a force at the origin: angular K (-c x f), linear f / m - wd x c.
  FreeObject<Scalar> result;
  result.inverse_Lambda = DenseMatrix<Scalar>(6, 6);
  DenseMatrix<Scalar>& A = result.inverse_Lambda;
  Vector3<Scalar> coupling[3];  // rows of K [c]x, so that wd = -K [c]x f + K n
  for (std::size_t i = 0; i < 3; ++i) {
    coupling[i] = cross(K_rows[i], c);
    const Scalar entries[3] = {-coupling[i].x, -coupling[i].y, -coupling[i].z};
    const Scalar of_K[3] = {K_rows[i].x, K_rows[i].y, K_rows[i].z};
    for (std::size_t j = 0; j < 3; ++j) {
      A(3 + i, j) = A(j, 3 + i) = entries[j];
      A(3 + i, 3 + j) = of_K[j];
    }
  }
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector3<Scalar> wd{A(3, j), A(4, j), A(5, j)};
    const Vector3<Scalar> a = cross(c, wd);
    const Scalar column[3] = {a.x, a.y, a.z};
    for (std::size_t i = 0; i <= j; ++i) {
      A(i, j) = A(j, i) = i == j ? column[i] + object.inverse_mass : column[i];
    }
  }
  const Vector3<Scalar> w = transposed_times(held.R, held.w);
  const Vector3<Scalar>& h = object.center;
  const TreeInertia<Scalar>& I = object.inertia;
  // J w about the centre of mass: J_o w - m c x (w x c) is written as J_o w + h x (c x w).
  const Vector3<Scalar> spin = I.J * w + cross(I.h, cross(h, w));
  const Vector3<Scalar> wd = held.R * (-(object.central_inverse * cross(w, spin)));
  const Vector3<Scalar> a = tree.gravity + cross(c, wd) - cross(held.w, cross(held.w, c));
  append(a, result.acceleration);
  append(wd, result.acceleration);
  return result;
}

/// Accelerations of the objects and forces of the grasps, at the objects' origins in world axes.
template <class Scalar>
struct GraspForces {
  std::vector<Scalar> xdd_object, f;
};

/// Solves one system for the forces, the Schur complement: (Lambda_e^-1 + C Lambda_obj^-1 C^T) f =
/// xdd_o - C x_free. Also valid if hands depend on each other.
template <class Scalar>
GraspForces<Scalar> solve_grasp_forces(const std::vector<FreeObject<Scalar>>& free,
                                       const std::vector<std::size_t>& object_of_row,
                                       DenseMatrix<Scalar> A, const std::vector<Scalar>& xdd_o,
                                       const PivotRule& rule) {
  const std::size_t rows = xdd_o.size();
  std::vector<Scalar> difference = xdd_o;
  for (std::size_t i = 0; i < rows; ++i) {
    const FreeObject<Scalar>& object = free[object_of_row[i]];
    difference[i] = difference[i] - object.acceleration[i % 6];
    for (std::size_t j = 0; j <= i; ++j) {
      if (object_of_row[j] == object_of_row[i]) {
        A(i, j) = A(i, j) + object.inverse_Lambda(i % 6, j % 6);
      }
    }
  }
  GraspForces<Scalar> result;
  result.f = solve(factor_ldlt(A, rule), difference);
  for (std::size_t k = 0; k < free.size(); ++k) {
    std::vector<Scalar> F(6, Scalar(0.0));
    for (std::size_t i = 0; i < rows; ++i) {
      if (object_of_row[i] == k) {
        F[i % 6] = F[i % 6] + result.f[i];
      }
    }
    const std::vector<Scalar> gained = free[k].inverse_Lambda * F;
    for (std::size_t i = 0; i < 6; ++i) {
      result.xdd_object.push_back(free[k].acceleration[i] + gained[i]);
    }
  }
  return result;
}

template <class Scalar>
GraspForces<Scalar> grasp_forces(const Tree<Scalar>& tree,
                                 const std::vector<TreeObject<Scalar>>& objects,
                                 const HeldObjects<Scalar>& state,
                                 const DenseMatrix<Scalar>& Lambda_inv,
                                 const std::vector<Scalar>& xdd_o, const PivotRule& rule) {
  std::vector<FreeObject<Scalar>> free;
  std::vector<std::size_t> object_of_row;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    free.push_back(free_object(tree, objects[k], state.held[k].front()));
    object_of_row.insert(object_of_row.end(), 6 * objects[k].grasps.size(), k);
  }
  return solve_grasp_forces(free, object_of_row, Lambda_inv, xdd_o, rule);
}

/// Results of `object_forward_dynamics`.
template <class Scalar>
struct ClosedChainMotion {
  std::vector<Scalar> qdd, xdd_object, f_grasp, internal;
};

/// Moves forces from the objects' origins to the hands' points, and computes the internal forces
/// that the virtual linkage defines.
template <class Scalar>
void report_grasps(const std::vector<TreeObject<Scalar>>& objects, const HeldObjects<Scalar>& state,
                   const std::vector<Scalar>& f, ClosedChainMotion<Scalar>& motion) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    std::vector<Scalar> in_object;
    for (std::size_t i = 0; i < objects[k].grasps.size(); ++i) {
      const Matrix3<Scalar>& R = state.held[k][i].R;
      const Vector3<Scalar> force{f[at], f[at + 1], f[at + 2]};
      const Vector3<Scalar> arm = R * objects[k].grasps[i].r;
      const Vector3<Scalar> moment =
          Vector3<Scalar>{f[at + 3], f[at + 4], f[at + 5]} - cross(arm, force);
      append(force, motion.f_grasp);
      append(moment, motion.f_grasp);
      append(transposed_times(R, force), in_object);
      append(transposed_times(R, moment), in_object);
      at += 6;
    }
    const std::vector<Scalar> internal = objects[k].read * in_object;
    motion.internal.insert(motion.internal.end(), internal.begin(), internal.end());
  }
}

template <class Scalar>
struct ObjectDynamicsInputs {
  std::span<const Scalar> qd, tau;
  std::span<const Scalar> stabilisation;  ///< damping 1/s, stiffness 1/s^2
};

/// Chang table 7.2 with Baumgarte's stabilisation. `solve_for_qdd` maps joint forces to
/// accelerations (A^-1). `tree` must come from `holding_tree`. `rule` inverts the pivots of
/// the system for the grasps' forces.
template <class Scalar, class Solve>
ClosedChainMotion<Scalar> object_forward_dynamics(
    const Tree<Scalar>& tree, const std::vector<TreeObject<Scalar>>& objects,
    const std::vector<JointTransform<Scalar>>& X, const ObjectDynamicsInputs<Scalar>& inputs,
    const LambdaChoice& choice, const Solve& solve_for_qdd, const PivotRule& rule = {}) {
  std::vector<Scalar> net = inverse_dynamics<Scalar>(tree, X, {inputs.qd, {}}, {});
  for (std::size_t i = 0; i < net.size(); ++i) {
    net[i] = inputs.tau[i] - net[i];
  }
  ClosedChainMotion<Scalar> motion;
  motion.qdd = solve_for_qdd(net);
  const auto tasks = task_points(tree, {}, world_poses(tree, X));
  const auto links = outward_motion<Scalar>(tree, X, {inputs.qd, motion.qdd}, Vector3<Scalar>{});
  std::vector<Scalar> xdd_o = row_accelerations(tree, X, tasks, links, inputs.qd);
  const auto state = held_objects(tree, objects, X, inputs.qd, inputs.stabilisation);
  for (std::size_t i = 0; i < xdd_o.size(); ++i) {
    xdd_o[i] = xdd_o[i] - state.corrections[i];
  }
  const auto forces = grasp_forces(
      tree, objects, state, lambda_inverse_as_asked(tree, X, choice, xdd_o.size()), xdd_o, rule);
  const auto change = solve_for_qdd(forces_of_rows(tree, X, tasks, forces.f));
  for (std::size_t i = 0; i < change.size(); ++i) {
    motion.qdd[i] = motion.qdd[i] - change[i];  // the objects push back
  }
  motion.xdd_object = forces.xdd_object;
  report_grasps(objects, state, forces.f, motion);
  return motion;
}

}  // namespace treeline
