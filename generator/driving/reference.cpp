#include <fmt/format.h>

#include "drawing/recorded_motion.hpp"
#include "driving/driver.hpp"

namespace treeline {
namespace {

/// Whether the row stays within the limits; an error if not.
bool is_within_limits(const std::vector<double>& q, double time, const std::string& path,
                      const drive::RobotDescription& robot, Diagnostics& diagnostics) {
  constexpr double kSlack = 0.02;  // rad or m: where the loop's own limits are
  for (std::size_t i = 0; i < q.size(); ++i) {
    const drive::DrivenCoordinate& coordinate = robot.coordinates[i];
    if (q[i] >= coordinate.lower - kSlack && q[i] <= coordinate.upper + kSlack) continue;
    diagnostics.add({Severity::error, path, 0, "",
                     fmt::format("at {:.4g} s {} is at {:.4g}, beyond its limits {:.4g} and {:.4g}",
                                 time, coordinate.name, q[i], coordinate.lower, coordinate.upper),
                     "Give a motion of this robot."});
    return false;
  }
  return true;
}

}  // namespace

std::optional<Reference> read_reference(const std::string& path,
                                        const drive::RobotDescription& robot,
                                        const std::vector<double>& home, Diagnostics& diagnostics) {
  std::vector<std::string> joints;
  for (const drive::DrivenCoordinate& coordinate : robot.coordinates) {
    joints.push_back(coordinate.joint);
  }
  const auto motion = read_motion(path, joints, home, diagnostics);
  if (!motion) return std::nullopt;
  Reference reference;
  for (std::size_t row = 0; row < motion->times.size(); ++row) {
    const double time = motion->times[row];
    if (!reference.times.empty() && time <= reference.times.back()) continue;  // said twice
    if (!is_within_limits(motion->q[row], time, path, robot, diagnostics)) return std::nullopt;
    reference.times.push_back(time);
    reference.q.insert(reference.q.end(), motion->q[row].begin(), motion->q[row].end());
  }
  if (reference.times.size() >= 2) return reference;
  diagnostics.add({Severity::error, path, 0, "", "this is one moment, not a motion",
                   "Give a record or a table with two moments or more."});
  return std::nullopt;
}

}  // namespace treeline
