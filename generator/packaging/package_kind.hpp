#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/generated_file.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A folder of a package and the files that lie in it.
struct PackageFolder {
  std::string path;  ///< in the package; empty: the package itself
  std::vector<GeneratedFile> files;
};

/// A tool that builds libraries of sources, each from a folder of its own form.
struct PackageKind {
  const char* option;  ///< of `--package`
  /// What the tool wants to know beside the code.
  std::vector<PackageFolder> (*make)(PackageFacts facts, const Robot& robot, const Scene& scene,
                                     const Generation& generation);
  /// "a package for Python": it is compiled from C whatever the scene says. Else empty.
  std::string_view of_c = {};
  std::string_view caller = {};   ///< language whose programs call that C
  bool is_unit = false;           ///< a Functional Mock-up Unit, of any version
  bool calls_a_function = false;  ///< without a function in the scene there is no package
  bool is_for_firmware = false;   ///< no core of its tool has lanes
  bool joins_sources = true;      ///< functions that loop are one source, which is in the package
  void (*refuse)(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) = nullptr;
};

/// All kinds, in the order in which help lists them.
std::span<const PackageKind> list_packages();

/// The kind that `--package` names; null where the code is no package.
const PackageKind* find_package(std::string_view option);

}  // namespace treeline
