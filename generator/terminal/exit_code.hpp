#pragma once

namespace treeline {

/// What the program says to the shell. Constants, since they are used without the type.
enum ExitCode : int {  // NOLINTBEGIN(readability-identifier-naming)
  kOk = 0,
  kBadInput = 1,  ///< the robot, the scene or the output folder is at fault
  kUsage = 2,     ///< the command line is
  kMismatch = 3,  ///< something is stale or out of bounds
  kInternal = 70  ///< this program is
};                // NOLINTEND(readability-identifier-naming)

}  // namespace treeline
