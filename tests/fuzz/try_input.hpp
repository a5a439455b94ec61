#pragma once

#include <string>

namespace treeline::fuzz {

/// Reads a URDF and, where it is accepted and small, reduces its mechanism and traces its dynamics.
/// Says what is wrong with how that went; empty when all is well. What must hold: nothing is
/// thrown; there is a robot or an error, never both nor neither; every diagnostic says what is
/// wrong, and an error what to do; an accepted robot is a tree of finite numbers; the constants of
/// its mechanism and of its traced functions are finite, its rotations orthogonal.
std::string try_urdf(const std::string& text);

/// Reads a scene for a robot that has every kind of joint. Likewise.
std::string try_scene(const std::string& text);

/// Both, in one text: see `kSceneMark`.
std::string try_both(const std::string& text);

}  // namespace treeline::fuzz
