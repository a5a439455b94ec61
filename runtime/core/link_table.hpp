#pragma once
// A robot as a table of its links, over which the recursions of rigid-body dynamics loop. C++17,
// freestanding, no heap, no branch on anything but the table: a robot's functions take the same
// instructions for every input.
//
// This is small code: `optimize: size`. Straight lines are several times as fast, since they leave
// out what is zero. Frames, units and the order of joints are those of the generated code.

#include <stdint.h>

#include "core/link_vectors.hpp"

namespace treeline::core::loops {

/// Inertial parameters of a link, in its frame.
template <class Real>
struct LinkBody {
  Real mass;
  Real h[3];  ///< first moment
  Real J[6];  ///< rotational inertia about the frame's origin: xx xy xz yy yz zz
};

/// A link, and the joint that moves it along or about the z axis of its frame, whose pose in the
/// parent is the translation by `p`, Rz(a) Rx(alpha) Rz(b), and the joint's motion.
template <class Real>
struct Link {
  int16_t parent;  ///< -1: the world
  int16_t slot;    ///< how many of the links that carry it carry several
  int16_t end;     ///< it carries the links from the next to before this one
  bool slides;     ///< a prismatic joint
  bool starts;     ///< a limb: the links behind it, up to the next of this kind, are placed from it
  Turn<Real> a;
  Turn<Real> alpha;
  Turn<Real> b;
  Real p[3];   ///< in the parent's axes
  Real rotor;  ///< inertia that the joint alone feels
  LinkBody<Real> body;
};

/// An operational point.
template <class Real>
struct LinkPoint {
  int16_t link;
  bool world;    ///< axes of the world; else `axes`
  Real axes[9];  ///< row-major; a row is an axis, in the link's axes
  Real p[3];     ///< in the link's axes
};

/// A row of the task: an operational point's motion along an axis, or its rotation about it.
struct PointRow {
  int16_t point;
  int16_t axis;
  bool angular;
};

/// Viscous friction and spring of a joint.
template <class Real>
struct LinkDrive {
  Real damping;
  Real stiffness;
  Real rest;  ///< coordinate at which the spring is slack
};

/// Coulomb friction of a joint: `force` times the smooth sign of `sharpness` times the velocity.
template <class Real>
struct LinkFriction {
  Real force;
  Real sharpness;
};

/// A joint that moves by `multiplier` times the coordinate of joint `joint`, which may be its own.
template <class Real>
struct LinkCoupling {
  int16_t joint;  ///< of those that have coordinates of their own, a floating base among them
  Real multiplier;
  bool spins;     ///< a rotor, symmetric about its axis: how far it has turned does not matter
  bool own_sine;  ///< its angle has a sine other than plus or minus that of the coordinate
};

/// A joint of three axes about one point, whose links are three: the first turns by the quaternion
/// of the joint, the others only make its next axis the z axis. So do the six of a joint that moves
/// freely: three slide along its axes, three turn about them, and the first is where the last is.
struct LinkBall {
  int16_t axis;      ///< which of them the link has: from 1 on; 0: another joint
  int16_t rotation;  ///< of the first: where its rotation is
  int16_t q;         ///< where the coordinates of a joint of any kind begin
};

/// A rotation, row-major: of a floating base's axes to the world's, of a ball joint's link's to its
/// parent's, or of a frame's to its link's.
template <class Real>
struct LinkRotation {
  Real Q[9];
};

/// A frame of a link, in which an argument is given.
template <class Real>
struct InputFrame {
  int16_t of;  ///< a body of `LinkTable::bodies`, or an operational point
  int16_t at;  ///< its first entry in the argument
  LinkRotation<Real> R;
  Real p[3];  ///< the frame's origin, in the link's axes
};

/// A number of an argument that a joint has.
struct InputNumber {
  int16_t of;  ///< the link of the joint
  int16_t at;  ///< its entry in the argument; -1: it is 0
};

/// The robot. `floats`: the first link moves freely, and has seven coordinates and six velocities;
/// each other joint has one. `sliding`: there are prismatic joints. `driven`: there may be drives,
/// `rubbing`: Coulomb friction. `coupled`: joints share coordinates. `own_sines`: some
/// turn by multiples of these. `balls`: there are ball joints. `pushed`: external forces are an
/// argument. `loaded`: inertial parameters of links depend on arguments. `sorted`: rows of points
/// stand in the order of priority, which is not that of arguments and results. `stepped`: friction
/// and springs may be those at the end of a step, or rotors are an argument. `grounded`: points are
/// on the world. `freed`: joints beyond the base move freely. `turning`: linear rows of points are
/// along axes that turn with their links.
template <class Number, bool floats, bool sliding, bool driven = false, bool rubbing = false,
          bool coupled = false, bool own_sines = false, bool balls = false, bool pushed = false,
          bool loaded = false, bool sorted = false, bool stepped = false, bool grounded = false,
          bool freed = false, bool turning = false>
struct LinkTable {
  using Real = Number;
  static constexpr bool kFloats = floats;
  static constexpr bool kSliding = sliding;
  static constexpr bool kDriven = driven;
  static constexpr bool kRubbing = rubbing;
  static constexpr bool kCoupled = coupled;
  static constexpr bool kOwnSines = own_sines;
  static constexpr bool kBalls = balls;
  static constexpr bool kPushed = pushed;
  static constexpr bool kLoaded = loaded;
  static constexpr bool kSorted = sorted;
  static constexpr bool kStepped = stepped;
  static constexpr bool kGrounded = grounded;
  static constexpr bool kFreed = freed;
  static constexpr bool kTurning = turning;

