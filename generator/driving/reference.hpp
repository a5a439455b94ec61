#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drive/reference_motion.hpp"
#include "drive/robot_description.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A motion that a driven robot can follow.
struct Reference {
  std::vector<double> times;  ///< s, growing
  std::vector<double> q;      ///< a row a time

  /// For a loop; points into this object.
  [[nodiscard]] drive::RecordedMotion motion() const {
    return {times.data(), q.data(), static_cast<int>(times.size())};
  }
};

/// Reads a record of `drive`, or a table as `treeline draw --motion` takes it. `home` stands for
/// coordinates that it does not have. Errors: those of reading; fewer than two moments; coordinates
/// beyond the limits of the robot.
std::optional<Reference> read_reference(const std::string& path,
                                        const drive::RobotDescription& robot,
                                        const std::vector<double>& home, Diagnostics& diagnostics);

}  // namespace treeline
