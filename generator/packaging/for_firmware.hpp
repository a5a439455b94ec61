#pragma once

#include "generation/generate_code.hpp"
#include "packaging/describe_package.hpp"
#include "packaging/package_kind.hpp"

namespace treeline {

/// Firmware around the controller's step for a Cortex-M without an operating system: an interrupt,
/// a mailbox, a watchdog, frames of CAN, a port for QEMU and a makefile.
std::vector<PackageFolder> for_firmware(PackageFacts facts, const Robot& robot, const Scene& scene,
                                        const Generation& generation);

/// Reports what such firmware cannot be made of.
void refuse_for_firmware(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
