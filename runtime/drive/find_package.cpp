#include "drive/find_package.hpp"

#include <algorithm>
#include <array>
#include <system_error>

namespace treeline::drive {
namespace {

namespace fs = std::filesystem;

bool is_declared(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "package.xml", error);
}

/// Folders in which packages keep their URDFs.
bool holds_urdfs(const fs::path& folder) {
  constexpr std::array kNames = {"urdf", "urdfs", "robot", "robots", "description", "xacro"};
  return std::ranges::find(kNames, folder.filename()) != kNames.end();
}

FoundPackage find_installed(const std::string& name, const MeshPlaces& places) {
  std::error_code error;
  for (const fs::path& prefix : places.prefixes) {
    if (fs::is_directory(prefix / "share" / name, error))
      return {prefix / "share" / name, true, {}, {}};
  }
  for (const fs::path& source : places.sources) {
    if (source.filename() == name && is_declared(source)) return {source, true, {}, {}};
    if (fs::is_directory(source / name, error)) return {source / name, true, {}, {}};
    for (fs::directory_iterator at(source, error), end; !error && at != end; at.increment(error)) {
      if (is_declared(at->path() / name)) return {at->path() / name, true, {}, {}};
    }
    error.clear();
  }
  return {};
}

/// A folder of that name above the URDF, or beside those above it. Where it does not declare that
/// it is a package, only its place is told.
FoundPackage find_above(const std::string& name, const fs::path& folder) {
  std::error_code error;
  fs::path undeclared;
  for (fs::path below = folder, above = folder.parent_path(); below.has_relative_path();
       below = above, above = above.parent_path()) {
    const bool named = above.filename() == name;
    const fs::path found = named ? above : above / name;
    if (!named && !fs::is_directory(found, error)) continue;
    if (is_declared(found) || (named && below == folder && holds_urdfs(folder))) {
      return {found, false, {}, {}};
    }
    if (undeclared.empty()) undeclared = found;
  }
  if (undeclared.empty()) return {};
  return {{},
          false,
          "the folder " + undeclared.string() + " has the name of the package " + name +
              ", but no package.xml: it may hold what is not the robot's",
          "If it is meant: --package " + name + "=" + undeclared.string() + "."};
}

}  // namespace

FoundPackage find_package(const std::string& name, const fs::path& folder,
                          const MeshPlaces& places) {
  const auto given = places.packages.find(name);
  if (given != places.packages.end()) return {given->second, false, {}, {}};
  std::error_code error;
  const fs::path here = fs::canonical(folder, error);
  if (error || name.empty() || name == "." || name == "..") {
    return {{}, false, "this is no name of a package", "Look at the name in the URDF."};
  }
  if (here.filename() == name) return {here, false, {}, {}};
  if (fs::is_directory(here / name, error)) return {here / name, false, {}, {}};
  FoundPackage above = find_above(name, here);
  if (!above.folder.empty()) return above;
  FoundPackage installed = find_installed(name, places);
  if (!installed.folder.empty()) return installed;
  if (!above.problem.empty()) return above;
  return {{},
          false,
          "there is no package " + name +
              " beside or above the URDF, in AMENT_PREFIX_PATH or in ROS_PACKAGE_PATH",
          "Say where it lies: --package " + name + "=DIR."};
}

}  // namespace treeline::drive
