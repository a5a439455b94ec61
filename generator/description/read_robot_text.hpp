#pragma once

#include <optional>
#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// A robot as text that `parse_urdf` reads.
struct RobotText {
  std::string urdf;
  std::string shown;  ///< what messages about lines of that text call the file
};

/// The URDF in a file, `-` is standard input; of an SDF file what it says as a URDF, see
/// `description/sdf`, with a note that tells so. A scene is an error; other text is handed on as it
/// is.
std::optional<RobotText> read_robot_text(const std::string& path, Diagnostics& diagnostics);

/// Makes robot text of a URDF or SDF whose text was read from `path`, see `read_robot_text`.
std::optional<RobotText> as_robot_text(std::string text, const std::string& path,
                                       Diagnostics& diagnostics);

}  // namespace treeline