  const Link<Real>* links;
  int count;
  int slots;  ///< the largest of the links, and one more
  Real gravity[3];
  const LinkPoint<Real>* points = nullptr;
  int point_count = 0;
  const PointRow* point_rows = nullptr;
  int rows = 0;
  // Of all links; none: no joint has any.
  const LinkDrive<Real>* drives = nullptr;
  const LinkFriction<Real>* frictions = nullptr;
  const LinkCoupling<Real>* couplings = nullptr;  ///< of all links; none: each joint is its own
  int joints = 0;  ///< that have coordinates of their own, where there are couplings
  const LinkBall* ball_axes = nullptr;   ///< of all links; none: there are no ball joints
  const int16_t* row_entries = nullptr;  ///< of all rows; none: rows stand as in arguments
  const LinkPoint<Real>* pushed_points = nullptr;
  int pushed_count = 0;
  const Real* f_ext = nullptr;             ///< force and moment at each of these; none: 0
  const LinkBody<Real>* bodies = nullptr;  ///< of `loaded_links`, in place of those in `links`
  const int16_t* loaded_links = nullptr;
  int loaded_count = 0;
  const Real* rotors = nullptr;  ///< of all links; none: those in `links`
  const Real* step = nullptr;    ///< in s, at whose end springs are taken; none: at its beginning
};

/// The inertial parameters of link `i`.
template <class Table, class Real = typename Table::Real>
const LinkBody<Real>& body_of(const Table& table, int i) noexcept {
  const LinkBody<Real>* body = &table.links[i].body;
  if constexpr (Table::kLoaded) {
    for (int k = 0; k < table.loaded_count; ++k) {
      if (table.loaded_links[k] == i) {
        body = &table.bodies[k];
      }
    }
  }
  return *body;
}

/// Whose coordinate the joint of link `i` has, counted without joints that share those of others.
template <class Table>
constexpr int joint_of(const Table& table, int i) noexcept {
  if constexpr (Table::kCoupled) {
    return table.couplings[i].joint;
  } else {
    static_cast<void>(table);
    return i;
  }
}

/// Joints that have coordinates of their own, a floating base among them.
template <class Table>
constexpr int count_joints(const Table& table) noexcept {
  if constexpr (Table::kCoupled) {
    return table.joints;
  } else {
    return table.count;
  }
}

/// What the joint of link `i` makes of its coordinate, or the coordinate of a force along it.
template <class Table, class Real>
Real scale(const Table& table, int i, const Real& value) noexcept {
  if constexpr (Table::kCoupled) {
    return table.couplings[i].multiplier * value;
  } else {
    static_cast<void>(table);
    static_cast<void>(i);
    return value;
  }
}

/// Puts `value` in its place, or adds it where joints share that.
template <class Table, class Real>
void enter(const Real& value, Real& place) noexcept {
  if constexpr (Table::kCoupled) {
    place = place + value;
  } else {
    place = value;
  }
}

/// The inertia that the joint of link `i` alone feels.
template <class Table, class Real = typename Table::Real>
Real rotor_of(const Table& table, int i) noexcept {
  Real rotor = table.links[i].rotor;
  if constexpr (Table::kStepped) {
    if (table.rotors != nullptr) {
      rotor = table.rotors[i];
    }
  }
  return rotor;
}

/// Where row `r` of the points has its numbers in arguments and results.
template <class Table>
constexpr int entry_of(const Table& table, int r) noexcept {
  if constexpr (Table::kSorted) {
    return table.row_entries[r];
  } else {
    static_cast<void>(table);
    return r;
  }
}

/// Where joint `i` has its velocity.
template <class Table>
constexpr int velocity_at(int i) noexcept {
  if constexpr (Table::kFloats) {
    int at = i;
    if (i > 0) {
      at = i + 5;
    }
    return at;
  } else {
    return i;
  }
}

/// Where the joint of link `i` has its coordinate.
template <class Table>
constexpr int coordinate_of(const Table& table, int i) noexcept {
  int at = velocity_at<Table>(joint_of(table, i));
  if constexpr (Table::kFloats) {
    if (at > 0) {
      at = at + 1;
    }
  }
  if constexpr (Table::kBalls) {
    at = table.ball_axes[i].q;
  }
  return at;
}

/// Which axis of a ball joint link `i` has: 0 if none.
template <class Table>
constexpr int ball_axis(const Table& table, int i) noexcept {
  if constexpr (Table::kBalls) {
    return table.ball_axes[i].axis;
  } else {
    static_cast<void>(table);
    static_cast<void>(i);
    return 0;
  }
}

/// Whether link `i` is a floating base.
template <class Table>
constexpr bool is_floating(int i) noexcept {
  if constexpr (Table::kFloats) {
    return i == 0;
  } else {
    static_cast<void>(i);
    return false;
  }
}

/// Whether what has this number for its link is on the world.
template <class Table>
constexpr bool is_on_world(int link) noexcept {
  if constexpr (Table::kGrounded) {
    return link < 0;
  } else {
    static_cast<void>(link);
    return false;
  }
}

/// Whether the joint of link `i` is prismatic.
template <class Table>
constexpr bool slides(const Table& table, int i) noexcept {
  if constexpr (Table::kSliding) {
    return table.links[i].slides;
  } else {
    static_cast<void>(table);
    static_cast<void>(i);
    return false;
  }
}

/// Whether link `i` is the first of a joint beyond the base that moves freely.
template <class Table>
constexpr bool is_freed(const Table& table, int i) noexcept {
  if constexpr (Table::kFreed) {
    return (ball_axis(table, i) == 1) && slides(table, i);
  } else {
    static_cast<void>(table);
    static_cast<void>(i);
    return false;
  }
}

/// Whether link `i` is a rotor, whose angle does not matter.
template <class Table>
constexpr bool spins(const Table& table, int i) noexcept {
  if constexpr (Table::kCoupled) {
    return table.couplings[i].spins;
  } else {
    static_cast<void>(table);
    static_cast<void>(i);
    return false;
  }
}

/// The entry of a wrench or twist along or about the joint's axis.
template <class Table, class Real>
Real& along_joint(const Table& table, int i, Spatial<Real>& spatial) noexcept {
  Real(&half)[3] = slides(table, i) ? spatial.linear : spatial.angular;
  return half[2];
}

}  // namespace treeline::core::loops
