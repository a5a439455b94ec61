#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "drive/wire.hpp"

namespace treeline::drive {

/// Finds the meshes that a URDF names, each once, in its order. `package://NAME/FILE` lies in the
/// folder that `packages` gives to NAME, else in the nearest folder NAME beside or above the URDF;
/// other names are relative to the URDF's folder. A mesh that is no file, whose name does not end
/// in stl, dae, obj, glb or gltf, or that lies outside of its folder (`..`, links), is not found.
std::vector<ServedMesh> find_meshes(std::string_view urdf, const std::filesystem::path& folder,
                                    const std::map<std::string, std::filesystem::path>& packages);

}  // namespace treeline::drive
