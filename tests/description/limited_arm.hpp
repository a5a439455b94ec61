#pragma once

#include <string>

#include "description/read_urdf.hpp"

namespace treeline {

/// A link with mass and inertia.
inline std::string limited_link(const std::string& name) {
  return "<link name='" + name +
         "'><inertial><origin xyz='0.1 0 0'/><mass value='1'/><inertia ixx='0.02' ixy='0' ixz='0' "
         "iyy='0.02' iyz='0' izz='0.02'/></inertial></link>\n";
}

/// A joint about or along y with these attributes of `<limit>`; no such element if they are empty.
inline std::string limited_joint(const std::string& name, const std::string& type,
                                 const std::string& parent, const std::string& child,
                                 const std::string& limits, const std::string& more = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><axis xyz='0 1 0'/>" +
         (limits.empty() ? "" : "<limit " + limits + "/>") + more + "</joint>\n";
}

/// A robot of one joint, `turn`, in its third line.
inline std::string limited_arm(const std::string& limits, const std::string& type = "revolute") {
  return "<robot name='arm'><link name='base'/>\n" + limited_link("tip") +
         limited_joint("turn", type, "base", "tip", limits) + "</robot>";
}

/// A joint `lead` and a joint `follow` that moves by multiplier q + offset.
inline std::string led_arm(const std::string& limits, const std::string& of_follower,
                           const std::string& multiplier, const std::string& offset) {
  return "<robot name='arm'><link name='base'/>\n" + limited_link("first") +
         limited_link("second") + limited_joint("lead", "revolute", "base", "first", limits) +
         limited_joint(
             "follow", "revolute", "first", "second", of_follower,
             "<mimic joint='lead' multiplier='" + multiplier + "' offset='" + offset + "'/>") +
         "</robot>";
}

}  // namespace treeline
