#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "description/mesh/mesh.hpp"
#include "drawing/solids.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

enum class VisualKind { box, cylinder, sphere, mesh };

/// A `<visual>` of a link, or a `<collision>`.
struct Visual {
  std::string link;
  VisualKind kind = VisualKind::mesh;
  /// Edges; or radius, length; or radius; m. Of a mesh: its scale.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< in the link's frame
  Color color{};
  std::string file = {};                 ///< of a mesh, as the URDF names it
  std::vector<Triangle> triangles = {};  ///< of a mesh that was read, in the frame of `pose`
  bool stands_in = false;                ///< for meshes of the link that cannot be read
};

/// The visuals of a URDF that can be read as one, in the file's order. A visual without a shape
/// that has a size is left out, with a warning. A capsule is a cylinder and two spheres. Where all
/// visuals of a link are meshes, the boxes, cylinders and spheres by which it collides follow them
/// and stand in.
std::vector<Visual> read_visuals(const std::string& urdf, const std::string& file,
                                 Diagnostics& diagnostics);

/// The shapes by which the links of a URDF collide, in the file's order. Those without a size are
/// left out, with a warning, but for spheres of radius 0, which are points.
std::vector<Visual> read_collisions(const std::string& urdf, const std::string& file,
                                    Diagnostics& diagnostics);

/// A mesh that cannot be read.
struct UnreadMesh {
  std::string file;  ///< as the URDF names it
  std::string problem, remedy;
};

/// Reads the meshes of visuals, and reduces them to `most` triangles in all. `paths` has the file
/// of each name in the URDF; a mesh without one stays away. Shapes that stand in are dropped from
/// links with a mesh that was read. Returns what was not.
std::vector<UnreadMesh> read_meshes(std::vector<Visual>& visuals,
                                    const std::map<std::string, std::string>& paths,
                                    std::size_t most);

}  // namespace treeline
