#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "description/noise.hpp"
#include "description/scene.hpp"
#include "mechanism/coordinate.hpp"
#include "mechanism/exact.hpp"
#include "mechanism/resolution.hpp"

namespace treeline {

/// Mass, first moment h = m c and second moment Sigma = integral of r r^T dm, about the frame's
/// origin. The rotational inertia is J = tr(Sigma) 1 - Sigma. After regrouping the numbers are
/// base inertial parameters and need not belong to any body.
struct Inertia {
  Exact mass = 0;
  ExactVector3 h = ExactVector3::Zero();
  ExactMatrix3 Sigma = ExactMatrix3::Zero();
};

/// The same matter, seen from the frame in which its own frame has `pose`.
Inertia transformed(const Inertia& inertia, const ExactPose& pose);
Inertia operator+(const Inertia& a, const Inertia& b);
/// J = tr(Sigma) 1 - Sigma.
ExactMatrix3 rotational_inertia(const Inertia& inertia);

/// Joints after reduction: about or along z of the link's frame, or six degrees of freedom.
/// A planar joint is two prismatic ones and a revolute one with massless links between.
enum class JointKind { revolute, prismatic, floating };

/// One degree of freedom (six for `floating`) and the link behind it. The frame of the link in its
/// parent's is `seat` followed by the joint's motion: Rz(angle), Tz(displacement), or
/// (position, quaternion). angle = multiplier * q[q_index] + offset, likewise displacement.
struct MovingLink {
  std::string name;   ///< of the URDF link that moves first behind the joint
  std::string joint;  ///< of the URDF joint
  int parent = -1;    ///< index into Mechanism::links, always smaller than the link's own; -1 world
  JointKind kind = JointKind::revolute;
  ExactPose seat;
  int q_index = 0;  ///< first coordinate
  int v_index = 0;  ///< first velocity
  double multiplier = 1;
  Exact offset = 0;
  bool mimics = false;  ///< shares its coordinate with the joint it mimics
  Inertia inertia;
  /// Of gyration about the frame's origin as the file has it, of all that the link carries; m.
  Exact radius = 0;
  /// How recursions go about this link, see `turn_late` and `outward_motion`: results are the same,
  /// costs are not. Both only for joints of one degree of freedom.
  bool turns_late = false, carries_column = false;
};

/// An operational point or the place of an external force, on a moving link or the world (-1).
struct MechanismPoint {
  std::string name;
  int link = -1;
  ExactPose pose;  ///< of the point's frame in the link's
  Axes axes = Axes::world;
  std::array<bool, 6> rows{true, true, true, true, true, true};
  int priority = 1;  ///< see `ScenePoint`
  [[nodiscard]] int row_count() const;
  [[nodiscard]] bool all_rows() const { return row_count() == 6; }
};

/// A hand on an object: which operational point, and the object's frame seen from it.
struct MechanismGrasp {
  std::size_t point = 0;
  ExactPose object;
};

/// A rigid body that hands hold; its inertia is about its frame's origin, in its axes.
struct MechanismObject {
  std::string name;
  Inertia inertia;
  std::vector<MechanismGrasp> grasps;
};

/// Subtrees of one shape that hang on the same link: arms, legs, fingers. They may run in lanes.
struct LimbFamily {
  std::vector<std::vector<int>> limbs;  ///< of each limb its links, in corresponding order
};

/// What a reduction did, for `inspect` and the manifest.
struct ReductionNote {
  std::string step;  ///< "lump", "seat", "regroup"
  std::string link;
  std::string text;
};

/// The numbered tree that recursions run over: parents before children, in the order of q.
/// Valid once it exists; made by `build_mechanism`, reduced by `seat_frames` and
/// `regroup_inertias`, each of which leaves the equations of motion as they are.
struct Mechanism {
  std::vector<MovingLink> links;
  /// Matter that is fixed to the world, in its frame, and what regrouping moved there: no motion
  /// depends on it, the centre of mass does. Only its mass and first moment mean anything.
  Inertia world;
  std::vector<MechanismPoint> operational_points;
  std::vector<MechanismPoint> external_forces;
  std::vector<MechanismPoint> contacts;  ///< rows x y z in world axes
  /// Of each URDF link that moves against its parent, the frame as the URDF has it.
  std::vector<MechanismPoint> link_frames;
  std::vector<MechanismObject> objects;
  std::array<double, 3> gravity{0, 0, -9.81};
  SingularTasks singular = SingularTasks::smooth;  ///< see `Scene`
  Real real = Real::float64;                       ///< see `Scene`
  std::vector<Coordinate> coordinates;             ///< nq of them
  std::vector<std::string> velocities;             ///< nv of them, e.g. "elbow, rad/s"
  std::vector<ReductionNote> notes;
  std::string file;       ///< of the robot
  Resolution resolution;  ///< of the file's numbers
  NoiseDecisions noise;   ///< what is taken as exact: numbers of files, relations between frames
  /// See `find_limbs`; empty where limbs are not to share lanes.
  std::vector<LimbFamily> limbs;

  [[nodiscard]] int nq() const { return static_cast<int>(coordinates.size()); }
  [[nodiscard]] int nv() const { return static_cast<int>(velocities.size()); }
  [[nodiscard]] int task_rows() const;
  [[nodiscard]] bool has_mimics() const;
};

/// What nearly vanishes against the moments of all that the link carries is as if it were not
/// there, and is written down. See `resolved`.
void resolve_inertia(Mechanism& mechanism, MovingLink& link);

}  // namespace treeline
