#pragma once

#include <array>
#include <string>
#include <string_view>

#include "description/scene.hpp"

namespace treeline {

/// Names of a point's rows in scenes: along and about the axes.
inline constexpr std::array kRowNames = {"x", "y", "z", "rx", "ry", "rz"};

/// The rows of the point that are controlled, in their order: "x y rz".
std::string list_rows(const ScenePoint& point, std::string_view between = " ");

}  // namespace treeline
