#pragma once

#include <array>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "description/active_rows.hpp"
#include "description/noise.hpp"
#include "description/scene.hpp"
#include "joint/joint_step.hpp"
#include "mechanism/coordinate.hpp"
#include "mechanism/digits50_matrices.hpp"
#include "mechanism/resolution.hpp"

namespace treeline {

/// Mass (kg), first moment h = m c (kg m) and second moment Sigma = integral of r r^T dm (kg m^2),
/// about the frame's origin, in its axes. Sigma is the upper-left block of the pseudo-inertia. The
/// rotational inertia is J = tr(Sigma) 1 - Sigma. After regrouping, the numbers are base inertial
/// parameters and need not belong to any body.
struct Inertia {
  Digits50 mass = 0;
  Digits50Vector3 h = Digits50Vector3::Zero();
  Digits50Matrix3 Sigma = Digits50Matrix3::Zero();
};

/// Inertia seen from another frame, in which its own frame has `pose`.
Inertia transformed(const Inertia& inertia, const Digits50Pose& pose);
Inertia operator+(const Inertia& a, const Inertia& b);
/// Rotational inertia J = tr(Sigma) 1 - Sigma about the frame's origin.
Digits50Matrix3 rotational_inertia(const Inertia& inertia);

/// Parts in a joint that belong to no link: the rotor of its motor, friction, a spring. The numbers
/// are those that the joint's coordinate feels, see `add_drives`.
struct JointDrive {
  Digits50 inertia = 0;    ///< of the rotor, kg m^2 or kg
  Digits50 damping = 0;    ///< N m s/rad or N s/m
  Digits50 friction = 0;   ///< the most that Coulomb friction is, N m or N
  Digits50 sharpness = 0;  ///< reciprocal of the speed within which it builds up, s/rad or s/m
  Digits50 stiffness = 0;  ///< N m/rad or N/m
  Digits50 rest = 0;       ///< coordinate at which the spring is slack
};

/// One degree of freedom (six for `floating`) and the link behind it. The pose of the link's frame
/// in its parent is `placement` (RBDA's X_tree) followed by the joint's motion:
/// Rz(angle), Tz(displacement), or (position, quaternion). angle = multiplier * q[q_index] +
/// offset, and likewise the displacement. Joints of several axes are several links, see
/// `JointStep`: a planar joint two that slide and one that turns, a ball joint three that turn.
struct MovingLink : JointStep {
  std::string name;   ///< name of the first URDF link that the joint moves
  std::string joint;  ///< name of the URDF joint
  int parent = -1;    ///< index into Mechanism::links, smaller than the link's own; -1: world
  Digits50Pose placement;
  int q_index = 0;  ///< first coordinate
  int v_index = 0;  ///< first velocity
  double multiplier = 1;
  Digits50 offset = 0;
  bool mimics = false;  ///< shares the coordinate of the joint that it mimics
  /// A rotor of `Scene::rotors`, a leaf without points: its inertia is symmetric about the axis, so
  /// that its frame need not turn.
  bool spins = false;
  JointDrive drive;
  Inertia inertia;
  /// Radius of gyration about the frame's origin as in the file, of everything that the link
  /// carries; m.
  Digits50 radius = 0;
  /// How recursions treat this link, see `defer_rotations` and `outward_motion`. Results are the
  /// same, costs differ. Both only apply to joints of one coordinate.
  bool defers_rotation = false, carries_column = false;
};

/// An operational point, or the place of an external force, on a moving link or on the world (-1),
/// or the centre of mass of all links, as if on the world.
struct MechanismPoint {
  std::string name;
  int link = -1;
  Digits50Pose pose;  ///< pose of the point's frame in the link's frame
  Axes axes = Axes::world;
  std::array<bool, 6> rows{true, true, true, true, true, true};
  int priority = 1;  ///< see `ScenePoint`
  bool center_of_mass = false;
  [[nodiscard]] int row_count() const;
  [[nodiscard]] bool all_rows() const { return row_count() == 6; }
};

/// A hand that holds an object: its operational point, and the pose of the object's frame in that
/// point's frame.
struct MechanismGrasp {
  std::size_t point = 0;
  Digits50Pose object;
};

/// A rigid body that hands hold. Its inertia is about the origin of its frame and in its axes.
struct MechanismObject {
  std::string name;
  Inertia inertia;
  std::vector<MechanismGrasp> grasps;
};

/// Ten inertial parameters that functions take as an argument: those of a payload, or a link's own,
/// in the frame of that link in the URDF.
struct MechanismInertia {
  MechanismPoint frame;  ///< where that frame is now
  Inertia nominal;       ///< what the files say: nothing of a payload
};

/// An operational point or a contact whose origin is an argument, in the frame of its link in the
/// URDF.
struct MechanismTool {
  std::size_t point = 0;
  MechanismPoint frame;       ///< where that frame is now
  Digits50Vector3 nominal{};  ///< what the scene says
  bool orientation = false;   ///< of an operational point: its axes are an argument, too
};

/// Parts of the robot that functions take as arguments, see `SceneInputs`.
struct MechanismInputs {
  bool gravity = false;
  /// Added to the links' inertias, which contain neither.
  std::vector<MechanismInertia> payloads, parameters;
  /// Inertia of each link of `Mechanism::link_frames` with what is fixed to it, if base parameters
  /// are an argument. The links' inertias contain none of it.
  std::vector<MechanismInertia> base;
  std::vector<MechanismTool> tools, contacts;
  ActiveRows active;                      ///< rows of the constraints that come and go
  std::vector<std::size_t> active_tasks;  ///< operational points whose tasks come and go
};

/// A contact that rolls, see `SceneRolling`.
struct MechanismRolling {
  double radius = 0;
  std::optional<Digits50Vector3> axis;  ///< of unit length, in the axes of the first frame
  std::optional<double> on_radius;
};

/// Two frames on links, or on the world, of which rows are held relative to each other: see
/// `SceneLoop`. Rows are those of the second frame.
struct MechanismLoop {
  MechanismPoint first, second;
  std::optional<MechanismRolling> rolling = {};
};

/// A linear relation between coordinates, see `SceneCoupling`.
struct MechanismCoupling {
  struct Part {
    int q_index = 0, v_index = 0;
    double factor = 1;
  };
  std::string name;
  std::vector<Part> parts;
  double offset = 0;
};

/// Isomorphic subtrees on one link: arms, legs, fingers. Their operations may share lanes.
struct LimbFamily {
  std::vector<std::vector<int>> limbs;  ///< links of each limb, in corresponding order
};

/// Record of a reduction, for `inspect` and the manifest.
struct ReductionNote {
  std::string step;  ///< "lump", "place", "regroup"
  std::string link;
  std::string text;
};

struct BaseParameters;

/// The base parameters, once `base_parameters_of` has found them; copies of a mechanism share it.
struct BaseParameterMemo {
  std::mutex mutex;
  SceneRegressor asked;
  std::shared_ptr<const BaseParameters> found;
};

/// The numbered tree on which recursions run: parents before children, in the order of q. Built by
/// `build_mechanism`; reduced by `place_frames` and `regroup_inertias`, which leave the equations
/// of motion unchanged.
struct Mechanism {
  std::vector<MovingLink> links;
  /// Matter that is fixed to the world, in the world frame, including what regrouping moved there.
  /// The centre of mass depends on it, but no motion does. Only mass and first moment are
  /// meaningful.
  Inertia world;
  std::vector<MechanismPoint> operational_points;
  std::vector<MechanismPoint> external_forces;
  std::vector<MechanismPoint> contacts;     ///< their rows are x y z in world axes
  std::vector<MechanismPoint> constraints;  ///< their rows are held relative to the world
  std::vector<MechanismLoop> loops;
  std::vector<MechanismCoupling> couplings;
  std::vector<int> passive;  ///< velocities without a motor, in ascending order
  /// Frame of each URDF link that moves relative to its parent, as the URDF defines it.
  std::vector<MechanismPoint> link_frames;
  /// Matter of each link of `link_frames` and of what is fixed to it, as in the file, in its frame.
  std::vector<Inertia> link_matter;
  /// Frames of the URDF's links to which regressors add a body, see `SceneRegressor::payloads`.
  std::vector<MechanismPoint> payload_frames;
  std::vector<MechanismObject> objects;
  std::array<double, 3> gravity{0, 0, -9.81};
  MechanismInputs inputs;
  bool implicit_friction = false;  ///< see `Scene`
  SceneRegressor regressor;
  std::shared_ptr<BaseParameterMemo> base_parameters = std::make_shared<BaseParameterMemo>();
  SingularTasks singular = SingularTasks::smooth;  ///< see `Scene`
  Real real = Real::float64;                       ///< see `Scene`
  std::vector<Coordinate> coordinates;             ///< nq of them
  std::vector<std::string> velocities;             ///< nv entries, for instance "elbow, rad/s"
  std::vector<ReductionNote> notes;
  std::string file;       ///< name of the robot's file
  Resolution resolution;  ///< of the file's numbers
  NoiseDecisions noise;   ///< numbers of files and relations between frames that are taken as exact
  /// Families of isomorphic limbs, see `find_limbs`. Empty if limbs shall not share lanes.
  std::vector<LimbFamily> limbs;

  [[nodiscard]] int nq() const { return static_cast<int>(coordinates.size()); }
  [[nodiscard]] int nv() const { return static_cast<int>(velocities.size()); }
  [[nodiscard]] int task_rows() const;
  /// Rows that are held: of the constraints to the world first, then of the loops, then one a
  /// coupling.
  [[nodiscard]] int held_rows() const;
  [[nodiscard]] int anchored_rows() const;  ///< of the constraints to the world
  [[nodiscard]] bool has_mimics() const;
};

/// Whether an operational point is the centre of mass.
bool has_center_of_mass(const Mechanism& mechanism);

/// Drops inertial parameters of the link that nearly vanish relative to the moments of everything
/// that it carries, and records this. See `resolved`.
void resolve_inertia(Mechanism& mechanism, MovingLink& link);

}  // namespace treeline
