#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace treeline {

/// A shape for programs that show robots.
struct SdfShape {
  bool collides = false;   ///< of `<collision>`, else of `<visual>`
  Eigen::Isometry3d pose;  ///< in the frame of its link
  std::string kind;        ///< element of URDF: `box`, `cylinder`, `sphere` or `mesh`
  std::string size_name;   ///< its first attribute: `size`, `radius` or `filename`
  std::string size;        ///< value of that
  std::string more_name;   ///< a second attribute, `length` or `scale`; empty: none
  std::string more;        ///< value of that
  std::string color;       ///< four numbers, red to alpha; empty: none is given
};

/// kg and kg m^2; the inertia is about the centre of mass, in the axes of `pose`.
struct SdfInertial {
  double mass = 0;
  Eigen::Isometry3d pose;  ///< in the frame of its link
  double ixx = 0, ixy = 0, ixz = 0, iyy = 0, iyz = 0, izz = 0;
};

/// A link, or a frame that is fixed to one. Names have `MODEL::` in front inside nested models.
struct SdfLink {
  std::string name;
  Eigen::Isometry3d pose;  ///< in the frame of the whole model, all joints at zero
  std::optional<SdfInertial> inertial;
  std::vector<SdfShape> shapes;
};

/// rad or m, N m or N; infinite where the file sets no bound.
struct SdfAxis {
  Eigen::Vector3d direction;  ///< in the frame of the joint
  double lower = 0, upper = 0, effort = 0, velocity = 0;
  double damping = 0, friction = 0;
};

struct SdfJoint {
  std::string name;
  std::string type;        ///< as SDF names it
  int parent = -1;         ///< index into `SdfModel::links`; -1: the world
  int child = -1;          ///< the same
  Eigen::Isometry3d pose;  ///< of its frame in that of the whole model, all joints at zero
  std::vector<SdfAxis> axes;
  /// Elements in the namespace of Drake that state the motor's rotor, and their text.
  std::vector<std::pair<std::string, std::string>> rotor;
};

/// Mechanism that a model in SDF describes, with nested models and includes put in and all poses
/// resolved. Joints may close loops and may lead either way.
struct SdfModel {
  std::string name;
  std::vector<SdfLink> links;    ///< the first is the canonical one
  std::vector<SdfJoint> joints;  ///< in the file's order
};

}  // namespace treeline
