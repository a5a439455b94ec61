#pragma once
// Poses of the links of a table: what their joints' coordinates make of them. C++17, freestanding.

#include <stddef.h>

#include "core/link_table.hpp"
#include "core/sin_cos.hpp"

namespace treeline::core::loops {

/// What a joint's coordinate makes of a link's pose.
template <class Real>
struct LinkPose {
  Turn<Real> turn;  ///< Rz(b) and the joint's angle
  Real slide;       ///< along the z axis of the placement, of prismatic joints
};

template <class Real, size_t links, size_t turned>
struct LinkPoses {
  LinkPose<Real> joints[links];
  LinkRotation<Real> rotations[turned];  ///< that of a floating base is the first
};

/// The rotations of a link about axes of coordinates, from its own axes to its parent's. Numbers
/// that are turned may be those of the table for all that a compiler knows: it reads these once.
template <class Real>
struct LinkTurns {
  Turn<Real> joint;
  Turn<Real> alpha;
  Turn<Real> a;
};

template <class Real>
TREELINE_LINK_INLINE void find_turns(const Link<Real>& link, const LinkPose<Real>& pose,
                                     LinkTurns<Real>& turns) noexcept {
  turns.joint.c = pose.turn.c;
  turns.joint.s = pose.turn.s;
  turns.alpha.c = link.alpha.c;
  turns.alpha.s = link.alpha.s;
  turns.a.c = link.a.c;
  turns.a.s = link.a.s;
}
template <class Real>
TREELINE_LINK_INLINE void turn_by_planes(const LinkTurns<Real>& turns, Real (&v)[3]) noexcept {
  turn_plane(turns.joint, v[0], v[1]);
  turn_plane(turns.alpha, v[1], v[2]);
  turn_plane(turns.a, v[0], v[1]);
}
template <class Real>
TREELINE_LINK_INLINE void turn_back_by_planes(const LinkTurns<Real>& turns, Real (&v)[3]) noexcept {
  turn_plane_back(turns.a, v[0], v[1]);
  turn_plane_back(turns.alpha, v[1], v[2]);
  turn_plane_back(turns.joint, v[0], v[1]);
}

/// Turns a vector by the rotation of a floating base or of a ball joint.
template <class Real>
void turn_by(const LinkRotation<Real>& rotation, Real (&v)[3]) noexcept {
  const Real old[3] = {v[0], v[1], v[2]};
  for (int k = 0; k < 3; ++k) {
    const Real* const row = &rotation.Q[3 * k];
    v[k] = (row[0] * old[0]) + (row[1] * old[1]) + (row[2] * old[2]);
  }
}
template <class Real>
void turn_back_by(const LinkRotation<Real>& rotation, Real (&v)[3]) noexcept {
  const Real(&Q)[9] = rotation.Q;
  const Real old[3] = {v[0], v[1], v[2]};
  for (int k = 0; k < 3; ++k) {
    v[k] = (Q[k] * old[0]) + (Q[3 + k] * old[1]) + (Q[6 + k] * old[2]);
  }
}

/// Whether link `i` turns by a rotation of `LinkPoses`, not by planes: it has the first axis of a
/// ball joint.
template <class Table>
constexpr bool turns_freely(const Table& table, int i) noexcept {
  return ball_axis(table, i) == 1;
}

template <class Table, class Poses, class Real = typename Table::Real>
const LinkRotation<Real>& rotation_of(const Table& table, int i, const Poses& poses) noexcept {
  return poses.rotations[table.ball_axes[i].rotation];
}

/// Three vectors from a link's axes to its parent's. Not for a floating base.
template <class Table, class Poses, class Real>
void turn_axes_to_parent(const Table& table, int i, const Poses& poses, Real (&x)[3], Real (&y)[3],
                         Real (&z)[3]) noexcept {
  if (turns_freely(table, i)) {
    turn_by(rotation_of(table, i, poses), x);
    turn_by(rotation_of(table, i, poses), y);
    turn_by(rotation_of(table, i, poses), z);
  } else {
    LinkTurns<Real> turns;
    find_turns(table.links[i], poses.joints[i], turns);
    turn_by_planes(turns, x);
    turn_by_planes(turns, y);
    turn_by_planes(turns, z);
  }
}

/// Three vectors from the axes of a link's parent to its own. Not for a floating base.
template <class Table, class Poses, class Real>
void turn_axes_to_link(const Table& table, int i, const Poses& poses, Real (&x)[3], Real (&y)[3],
                       Real (&z)[3]) noexcept {
  if (turns_freely(table, i)) {
    turn_back_by(rotation_of(table, i, poses), x);
    turn_back_by(rotation_of(table, i, poses), y);
    turn_back_by(rotation_of(table, i, poses), z);
  } else {
    LinkTurns<Real> turns;
    find_turns(table.links[i], poses.joints[i], turns);
    turn_back_by_planes(turns, x);
    turn_back_by_planes(turns, y);
    turn_back_by_planes(turns, z);
  }
}

/// Makes of the way along the axis of link `i` that of all three axes, if it is the first of a
/// joint that moves freely, and none, if it is another of these.
template <class Table, class Poses, class Real>
void slide_freely(const Table& table, int i, const Poses& poses, Real (&along)[3]) noexcept {
  if constexpr (Table::kFreed) {
    const int axis = ball_axis(table, i);
    if (axis == 1) {
      along[0] = poses.joints[i + 1].slide;
      along[1] = poses.joints[i + 2].slide;
      turn_plane(table.links[i].b, along[0], along[1]);
    }
    if (axis > 1) {
      along[2] = Real(0.0);
    }
  } else {
    static_cast<void>(table);
    static_cast<void>(i);
    static_cast<void>(poses);
    static_cast<void>(along);
  }
}

/// The origin of link `i` in the axes of its parent.
template <class Table, class Poses, class Real>
void find_origin(const Table& table, int i, const Poses& poses, Real (&p)[3]) noexcept {
  const Link<Real>& link = table.links[i];
  for (int k = 0; k < 3; ++k) {
    p[k] = link.p[k];
  }
  if constexpr (Table::kSliding) {
    if (link.slides) {
      Real along[3];
      clear(along);
      along[2] = poses.joints[i].slide;
      slide_freely(table, i, poses, along);
      turn_plane(link.alpha, along[1], along[2]);
      turn_plane(link.a, along[0], along[1]);
      for (int k = 0; k < 3; ++k) {
        p[k] = p[k] + along[k];
      }
    }
  } else {
    static_cast<void>(poses);
  }
}

/// From a wrench on link `i` to the same on its parent. Not for a floating base.
template <class Table, class Poses, class Real>
TREELINE_LINK_INLINE void wrench_to_parent(const Table& table, int i, const Poses& poses,
                                           Spatial<Real>& wrench) noexcept {
  Real p[3];
  find_origin(table, i, poses, p);
  if (turns_freely(table, i)) {
    turn_by(rotation_of(table, i, poses), wrench.linear);
    turn_by(rotation_of(table, i, poses), wrench.angular);
  } else {
    LinkTurns<Real> turns;
    find_turns(table.links[i], poses.joints[i], turns);
    turn_by_planes(turns, wrench.linear);
    turn_by_planes(turns, wrench.angular);
  }
  add_cross(p, wrench.linear, wrench.angular);
}

/// From a twist of the parent of link `i` to the same of the link before its joint.
template <class Table, class Poses, class Real>
TREELINE_LINK_INLINE void twist_to_child(const Table& table, int i, const Poses& poses,
                                         Spatial<Real>& twist) noexcept {
  Real p[3];
  find_origin(table, i, poses, p);
  add_cross(twist.angular, p, twist.linear);
  if (turns_freely(table, i)) {
    turn_back_by(rotation_of(table, i, poses), twist.linear);
    turn_back_by(rotation_of(table, i, poses), twist.angular);
  } else {
    LinkTurns<Real> turns;
    find_turns(table.links[i], poses.joints[i], turns);
    turn_back_by_planes(turns, twist.linear);
    turn_back_by_planes(turns, twist.angular);
  }
}

/// 2 / |q|^2 of a quaternion of any length, x y z w; of 0 it does not turn.
template <class Real>
Real turn_factor(const Real* v) noexcept {
  const Real square =
      (v[0] * v[0]) + (v[1] * v[1]) + (v[2] * v[2]) + (v[3] * v[3]) + Real(0x1p-100);
  return Real(2.0) / square;
}

/// Column `j` of the rotation by a quaternion, `twice` its `turn_factor`.
template <class Real>
void turn_axis(const Real* v, const Real& twice, int j, Real (&column)[3]) noexcept {
  const int k = (j + 1) % 3;
  const int l = (j + 2) % 3;
  const Real t = twice * v[j];
  const Real tw = twice * v[3];
  column[j] = Real(1.0) - (twice * ((v[k] * v[k]) + (v[l] * v[l])));
  column[k] = (t * v[k]) + (tw * v[l]);
  column[l] = (t * v[l]) - (tw * v[k]);
}

/// The rotation by a quaternion behind the placement of a link.
template <class Real>
void place_rotation(const Link<Real>& link, const Real* v, LinkRotation<Real>& rotation) noexcept {
  const Real twice = turn_factor(v);
  for (int j = 0; j < 3; ++j) {
    Real column[3];
    turn_axis(v, twice, j, column);
    turn_plane(link.b, column[0], column[1]);
    turn_plane(link.alpha, column[1], column[2]);
    turn_plane(link.a, column[0], column[1]);
    for (int m = 0; m < 3; ++m) {
      rotation.Q[(3 * m) + j] = column[m];
    }
  }
}

/// The rotation of a ball joint, whose axes are y z x of its quaternion in those of its first link,
/// and the way that a joint which moves freely takes along the axis of that. The link's own turn is
/// not used.
template <class Table, class Poses, class Real>
void place_ball(const Table& table, int i, const Real* q, Poses& poses) noexcept {
  int at = 0;
  if (is_freed(table, i)) {
    at = 3;
    poses.joints[i].slide = q[0];
  }
  poses.joints[i].turn.c = Real(1.0);
  poses.joints[i].turn.s = Real(0.0);
  const Real v[4] = {q[at + 1], q[at + 2], q[at], q[at + 3]};
  place_rotation(table.links[i], &v[0], poses.rotations[table.ball_axes[i].rotation]);
}

/// Sine and cosine of the angle of joint `i` from those of its coordinate.
template <class Table, class Real>
void take_sines(const Table& table, int i, const Real& angle, const Real& sin_q, const Real& cos_q,
                Turn<Real>& turn) noexcept {
  turn.c = cos_q;
  turn.s = scale(table, i, sin_q);
  if constexpr (Table::kOwnSines) {
    if (table.couplings[i].own_sine) {
      sin_cos(angle, turn.s, turn.c);
    }
  } else {
    static_cast<void>(angle);
  }
}

/// Calls with (table, i, at, angle, turn) give those of joint `i`, which has coordinate `at`:
/// computed.
struct ComputedSines {
  template <class Table, class Real>
  void operator()(const Table&, int, int, const Real& angle, Turn<Real>& turn) const noexcept {
    sin_cos(angle, turn.s, turn.c);
  }
};

/// The same, from arguments of the function.
template <class Real>
struct GivenSines {
  const Real* sin_q;
  const Real* cos_q;
  template <class Table>
  void operator()(const Table& table, int i, int at, const Real& angle,
                  Turn<Real>& turn) const noexcept {
    take_sines(table, i, angle, sin_q[at], cos_q[at], turn);
  }
};

/// The rotation that a coordinate makes.
template <class Table, class Sines, class Real>
void turn_joint(const Table& table, int i, const Sines& sines, const Real& moved,
                Turn<Real>& turn) noexcept {
  const Link<Real>& link = table.links[i];
  if (slides(table, i) || spins(table, i) || (ball_axis(table, i) > 1)) {
    turn.c = link.b.c;
    turn.s = link.b.s;
  } else {
    sines(table, i, coordinate_of(table, i), moved, turn);
    turn_plane(link.b, turn.c, turn.s);
  }
}

/// Poses of all links, by the sines and cosines of the joints' angles.
template <class Table, class Real, class Sines, class Poses>
TREELINE_LINK_SHARED void place_links(const Table& table, const Real* q, const Sines& sines,
                                      Poses& poses) noexcept {
  for (int i = 0; i < table.count; ++i) {
    if (is_floating<Table>(i)) {
      place_rotation(table.links[i], &q[3], poses.rotations[0]);
    } else {
      const int at = coordinate_of(table, i);
      if (turns_freely(table, i)) {
        place_ball(table, i, &q[at], poses);
      } else {
        const Real moved = scale(table, i, q[at]);
        poses.joints[i].slide = moved;
        turn_joint(table, i, sines, moved, poses.joints[i].turn);
      }
    }
  }
}

}  // namespace treeline::core::loops
