#pragma once
// Inverse dynamics by loops over a table of links: recursive Newton-Euler. C++17, freestanding.

#include "core/link_friction.hpp"
#include "core/link_pose.hpp"

namespace treeline::core::loops {

/// Motion of a link's frame, in its axes. `a` is the acceleration of its origin minus gravity.
template <class Real>
struct LinkMotion {
  Real w[3];
  Real wd[3];
  Real a[3];
};

/// What inverse dynamics keeps of each link, and of the links on the way out.
template <class Real, size_t links, size_t slots, size_t turned = 1>
struct MotionWork {
  LinkPoses<Real, links, turned> poses;
  Spatial<Real> wrenches[links];
  LinkMotion<Real> motions[slots];
};

/// sum += wd x r + w x (w x r)
template <class Real>
TREELINE_LINK_INLINE void add_rotation(const LinkMotion<Real>& motion, const Real (&r)[3],
                                       Real (&sum)[3]) noexcept {
  Real speed[3];
  find_cross(motion.w, r, speed);
  add_cross(motion.wd, r, sum);
  add_cross(motion.w, speed, sum);
}

/// product = M v of a symmetric M: xx xy xz yy yz zz
template <class Real>
TREELINE_LINK_INLINE void multiply_symmetric(const Real (&M)[6], const Real (&v)[3],
                                             Real (&product)[3]) noexcept {
  product[0] = (M[0] * v[0]) + (M[1] * v[1]) + (M[2] * v[2]);
  product[1] = (M[1] * v[0]) + (M[3] * v[1]) + (M[4] * v[2]);
  product[2] = (M[2] * v[0]) + (M[4] * v[1]) + (M[5] * v[2]);
}

template <class Real>
TREELINE_LINK_INLINE void copy(const LinkMotion<Real>& from, LinkMotion<Real>& to) noexcept {
  to.w[0] = from.w[0];
  to.w[1] = from.w[1];
  to.w[2] = from.w[2];
  to.wd[0] = from.wd[0];
  to.wd[1] = from.wd[1];
  to.wd[2] = from.wd[2];
  to.a[0] = from.a[0];
  to.a[1] = from.a[1];
  to.a[2] = from.a[2];
}

/// The motion of a fixed base.
template <class Table, class Real>
void rest(const Table& table, LinkMotion<Real>& motion) noexcept {
  for (int k = 0; k < 3; ++k) {
    motion.w[k] = Real(0.0);
    motion.wd[k] = Real(0.0);
    motion.a[k] = -table.gravity[k];
  }
}

/// An entry of an argument that may be missing: then it is 0.
template <class Real>
Real entry(const Real* argument, int i) noexcept {
  return (argument == nullptr) ? Real(0.0) : argument[i];
}

/// Adds the rate at which a link turns the axes of the ball joint that it carries, where the first
/// of these is the joint's: w x (qd about its three axes).
template <class Real>
void turn_ball_axes(const Real* qd, int at, LinkMotion<Real>& motion) noexcept {
  const Real rate[3] = {entry(qd, at + 1), entry(qd, at + 2), entry(qd, at)};
  add_cross(motion.w, rate, motion.wd);
}

/// Adds the rate at which a link turns the velocity of a joint that moves freely: (2 w + the
/// joint's angular velocity) x v.
template <class Real>
void turn_free_axes(const Real* qd, int at, LinkMotion<Real>& motion) noexcept {
  const Real v[3] = {entry(qd, at + 1), entry(qd, at + 2), entry(qd, at)};
  Real w[3] = {entry(qd, at + 4), entry(qd, at + 5), entry(qd, at + 3)};
  for (int k = 0; k < 3; ++k) {
    w[k] = w[k] + (Real(2.0) * motion.w[k]);
  }
  add_cross(w, v, motion.a);
}

/// Adds what the velocity of joint `i`, whose axis its parent turns, adds: w x S qd, or twice that
/// where it slides.
template <class Table, class Real>
void turn_joint_axis(const Table& table, int i, const Real& qd, LinkMotion<Real>& motion) noexcept {
  const bool along = slides(table, i);
  Real(&moved)[3] = along ? motion.a : motion.wd;
  Real rate = qd;
  if (along) {
    rate = Real(2.0) * qd;
  }
  moved[0] = moved[0] + (motion.w[1] * rate);
  moved[1] = moved[1] - (motion.w[0] * rate);
}

/// Makes the motion of its parent that of link `i` behind its joint.
template <class Table, class Poses, class Real>
TREELINE_LINK_INLINE void move_link(const Table& table, int i, const Poses& poses, const Real* qd,
                                    const Real* qdd, LinkMotion<Real>& motion) noexcept {
  Real p[3];
  find_origin(table, i, poses, p);
  add_rotation(motion, p, motion.a);
  turn_axes_to_link(table, i, poses, motion.w, motion.wd, motion.a);
  const int at = velocity_at<Table>(joint_of(table, i));
  const Real rate = scale(table, i, entry(qd, at));
  if (turns_freely(table, i)) {
    int angular = at;
    if (is_freed(table, i)) {
      turn_free_axes(qd, at, motion);
      angular = at + 3;
    }
    turn_ball_axes(qd, angular, motion);
  }
  if (ball_axis(table, i) == 0) {
    turn_joint_axis(table, i, rate, motion);
  }
  const bool along = slides(table, i);
  Real(&moved)[3] = along ? motion.a : motion.wd;
  moved[2] = moved[2] + scale(table, i, entry(qdd, at));
  if (!along) {
    motion.w[2] = motion.w[2] + rate;
  }
}

template <class Table, class Real>
void move_base(const Table& table, const LinkRotation<Real>& base, const Real* qd, const Real* qdd,
               LinkMotion<Real>& motion) noexcept {
  const Real* const Q = &base.Q[0];
  Real v[3];
  for (int k = 0; k < 3; ++k) {
    v[k] = entry(qd, k);
    motion.w[k] = entry(qd, k + 3);
    motion.wd[k] = entry(qdd, k + 3);
    motion.a[k] = entry(qdd, k) - ((Q[k] * table.gravity[0]) + (Q[3 + k] * table.gravity[1]) +
                                   (Q[6 + k] * table.gravity[2]));
  }
  add_cross(motion.w, v, motion.a);
}

/// Rate of change of a link's momentum: f = m a + wd x h + w x (w x h), n = J wd + w x J w + h x a.
/// It is found in a copy, of which a compiler knows that it is none of the others.
template <class Real>
TREELINE_LINK_INLINE void find_wrench(const LinkBody<Real>& body, const LinkMotion<Real>& motion,
                                      Spatial<Real>& wrench) noexcept {
  Spatial<Real> rate;
  Real momentum[3];
  multiply_symmetric(body.J, motion.w, momentum);
  multiply_symmetric(body.J, motion.wd, rate.angular);
  rate.linear[0] = body.mass * motion.a[0];
  rate.linear[1] = body.mass * motion.a[1];
  rate.linear[2] = body.mass * motion.a[2];
  add_rotation(motion, body.h, rate.linear);
  add_cross(motion.w, momentum, rate.angular);
  add_cross(body.h, motion.a, rate.angular);
  copy_spatial(rate, wrench);
}

/// Motions of the table's points on the world.
template <class Table, class Real>
void rest_points(const Table& table, LinkMotion<Real>* point_motions) noexcept {
  if constexpr (Table::kGrounded) {
    for (int k = 0; k < table.point_count; ++k) {
      if (is_on_world<Table>(table.points[k].link)) {
        rest(table, point_motions[k]);
      }
    }
  } else {
    static_cast<void>(table);
    static_cast<void>(point_motions);
  }
}

/// Outward pass: wrenches that move the links, and motions of the table's points. Without qd or qdd
/// these are 0.
template <class Table, class Real, class Motions>
void move_links(const Table& table, const Real* qd, const Real* qdd, Motions& motions,
                LinkMotion<Real>* point_motions) noexcept {
  rest_points(table, point_motions);
  for (int i = 0; i < table.count; ++i) {
    const Link<Real>& link = table.links[i];
    LinkMotion<Real> motion;
    if (is_floating<Table>(i)) {
      move_base(table, motions.poses.rotations[0], qd, qdd, motion);
    } else {
      if (link.parent < 0) {
        rest(table, motion);
      } else {
        copy(motions.motions[table.links[link.parent].slot], motion);
      }
      move_link(table, i, motions.poses, qd, qdd, motion);
    }
    find_wrench(body_of(table, i), motion, motions.wrenches[i]);
    copy(motion, motions.motions[link.slot]);
    for (int k = 0; k < table.point_count; ++k) {
      if (table.points[k].link == i) {
        copy(motion, point_motions[k]);
      }
    }
  }
}

/// Adds what viscous friction and the spring of a joint take.
template <class Table, class Real>
void add_drive(const Table& table, int i, const Real& q, const Real& qd, Real& tau) noexcept {
  if (table.drives != nullptr) {
    const LinkDrive<Real>& drive = table.drives[i];
    Real away = q - drive.rest;
    if constexpr (Table::kStepped) {
      if (table.step != nullptr) {
        away = away + (table.step[0] * qd);
      }
    }
    tau = tau + (drive.damping * qd) + (drive.stiffness * away);
  }
}

/// Adds what the Coulomb friction of a joint takes.
template <class Table, class Real>
void add_friction(const Table& table, int i, const Real& qd, Real& tau) noexcept {
  if (table.frictions != nullptr) {
    const LinkFriction<Real>& friction = table.frictions[i];
    tau = tau + (friction.force * friction_sign<Real>(friction.sharpness * qd));
  }
}

/// D + step K of joint `i`, whose velocity is `qd`: D is the derivative of its friction, K its
/// stiffness.
template <class Table, class Real>
Real drive_slope(const Table& table, int i, const Real& step, const Real& qd) noexcept {
  Real slope = Real(0.0);
  if constexpr (Table::kDriven) {
    if (table.drives != nullptr) {
      const LinkDrive<Real>& drive = table.drives[i];
      slope = drive.damping + (step * drive.stiffness);
    }
  } else {
    static_cast<void>(step);
  }
  if constexpr (Table::kRubbing) {
    if (table.frictions != nullptr) {
      const LinkFriction<Real>& friction = table.frictions[i];
      slope = slope + ((friction.force * friction.sharpness) *
                       friction_slope<Real>(friction.sharpness * qd));
    }
  } else {
    static_cast<void>(table);
    static_cast<void>(i);
    static_cast<void>(qd);
  }
  return slope;
}

/// The inertias of joints that make friction and springs those at the end of the table's step:
/// rotor + step D + step^2 K. They may take the place of those that an argument gives.
template <class Table, class Real>
void find_rotors(const Table& table, const Real* qd, Real* rotors) noexcept {
  const Real step = table.step[0];
  for (int i = 0; i < table.count; ++i) {
    const Real speed = entry(qd, velocity_at<Table>(joint_of(table, i)));
    rotors[i] = rotor_of(table, i) + (step * drive_slope(table, i, step, speed));
  }
}

/// Clears what joints add to.
template <class Table, class Real>
void clear_shared(const Table& table, Real* tau) noexcept {
  if constexpr (Table::kCoupled) {
    for (int k = 0; k < velocity_at<Table>(table.joints); ++k) {
      tau[k] = Real(0.0);
    }
  } else {
    static_cast<void>(table);
    static_cast<void>(tau);
  }
}

/// Inward pass: joint forces of the wrenches on links, which become those on what links carry.
template <class Table, class Real, class Motions>
TREELINE_LINK_SHARED void gather_forces(const Table& table, const Real* q, const Real* qd,
                                        const Real* qdd, Motions& motions, Real* tau) noexcept {
  clear_shared(table, tau);
  for (int i = table.count - 1; i >= 0; --i) {
    const Link<Real>& link = table.links[i];
    Spatial<Real> wrench;
    copy_spatial(motions.wrenches[i], wrench);
    if (is_floating<Table>(i)) {
      for (int k = 0; k < 3; ++k) {
        tau[k] = wrench.linear[k];
        tau[k + 3] = wrench.angular[k];
      }
    } else {
      const int at = velocity_at<Table>(joint_of(table, i));
      const Real force = scale(table, i, along_joint(table, i, wrench));
      enter<Table>(force + (rotor_of(table, i) * entry(qdd, at)), tau[at]);
      if constexpr (Table::kDriven) {
        add_drive(table, i, q[coordinate_of(table, i)], entry(qd, at), tau[at]);
      } else {
        static_cast<void>(q);
        static_cast<void>(qd);
      }
      if constexpr (Table::kRubbing) {
        add_friction(table, i, entry(qd, at), tau[at]);
      }
      if (link.parent >= 0) {
        wrench_to_parent(table, i, motions.poses, wrench);
        add(wrench, motions.wrenches[link.parent]);
      }
    }
  }
}

}  // namespace treeline::core::loops
