#pragma once

namespace treeline {

/// Tools that build libraries of sources, each from a folder of its own form.
enum class PackageKind { none, cmake, platformio, zephyr, arduino, cmsis };

}  // namespace treeline
