#pragma once

namespace treeline {

/// Tools that build libraries of sources, each from a folder of its own form; `python` stands for
/// pip, `rust` for cargo, `fmu` for what imports Functional Mock-up Units, `ros2_control` for
/// colcon.
enum class PackageKind {
  none,
  cmake,
  platformio,
  zephyr,
  arduino,
  cmsis,
  python,
  rust,
  fmu,
  ros2_control
};

}  // namespace treeline
