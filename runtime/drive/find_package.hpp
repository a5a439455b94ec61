#pragma once

#include <filesystem>
#include <string>

#include "drive/find_meshes.hpp"

namespace treeline::drive {

/// A package's folder, or why there is none.
struct FoundPackage {
  std::filesystem::path folder;
  bool installed = false;  ///< of the user's environment, whose links lead to sources
  std::string problem, remedy;
};

/// The package `name` for a URDF in `folder`: where `places` says, else the URDF's folder or one of
/// that name in it, else the package that the URDF lies in, or one beside it, both with a
/// package.xml, else an installed one. A folder above the URDF that only has the name is none: it
/// may be a home. The folder above `urdf/`, `robots/` and the like is one.
FoundPackage find_package(const std::string& name, const std::filesystem::path& folder,
                          const MeshPlaces& places);

}  // namespace treeline::drive
