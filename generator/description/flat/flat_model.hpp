#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// A shape for programs that show robots.
struct FlatShape {
  bool collides = false;   ///< of `<collision>`, else of `<visual>`
  Eigen::Isometry3d pose;  ///< in the frame of its link
  std::string kind;        ///< element of URDF: `box`, `cylinder`, `sphere` or `mesh`
  std::string size_name;   ///< first attribute of the shape: `size`, `radius` or `filename`
  std::string size;        ///< value of that
  std::string more_name;   ///< a second attribute, `length` or `scale`; empty: none
  std::string more;        ///< value of that
  std::string color;       ///< four numbers, red to alpha; empty: none is given
};

/// kg and kg m^2; the inertia is about the centre of mass, in the axes of `pose`.
struct FlatInertial {
  double mass = 0;
  Eigen::Isometry3d pose;  ///< in the frame of its link
  double ixx = 0, ixy = 0, ixz = 0, iyy = 0, iyz = 0, izz = 0;
};

/// A link, or a frame that is fixed to one.
struct FlatLink {
  std::string name;
  std::optional<FlatInertial> inertial;
  std::vector<FlatShape> shapes;
};

/// rad or m, N m or N; infinite where the file sets no bound.
struct FlatAxis {
  Eigen::Vector3d direction;  ///< in the frame of the joint
  double lower = 0, upper = 0, effort = 0, velocity = 0;
  double damping = 0, friction = 0, armature = 0;
};

/// q = multiplier * q[joint] + offset.
struct FlatMimic {
  std::string joint;
  double multiplier = 1, offset = 0;
};

struct FlatJoint {
  std::string name;
  std::string type;                       ///< as SDF names it, or `floating`
  int parent = -1;                        ///< index into `FlatModel::links`; -1: the world
  int child = -1;                         ///< index of the child link
  Eigen::Isometry3d in_parent, in_child;  ///< frame of the joint in those of its links, at zero
  std::vector<FlatAxis> axes;
  std::optional<FlatMimic> mimic;
  /// Elements in the namespace of Drake that state the motor's rotor, and their text.
  std::vector<std::pair<std::string, std::string>> rotor;
};

/// Mechanism that another format than URDF describes, with nested models and includes put in.
struct FlatModel {
  std::string name;
  std::vector<FlatLink> links;    ///< the first is the canonical one
  std::vector<FlatJoint> joints;  ///< in the file's order; they may close loops and lead either way
  double length = 0;              ///< m, the scale of rounding errors of places
};

/// Joints that make the tree, and joints that close loops.
struct FlatTree {
  std::vector<FlatJoint> joints;  ///< of the tree, each led away from the root, in its order
  std::vector<FlatJoint> loops;   ///< as in the file
  bool has_world = false;         ///< the root is the world, else the model's first link
};

/// The mechanism as a URDF. A link whose joint is not at its origin hangs on a frame without mass,
/// `JOINT_frame`, so that both frames are where SDF has them; joints with two axes become two,
/// `JOINT_1` and `JOINT_2`; what closes a loop is a `<loop_joint>`.
std::string print_urdf(const FlatModel& model, const FlatTree& tree);

/// Spans the tree from the world, or from the first link where no joint holds to the world: always
/// by the first joint of the file that leads from a reached link to one that is not, and, only if
/// there is none, against the direction of the first that ends in a reached link. So the last joint
/// of a loop closes it. An error in `diagnostics` where links stay unreached.
std::optional<FlatTree> span_tree(const FlatModel& model, const std::string& file,
                                  Diagnostics& diagnostics);

}  // namespace treeline
