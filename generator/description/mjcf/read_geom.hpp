#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "description/flat/flat_model.hpp"
#include "description/mesh/mesh.hpp"
#include "description/mjcf/mjcf_compiler.hpp"

namespace treeline {

/// A homogeneous solid of density 1: its inertia is about its centre.
struct Solid {
  double volume = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
};

/// The solid that a closed surface bounds. `overlapping`: each triangle adds its tetrahedron with
/// the centre, whichever side shows, as MuJoCo counts by default.
Solid solid_within(const std::vector<Triangle>& surface, bool overlapping);

/// The surface itself as a shell: its area stands for the volume.
Solid solid_on(const std::vector<Triangle>& surface);

/// A `<mesh>` of the assets.
struct MjcfMesh {
  std::string file;  ///< relative to the folder of the model; empty: its corners are in the element
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Isometry3d reference = Eigen::Isometry3d::Identity();  ///< of the mesh's frame in the file
  std::string inertia;                                          ///< how MuJoCo is to count it
};

/// What geoms name.
struct MjcfAssets {
  std::map<std::string, MjcfMesh> meshes;
  std::map<std::string, std::string> colors;  ///< of materials
};

/// Adds what a `<mesh>` or `<material>` says.
void read_mjcf_asset(const MjcfElement& element, const MjcfCompiler& compiler, MjcfAssets& assets);

/// Mass, centre in the body's frame, and inertia about that in the body's axes.
struct MjcfMass {
  double mass = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();

  void add(const MjcfMass& other);
};

/// A `<geom>`: kind, sizes and pose in its body's frame.
class MjcfGeom {
 public:
  /// `frame` is the pose of the `<frame>` in which it stands; `weighs`: its mass counts, since a
  /// joint moves its body or a total of all masses is asked for.
  MjcfGeom(const MjcfElement& element, const Eigen::Isometry3d& frame, const MjcfCompiler& compiler,
           const MjcfAssets& assets, bool weighs);

  /// What its group lets count. An error where that cannot be computed but counts.
  [[nodiscard]] MjcfMass mass() const;

  /// Adds shapes of URDF that look like it and collide like it: of a capsule three.
  void add_shapes(std::vector<FlatShape>& shapes) const;

 private:
  void refuse(const std::string& fault) const;
  void read_sizes(const Eigen::Isometry3d& frame);
  [[nodiscard]] std::optional<Solid> solid() const;
  [[nodiscard]] std::optional<Solid> solid_of_mesh(const std::string& inertia) const;
  [[nodiscard]] std::vector<FlatShape> shapes() const;

  const MjcfElement& element_;
  const MjcfCompiler& compiler_;
  const MjcfAssets& assets_;
  bool weighs_;
  std::string type_;
  Eigen::Vector3d size_ = Eigen::Vector3d::Zero();  ///< as MuJoCo has them: radii, half lengths
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  const MjcfMesh* mesh_ = nullptr;
};

}  // namespace treeline
