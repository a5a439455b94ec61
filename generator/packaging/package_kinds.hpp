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

/// Firmware around the controller's step for a Cortex-M without an operating system: an interrupt,
/// a mailbox, a watchdog, frames of CAN, a port for QEMU and a makefile.
std::vector<PackageFolder> for_firmware(PackageFacts facts, const Robot& robot, const Scene& scene,
                                        const Generation& generation);

/// Reports what such firmware cannot be made of.
void refuse_for_firmware(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

/// Files that pip needs beside the code: a package that compiles it as an extension of Python.
std::vector<PackageFolder> for_python(PackageFacts facts, const Robot& robot, const Scene& scene,
                                      const Generation& generation);

/// Files that cargo needs beside the code: a crate that compiles it and calls it by functions that
/// are safe, without the standard library.
std::vector<PackageFolder> for_rust(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation);

/// Files that npm and browsers need beside the code: a script that compiles it to WebAssembly, a
/// module that calls it, and types.
std::vector<PackageFolder> for_wasm(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation);

/// Files that make a Functional Mock-up Unit of FMI 2.0 or 3.0 of the code: its description, the
/// source that wraps `forward_dynamics`, or the step of a controller that has no function beside
/// it, and a project of CMake that packs both.
std::vector<PackageFolder> for_fmu2(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation);
std::vector<PackageFolder> for_fmu3(PackageFacts facts, const Robot& robot, const Scene& scene,
                                    const Generation& generation);

/// Refuses a scene whose motion `forward_dynamics` of q, qd, tau and external forces does not give:
/// one without that function, with closed loops, or with a model that is passed at run time.
void refuse_for_fmu(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

/// Files that make a package of ROS 2 of the code: a plugin of ros2_control whose law is the
/// scene's controller or, without one, gravity compensation.
std::vector<PackageFolder> for_ros2_control(PackageFacts facts, const Robot& robot,
                                            const Scene& scene, const Generation& generation);

/// Refuses what such a plugin has no interface for: measured forces, inputs, and without a
/// controller what else than one coordinate with a motor each joint is.
void refuse_for_ros2_control(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

/// Adapts a scene to such a package: C, and no controller beside functions in an FMU. Says so where
/// the scene, of which `text` is what was read, asks for something else.
void adapt_to_c(const PackageKind& kind, const std::string& text, Scene& scene,
                Diagnostics& diagnostics);

/// The package that holds generated code: the code as it is in `src`, and beside it what the tool
/// wants to know. Where `kind` is null the code itself, without a folder `src`.
std::vector<PackageFolder> make_package(const PackageKind* kind, const Robot& robot,
                                        const Scene& scene, const Generation& generation);

/// A sketch for Arduino that calls the first function and tells how long that takes.
std::string print_example(const Scene& scene, const Generation& generation,
                          const PackageFacts& facts);

}  // namespace treeline
