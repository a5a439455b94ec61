#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "description/flat/flat_model.hpp"
#include "description/mjcf/mjcf_compiler.hpp"
#include "description/mjcf/read_geom.hpp"
#include "description/robot.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Where something stands in the mechanism.
struct MjcfPlace {
  int link = -1;  ///< index into `FlatModel::links`; -1: the world
  Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();
};

/// The mechanism that the bodies of a model make, and what its other sections need to name them.
struct MjcfTree {
  FlatModel model;
  FlatTree tree;
  SceneHints hints;
  std::map<std::string, int> bodies;          ///< links; the world is -1
  std::map<std::string, std::size_t> joints;  ///< index into `tree.joints`, by names in the file
  std::map<std::string, MjcfPlace> sites;
  std::vector<Eigen::Isometry3d> initial;  ///< of links in the world, all joints at `ref`
  std::vector<double> ref;                 ///< of joints of the tree
};

/// Reads the bodies of all `<worldbody>`. A body that moves freely, and is all that moves, is the
/// root of a floating base; else the world is the root. Several joints of a body are links without
/// mass in between. Names that the file leaves out are made of those of the body.
void read_bodies(const std::vector<MjcfElement>& worlds, const MjcfCompiler& compiler,
                 const MjcfAssets& assets, MjcfTree& result);

/// Sets the limits of effort of joints that motors of `<actuator>` drive, from their ranges of
/// force, or of control where that is a force, and their gears; and adds the inertia that they
/// state. Actuators that do not drive one joint are warnings.
void read_actuators(const std::vector<MjcfElement>& sections, const MjcfCompiler& compiler,
                    MjcfTree& tree);

/// What a range of forces bounds either way: its smaller end, with a note where the ends differ.
/// Infinite where it does not hold.
double bound_of(const MjcfElement& element, const char* range, const char* limited,
                const MjcfCompiler& compiler);

/// Reads all `<equality>`: of two joints a mimic, `connect` and `weld` as joints
/// that close loops. Others are warnings.
void read_equalities(const std::vector<MjcfElement>& sections, MjcfTree& tree);

/// The mechanism of an MJCF model. `text` is the file's content, `path` where it is: includes and
/// meshes are looked for beside it. Faults are in `diagnostics`, with file, line and element; what
/// has a meaning for the motion and no place in a URDF is a warning, or an error where it makes
/// other bodies.
std::optional<MjcfTree> read_mjcf(const std::string& text, const std::string& path,
                                  Diagnostics& diagnostics);

/// A joint of a body, without its links.
struct MjcfJoint {
  FlatJoint joint;
  Eigen::Isometry3d place;       ///< of its anchor in the body, whose axes it has
  Eigen::Isometry3d moved_back;  ///< what its coordinate 0 makes of `place`, for `ref` is 0 there
  double ref = 0;
  std::optional<SpringHint> spring;
};

/// Warns of attributes of a joint that add forces and have no place here: `springdamper`, and those
/// of a joint of six or three freedoms, which does not have one axis.
void warn_of_forces(const MjcfElement& element, bool has_axis);

/// Reads a `<joint>` or `<freejoint>` that stands in a `<frame>` of the body. What URDF has no
/// place for is a warning.
MjcfJoint read_mjcf_joint(const MjcfElement& element, const Eigen::Isometry3d& frame,
                          const MjcfCompiler& compiler);

/// Reads `<inertial>`.
FlatInertial read_inertial(const MjcfElement& element, const MjcfCompiler& compiler);

/// The inertia of all that geoms weigh; nothing where that is nothing.
std::optional<FlatInertial> inertial_of(const MjcfMass& mass);

/// Changes the inertia of a body, also of one without mass, as `boundmass`, `boundinertia` and
/// `balanceinertia` say, with a note.
void bound_inertial(const MjcfElement& body, const MjcfCompiler& compiler,
                    std::optional<FlatInertial>& bounded);

void scale_inertial(double factor, FlatInertial& inertial);

}  // namespace treeline
