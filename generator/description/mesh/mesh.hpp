#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace treeline {

using Color = std::array<double, 3>;  ///< red, green, blue, 0 to 1

/// A triangle of a mesh. Its corners turn to the left as seen from outside.
struct Triangle {
  std::array<Eigen::Vector3d, 3> corners;  ///< m
  std::optional<Color> color;              ///< where the file gives one
};

/// A triangle in another frame, or another scale. A mirror image is turned so that outside stays
/// outside.
Triangle moved(const Triangle& triangle, const Eigen::Affine3d& pose);

/// The triangles of a mesh, or why there are none.
struct Mesh {
  std::vector<Triangle> triangles;
  std::string problem, remedy;  ///< empty if the mesh was read
};

/// Reads a mesh by the ending of its name: STL of either form, OBJ, or COLLADA (DAE). A file that
/// is damaged, empty, too large or of another format is a problem, never a part of a mesh.
Mesh read_mesh(const std::string& path);

/// Reads an STL into triangles. Returns the problem, or nothing.
std::string read_stl(std::string_view bytes, std::vector<Triangle>& triangles);

/// Reads the faces of a Wavefront OBJ; those of more corners become fans. Returns the problem, or
/// nothing.
std::string read_obj(std::string_view bytes, std::vector<Triangle>& triangles);

/// Reads the scene of a COLLADA file, in its unit, with the diffuse colours of its materials.
/// `up_axis` is not obeyed, as by other programs that show URDFs. Returns the problem, or nothing.
std::string read_collada(std::string_view bytes, std::vector<Triangle>& triangles);

}  // namespace treeline
