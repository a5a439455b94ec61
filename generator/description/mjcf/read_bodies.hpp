#pragma once

#include <map>
#include <string>
#include <vector>

#include "description/flat/flat_model.hpp"
#include "description/mjcf/mjcf_compiler.hpp"
#include "description/mjcf/read_geom.hpp"
#include "description/robot.hpp"

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

}  // namespace treeline
