#include "description/noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "description/for_each_pose.hpp"
#include "description/join_robots.hpp"
#include "description/rotation.hpp"
#include "description/snap_angles.hpp"
#include "description/with_rotors.hpp"

namespace treeline {
namespace {

constexpr std::array<const char*, 3> kAngles{"roll", "pitch", "yaw"};
constexpr std::array<const char*, 3> kCoordinates{"x", "y", "z"};

/// Place of a change in a file.
struct Place {
  const std::string& file;
  int line;
  const std::string& element;
};

void add(NoiseDecisions* decisions, const Place& at, std::string text, double change) {
  if (!decisions) return;
  decisions->push_back({at.file, at.line, at.element, std::move(text), std::abs(change)});
}

/// Magnitudes that have come before: legs that are alike have numbers that are, and share code.
class Magnitudes {
 public:
  /// The number, with the magnitude that came before where it differs by no more than the limit.
  double shared(double number, double limit) {
    const double magnitude = std::abs(number);
    const auto known = known_.lower_bound(magnitude - limit);
    if (known != known_.end() && *known <= magnitude + limit) {
      return std::copysign(*known, number);
    }
    known_.insert(magnitude);
    return number;
  }

 private:
  std::set<double> known_;
};

/// Makes the poses of one file exact, one after another.
class PoseCleaner {
 public:
  PoseCleaner(const NoiseLimits& limits, NoiseDecisions* decisions)
      : limits_(limits), decisions_(decisions) {}

  void make_exact(Pose& pose, const Place& at) { make_exact(pose, limits_.length, at); }

  void make_center_exact(Pose& pose, const Place& at) {
    make_exact(pose, limit_of_center(pose), at);
  }

 private:
  /// Size that a component of a centre of mass must exceed not to be noise, see `kOfDistance`. A
  /// centre within the robot's noise is all noise.
  [[nodiscard]] double limit_of_center(const Pose& pose) const {
    const double distance = std::hypot(pose.xyz[0], pose.xyz[1], pose.xyz[2]);
    const bool is_noise = distance <= limits_.length;
    const bool asked = limits_.angle > kResolution;
    if (is_noise || asked) return limits_.length;
    return std::min(limits_.length, kOfDistance * limits_.angle * distance);
  }

  void make_exact(Pose& pose, double length, const Place& at) {
    for (std::size_t i = 0; i < 3; ++i) {
      make_angle_exact(pose.rpy[i], kAngles[i], at);
      make_offset_exact(pose.xyz[i], length, kCoordinates[i], at);
    }
  }

  void make_angle_exact(double& angle, const char* name, const Place& at) {
    const QuarterTurns nearest = nearest_quarter_turns(angle);
    if (angle == nearest.as_double) return;
    if (std::abs(nearest.off) <= limits_.angle) {
      add(decisions_, at,
          fmt::format("{} {} rad is {}", name, angle, name_quarter_turns(nearest.as_double)),
          nearest.off);
      angle = nearest.as_double;
      return;
    }
    share(angle, limits_.angle, angles_, name, "rad", at);
  }

  void make_offset_exact(double& offset, double limit, const char* name, const Place& at) {
    if (offset == 0) return;
    if (std::abs(offset) <= limit) {
      add(decisions_, at, fmt::format("{} {} m is 0", name, offset), offset);
      offset = 0;
      return;
    }
    share(offset, limit, lengths_, name, "m", at);
  }

  void share(double& number, double limit, Magnitudes& known, const char* name, const char* unit,
             const Place& at) {
    const double shared = known.shared(number, limit);
    if (shared == number) return;
    add(decisions_, at, fmt::format("{} {} {} is {}, as elsewhere", name, number, unit, shared),
        number - shared);
    number = shared;
  }

  NoiseLimits limits_;
  NoiseDecisions* decisions_;
  Magnitudes angles_, lengths_;
};

void make_exact(Joint& joint, double limit, const Place& at, NoiseDecisions* decisions) {
  // Beside -z, the least digits say in which directions the other axes are, as those of a planar
  // joint.
  if (info_of(joint.type).steps.size() > 1) return;
  double largest = 0;
  for (const double component : joint.axis) largest = std::max(largest, std::abs(component));
  for (std::size_t i = 0; i < 3; ++i) {
    double& component = joint.axis[i];
    if (component == 0 || std::abs(component) > limit * largest) continue;
    add(decisions, at, fmt::format("axis {} {} is 0", kCoordinates[i], component),
        component / largest);
    component = 0;
  }
}

double longest_offset(const Robot& robot) {
  double longest = 0;
  for_each_pose(robot, [&](const Pose& pose, const std::string&, const std::string&) {
    for (const double offset : pose.xyz) longest = std::max(longest, std::abs(offset));
  });
  return longest;
}

}  // namespace

NoiseLimits noise_limits(const Robot& robot, const Scene& scene) {
  return {scene.noise, scene.noise * longest_offset(robot)};
}

Robot without_noise(Robot robot, const NoiseLimits& limits, NoiseDecisions* decisions) {
  PoseCleaner cleaner(limits, decisions);
  for_each_inertial_pose(
      robot, [&](Pose& pose, const std::string& owner, const std::string& element) {
        cleaner.make_center_exact(pose, {file_of(robot, owner), pose.line, element});
      });
  for_each_joint_pose(robot, [&](Pose& pose, const std::string& owner, const std::string& element) {
    cleaner.make_exact(pose, {file_of(robot, owner), pose.line, element});
  });
  for (Joint& joint : robot.joints) {
    const std::string element = fmt::format("robot/joint[{}]/axis", joint.name);
    make_exact(joint, limits.angle, {file_of(robot, joint.name), joint.axis_line, element},
               decisions);
  }
  return robot;
}

Scene without_noise(Scene scene, const NoiseLimits& limits, NoiseDecisions* decisions) {
  const std::string file = scene.file;
  PoseCleaner cleaner(limits, decisions);
  for_each_point_pose(scene, [&](Pose& pose, const std::string& element) {
    cleaner.make_exact(pose, {file, pose.line, element});
  });
  return scene;
}

Robot as_asked(Robot robot, const Scene& scene) {
  robot = with_snapped_angles(std::move(robot), scene.snap_angles);
  if (scene.noise <= kResolution) return with_rotors(std::move(robot), scene);
  const NoiseLimits limits = noise_limits(robot, scene);
  return with_rotors(without_noise(std::move(robot), limits), scene);
}

void note_noise(const NoiseDecisions& decisions, const Scene& scene, Diagnostics& diagnostics) {
  std::vector<std::string> files;
  for (const NoiseDecision& decision : decisions) {
    if (std::find(files.begin(), files.end(), decision.file) == files.end()) {
      files.push_back(decision.file);
    }
  }
  for (const std::string& file : files) {
    const auto count =
        std::count_if(decisions.begin(), decisions.end(),
                      [&](const NoiseDecision& decision) { return decision.file == file; });
    diagnostics.add(
        {Severity::note, file, 0, "",
         fmt::format("{} that differ{} from an exact one by less than {:.1e} {} taken as exact",
                     count == 1 ? "a number" : fmt::format("{} numbers", count),
                     count == 1 ? "s" : "", scene.noise, count == 1 ? "is" : "are"),
         "`treeline inspect --noise` lists them; `noise: keep` in the scene uses them as "
         "written."});
  }
}

}  // namespace treeline
