#pragma once

#include <string>

#include "text/read_text_file.hpp"

// SAMM on four powered casters. Needs TREELINE_ROBOTS_DIR.

namespace treeline::tests {

// Chosen, as the base's mass is: casters at the corners of a square of this half length, m, whose
// wheels of 0.055 m trail by 0.02 m.
inline constexpr double kHalf = 0.2;
inline constexpr int kCasters = 4;

/// SAMM's file with a caster at each corner of its base: a fork that turns about the vertical, and
/// a wheel whose axle trails the fork's axis.
inline std::string urdf_on_casters() {
  Diagnostics diagnostics;
  std::string text =
      read_text_file(std::string(TREELINE_ROBOTS_DIR) + "/samm/samm.urdf", diagnostics).value();
  std::string parts;
  for (int k = 0; k < kCasters; ++k) {
    const std::string fork = "fork" + std::to_string(k), wheel = "wheel" + std::to_string(k);
    const std::string at = std::to_string(k < 2 ? kHalf : -kHalf) + " " +
                           std::to_string(k % 2 == 0 ? kHalf : -kHalf) + " 0.055";
    parts += "<link name=\"" + fork +
             "\"><inertial><mass value=\"1\"/><inertia ixx=\"0.002\" ixy=\"0\" ixz=\"0\" "
             "iyy=\"0.002\" iyz=\"0\" izz=\"0.002\"/></inertial></link><joint name=\"" +
             fork + "\" type=\"continuous\"><parent link=\"base\"/><child link=\"" + fork +
             "\"/><origin xyz=\"" + at + "\"/><axis xyz=\"0 0 1\"/></joint>";
    parts += "<link name=\"" + wheel +
             "\"><inertial><mass value=\"1.5\"/><inertia ixx=\"0.0012\" ixy=\"0\" ixz=\"0\" "
             "iyy=\"0.0023\" iyz=\"0\" izz=\"0.0012\"/></inertial></link><joint name=\"" +
             wheel + "\" type=\"continuous\"><parent link=\"" + fork + "\"/><child link=\"" +
             wheel + "\"/><origin xyz=\"-0.02 0 0\"/><axis xyz=\"0 1 0\"/></joint>";
  }
  return text.replace(text.rfind("</robot>"), 8, parts + "</robot>");
}

}  // namespace treeline::tests
