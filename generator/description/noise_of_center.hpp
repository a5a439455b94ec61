#pragma once

namespace treeline {

/// Number of resolutions of a centre of mass's distance from its joint within which a component of
/// it may be noise. The moment that a light tip exerts on its own joint is as small as that
/// distance, so noise of the robot's size may be much beside it. What is left out costs that moment
/// 64 ulp at most. With fewer, noise of 1e-16 m beside centimetres would stay and cost operations.
inline constexpr double kOfDistance = 32;

}  // namespace treeline
