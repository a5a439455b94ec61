#pragma once

#include "interpreter/control_torque.hpp"
#include "interpreter/virtual_linkage.hpp"

namespace treeline::interpreter {

namespace detail {

/// f_t = W^-1 [F_obj; F_int] for all grasps of all objects: the force of each hand on its object,
/// at the object's origin according to that hand, world axes.
template <class Scalar>
std::vector<std::vector<Vector6<Scalar>>> commanded_grasp_forces(
    const ClosedChain<Scalar>& chain, const std::vector<std::vector<HeldPose<Scalar>>>& poses,
    VectorArg<Scalar> xdd_cmd, VectorArg<Scalar> internal) {
  std::vector<std::vector<Vector6<Scalar>>> forces;
  int next = 0;
  for (std::size_t k = 0; k < chain.objects.size(); ++k) {
    const auto& object = chain.objects[k];
    const auto& first = poses[k].front();
    const auto bias = object_bias(object, first, chain.robots.front().gravity);
    const Vector6<Scalar> F =
        object_inertia(object, first.R) *
            Vector6<Scalar>(xdd_cmd.template segment<6>(6 * static_cast<int>(k))) +
        bias.mu + bias.p;
    const int count = internal_force_count(static_cast<int>(object.grasps.size()));
    const Vector<Scalar> split = split_over_grasps<Scalar>(
        object, stack<Scalar>(first.R.transpose() * linear(F), first.R.transpose() * angular(F)),
        internal.segment(next, count));
    next += count;
    forces.emplace_back();
    for (std::size_t i = 0; i < object.grasps.size(); ++i) {
      const Vector6<Scalar> own = split.template segment<6>(6 * static_cast<int>(i));
      forces.back().push_back(force_transform(poses[k][i].R, Vector3<Scalar>::Zero().eval()) * own);
      forces.back().back().template tail<3>() +=
          cross<Scalar>(poses[k][i].to_hand, linear(forces.back().back()));
    }
  }
  return forces;
}

/// The forces of one robot's hands, in the order of `object_points`.
template <class Scalar>
Vector<Scalar> of_robot(const ClosedChain<Scalar>& chain, int robot,
                        const std::vector<std::vector<Vector6<Scalar>>>& forces) {
  Vector<Scalar> own(0);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    for (std::size_t i = 0; i < forces[k].size(); ++i) {
      if (chain.objects[k].grasps[i].robot != robot) continue;
      own.conservativeResize(own.size() + 6);
      own.template tail<6>() = forces[k][i];
    }
  }
  return own;
}

}  // namespace detail

/// Joint forces of all robots that accelerate the objects by `xdd_cmd` (six per object:
/// conventional acceleration of its origin over angular acceleration, world axes) and apply the
/// internal forces `internal` (see `virtual_linkage.hpp`), while `qdd_0` acts in the null space
/// (Chang table 7.1): f_t = W^-1 [Lambda_obj xdd + mu_obj + p_obj; F_int], f = Lambda_e (C xdd - Jd
/// qd - J qdd_0) + f_t, tau = RNEA(q, qd, qdd_0) + J^T f. `law` relaxes rows of the hands of one
/// robot.
template <class Scalar>
PerRobot<Scalar> object_control_torque(const ClosedChain<Scalar>& chain, PerRobotArg<Scalar> q,
                                       PerRobotArg<Scalar> qd, PerRobotArg<Scalar> qdd_0,
                                       VectorArg<Scalar> xdd_cmd, VectorArg<Scalar> internal,
                                       const TaskLaw<Scalar>& law = {}) {
  const auto poses = held_poses<Scalar>(chain, q, qd);
  const auto forces = detail::commanded_grasp_forces<Scalar>(chain, poses, xdd_cmd, internal);
  PerRobot<Scalar> tau;
  for (std::size_t r = 0; r < chain.robots.size(); ++r) {
    const int robot = static_cast<int>(r);
    const auto points = object_points(chain, robot);
    Vector<Scalar> f(0);
    if (!points.empty()) {
      const Vector<Scalar> wanted = connectivity(chain, robot) * xdd_cmd;
      f = (law.borders.empty()
               ? task_force<Scalar>(chain.robots[r], points, q[r], qd[r], qdd_0[r], wanted)
               : task_force<Scalar>(chain.robots[r], points, q[r], qd[r], qdd_0[r], wanted, law)) +
          detail::of_robot(chain, robot, forces);
    }
    tau.push_back(inverse_dynamics<Scalar>(chain.robots[r], q[r], qd[r], qdd_0[r], points, -f));
  }
  return tau;
}

}  // namespace treeline::interpreter
