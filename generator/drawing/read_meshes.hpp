#pragma once

#include <map>
#include <string>
#include <vector>

#include "drawing/read_visuals.hpp"

namespace treeline {

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
