#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Reads the scene at `path` for `robot`. The YAML is taken strictly: an unknown or repeated key, a
/// value of the wrong kind or length, and a name that the robot does not have are errors, with the
/// line and the nearest name. Nothing is returned when there is an error.
///
/// Defaults: see `Scene`; `name` is the robot's name made an identifier; `base` is `default_base`,
/// with a note where it floats; `functions` are all that the scene permits: those of operational
/// points if it has any, those that invert the mass matrix if it can be inverted. `functions`,
/// sorted and unique, go before what the file lists, if there are any.
///
/// An empty `path` is the default scene, with a note that says so.
std::optional<Scene> read_scene(const std::string& path, const Robot& robot,
                                Diagnostics& diagnostics,
                                const std::vector<Function>& functions = {});

/// What lists functions in place of a scene.
inline constexpr const char* kFunctionsOption = "--functions";

/// Who says which functions there are. A command that chooses them itself says what it leaves out
/// of a scene; the scene's functions are then none of its business.
enum class FunctionsFrom { scene, command };

/// Reads a scene from text. `file_name` is for diagnostics only. Empty text is the default scene.
std::optional<Scene> parse_scene(const std::string& text, const std::string& file_name,
                                 const Robot& robot, Diagnostics& diagnostics,
                                 const std::vector<Function>& functions = {},
                                 FunctionsFrom from = FunctionsFrom::scene);

}  // namespace treeline
