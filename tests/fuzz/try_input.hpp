#pragma once

#include <string>

namespace treeline::fuzz {

/// Reads a URDF and, if it is accepted and small, reduces its mechanism and traces its dynamics.
/// Returns a description of the fault; empty if everything is right. Required: nothing is thrown.
/// The result is either a robot or an error, never both or neither. Every diagnostic states the
/// fault, and an error also a remedy. An accepted robot is a tree of finite numbers. The constants
/// of its mechanism and of its traced functions are finite, and its rotations orthogonal.
std::string try_urdf(const std::string& text);

/// Reads a scene for a robot with every kind of joint. Returns a description of the fault; empty if
/// everything is right.
std::string try_scene(const std::string& text);

/// Reads both from one text, see `kSceneMark`. Returns a description of the fault; empty if
/// everything is right.
std::string try_both(const std::string& text);

/// Generates all code for both in one text, if they are accepted and the robot is small. Returns a
/// description of the fault; empty if everything is right. Required: nothing is thrown. The result
/// is either files or an error, never both or neither. No file is empty, no constant is not finite.
std::string try_generate(const std::string& text);

}  // namespace treeline::fuzz
