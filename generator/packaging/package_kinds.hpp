#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/package_kind.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

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

}  // namespace treeline
