#pragma once

namespace treeline {

/// Tools that build libraries of sources, each from a folder of its own form; `python` stands for
/// pip, `rust` for cargo, `fmu` and `fmu3` for what imports Functional Mock-up Units of FMI 2.0 and
/// 3.0, `wasm` for npm and browsers, `ros2_control` for colcon, `firmware` for make.
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
  fmu3,
  wasm,
  ros2_control,
  firmware
};

}  // namespace treeline
