#pragma once

#include <optional>
#include <string>

#include "description/read_robots.hpp"
#include "description/robot.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A robot as text that `parse_urdf` reads.
struct RobotText {
  std::string urdf;
  std::string shown;  ///< what messages about lines of that text call the file
  SceneHints hints;   ///< what another format says that URDF cannot
};

/// The URDF in a file, `-` is standard input; of SDF and MJCF what they say as a URDF,
/// see `description/sdf` and `description/mjcf`, with a note that tells so. A scene is an error;
/// other text is handed on as it is.
std::optional<RobotText> read_robot_text(const std::string& path, Diagnostics& diagnostics);

/// Makes robot text of a URDF, SDF or MJCF whose text was read from `path`, see `read_robot_text`.
std::optional<RobotText> as_robot_text(std::string text, const std::string& path,
                                       Diagnostics& diagnostics);

/// The robot that the text describes, see `parse_urdf`.
std::optional<Robot> parse_robot(const RobotText& text, Diagnostics& diagnostics);

/// All robots of a scene as one URDF, as `join_robots` names them, for programs that show robots:
/// every element of each file, with names of links, joints and materials behind the robot's name
/// and a slash. Names of meshes are put behind it, too.
std::string print_joined_urdf(const SceneRobots& robots);

}  // namespace treeline
