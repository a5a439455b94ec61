#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "drive/wire.hpp"

namespace treeline::drive {

/// Folders, beside the URDF's own, in which meshes may lie. The user has permitted each.
struct MeshPlaces {
  std::map<std::string, std::filesystem::path> packages;  ///< where package://NAME/ lies
  std::vector<std::filesystem::path> folders;             ///< meshes below them may be shown
  /// Folders of installed packages (PREFIX/share/NAME), and of the sources of packages.
  std::vector<std::filesystem::path> prefixes, sources;
};

/// Finds the meshes that a URDF names, each once, in its order. `package://NAME/FILE` lies in the
/// package that `find_package` finds; other names, `file://` too, are relative to the URDF's folder
/// or absolute. A mesh is not found, with a problem and a remedy, if it is no file, if its name
/// does not end in stl, dae, obj, glb or gltf, if an STL is cut short, or if it lies, by `..` or
/// links, outside of its package, of the URDF's folder and of the folders of `places`.
std::vector<ServedMesh> find_meshes(std::string_view urdf, const std::filesystem::path& folder,
                                    const MeshPlaces& places);

}  // namespace treeline::drive
