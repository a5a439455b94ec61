#include "driving/find_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "driving/loop_handle.hpp"

namespace treeline {
namespace {

/// By how much the forces that hold the robot at rest exceed the `permitted` share of their limits:
/// the sum of squares.
class Overload {
 public:
  Overload(const drive::RobotLibrary& library, const drive::RobotDescription& robot)
      : library_(library),
        robot_(robot),
        numbers_(robot),
        layout_(drive::report_layout(library.coordinates, library.velocities, library.points)),
        report_(static_cast<std::size_t>(layout_.size)) {
    // Forces that are not cut say how much is missing.
    std::fill(numbers_.torque.begin(), numbers_.torque.end(),
              std::numeric_limits<double>::infinity());
  }

  double operator()(const std::vector<double>& q, double permitted = 0.7) {
    double sum = 0;
    for_each_force(q, [&](const drive::DrivenCoordinate& coordinate, double force) {
      const double share = force / coordinate.effort;
      sum += share > permitted ? (share - permitted) * (share - permitted) : 0;
    });
    return sum;
  }

  /// Calls visit(coordinate, |force|) for each joint with a limit.
  template <class Visit>
  void for_each_force(const std::vector<double>& q, Visit&& visit) {
    rest_at(q);
    for (const drive::DrivenCoordinate& coordinate : robot_.coordinates) {
      if (!drive::is_single(coordinate) || !std::isfinite(coordinate.effort)) continue;
      const int index = layout_.tau + coordinate.velocity_index;
      visit(coordinate, std::fabs(report_[static_cast<std::size_t>(index)]));
    }
  }

  /// z of the operational points together, m.
  double height(const std::vector<double>& q) {
    rest_at(q);
    double sum = 0;
    for (int k = 0; k < library_.points; ++k) {
      sum += report_[static_cast<std::size_t>(layout_.point_poses + 7 * k + 2)];
    }
    return sum;
  }

 private:
  /// Fills the report with that of a first cycle at `q`, in which the robot holds its weight.
  void rest_at(const std::vector<double>& q) {
    drive::LoopOptions options = options_for(robot_, numbers_, q);
    options.real_time = false;
    void* const loop = library_.create(&options);
    library_.step(loop);
    drive::ReportHead head;
    library_.receive(loop, &head, report_.data());
    library_.destroy(loop);
  }

  const drive::RobotLibrary& library_;
  const drive::RobotDescription& robot_;
  LoopNumbers numbers_;
  drive::ReportLayout layout_;
  std::vector<double> report_;
};

/// Places to try for a joint: its range, or a turn, in eight steps.
std::vector<double> candidates(const drive::DrivenCoordinate& coordinate) {
  constexpr int kSteps = 8;
  const bool bounded = std::isfinite(coordinate.upper - coordinate.lower);
  if (!bounded && !drive::is_angle(coordinate)) return {};
  const double lower = bounded ? coordinate.lower : -std::numbers::pi;
  const double upper = bounded ? coordinate.upper : std::numbers::pi;
  const double margin = 0.05 * (upper - lower);
  std::vector<double> places;
  for (int i = 0; i <= kSteps; ++i) {
    places.push_back(lower + margin + (upper - lower - 2 * margin) * i / kSteps);
  }
  return places;
}

}  // namespace

bool holds_weight(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                  const std::vector<double>& q, double share) {
  return !(Overload(library, robot)(q, share) > 0);
}

double height_of_points(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                        const std::vector<double>& q) {
  return Overload(library, robot).height(q);
}

std::string describe_overload(const drive::RobotLibrary& library,
                              const drive::RobotDescription& robot, const std::vector<double>& q) {
  constexpr std::size_t kMostNames = 4;
  std::vector<std::pair<double, std::string>> joints;  // by share of the limit
  Overload(library, robot)
      .for_each_force(q, [&](const drive::DrivenCoordinate& coordinate, double force) {
        if (!(force > coordinate.effort)) return;
        joints.emplace_back(
            force / coordinate.effort,
            fmt::format("{} needs {:.3g} of {:g} {}", coordinate.name, force, coordinate.effort,
                        drive::is_angle(coordinate) ? "N m" : "N"));
      });
  std::stable_sort(joints.begin(), joints.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (std::size_t i = 0; i < std::min(joints.size(), kMostNames); ++i) {
    text += (i == 0 ? "" : ", ") + joints[i].second;
  }
  if (joints.size() > kMostNames) {
    text += fmt::format(", and {} more", joints.size() - kMostNames);
  }
  return text;
}

std::string free_weak_robot(const drive::RobotLibrary& library, drive::RobotDescription& robot,
                            const std::vector<double>& q) {
  const std::string weak = describe_overload(library, robot, q);
  for (drive::DrivenCoordinate& coordinate : robot.coordinates) {
    if (!weak.empty()) coordinate.effort = std::numeric_limits<double>::infinity();
  }
  return weak;
}

std::optional<std::vector<double>> find_holdable_start(const drive::RobotLibrary& library,
                                                       const drive::RobotDescription& robot,
                                                       const std::vector<double>& start,
                                                       const AdmitsStart& admits) {
  constexpr int kSweeps = 3;
  Overload overload(library, robot);
  if (!(overload(start, 1.0) > 0)) return std::nullopt;
  std::vector<double> best = start;
  double least = overload(best);
  for (int sweep = 0; sweep < kSweeps && least > 0; ++sweep) {
    for (std::size_t i = 0; i < best.size() && least > 0; ++i) {
      if (!drive::is_single(robot.coordinates[i])) continue;
      std::vector<double> q = best;
      for (const double place : candidates(robot.coordinates[i])) {
        q[i] = place;
        const double now = overload(q);
        if (!(now < least) || !admits(q)) continue;
        least = now;
        best = q;
      }
    }
  }
  return best;
}

}  // namespace treeline
