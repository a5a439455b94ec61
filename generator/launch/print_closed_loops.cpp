#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "description/rotation.hpp"
#include "description/scene_queries.hpp"
#include "launch/print_robot.hpp"

namespace treeline {
namespace {

int count_rows(const ScenePoint& point) {
  return static_cast<int>(std::count(point.rows.begin(), point.rows.end(), true));
}

int count_world_rows(const Scene& scene) {
  int rows = 0;
  for (const ScenePoint& point : scene.constraints) rows += count_rows(point);
  return rows;
}

int count_rows(const Scene& scene) {
  int rows = count_world_rows(scene) + static_cast<int>(scene.couplings.size());
  for (const SceneLoop& loop : scene.loops) rows += count_rows(loop.second);
  return rows;
}

std::string print_numbers(const double* numbers, int count) {
  return fmt::format("{{{}}}", fmt::join(numbers, numbers + count, ", "));
}

std::string print_world_holds(const Scene& control, const Scene& links) {
  std::string holds;
  for (const ScenePoint& point : control.constraints) {
    const auto link = std::find_if(links.operational_points.begin(), links.operational_points.end(),
                                   [&](const ScenePoint& each) { return each.link == point.link; });
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> R =
        rotation_from_rpy<double>(point.origin.rpy);
    std::string rows;
    for (const bool row : point.rows) rows += row ? "true, " : "false, ";
    holds +=
        fmt::format("      {{{}, {}, {}, {{{}}}, {}}},\n", link - links.operational_points.begin(),
                    print_numbers(point.origin.xyz.data(), 3), print_numbers(R.data(), 9), rows,
                    point.axes == Axes::local ? "true" : "false");
  }
  return "  static constexpr treeline::drive::WorldHold kWorldHolds[] = {\n" + holds + "  };\n";
}

/// Effective masses that count as too heavy for a row of the task to move, kg or kg m^2.
std::string print_effective_mass_limits(const Scene& control) {
  constexpr double kNoLimit = 1e9;
  std::string limits;
  for (const ScenePoint& point : control.operational_points) {
    for (std::size_t row = 0; row < point.rows.size(); ++row) {
      if (!point.rows[row]) continue;
      const double stated = !control.damped ? kNoLimit
                            : row < 3       ? control.damped->mass
                                            : control.damped->inertia;
      limits += fmt::format("{}, ", stated);
    }
  }
  return fmt::format("  static constexpr double kEffectiveMassLimits[] = {{{}}};\n", limits);
}

std::string print_call(const char* function, const char* arguments, const char* input) {
  return fmt::format(
      "  static void {0}(const double (&q)[kCoordinates], const double (&qd)[kVelocities],\n"
      "                  const double (&{2})[kVelocities]{3}, double (&output)[kVelocities]) "
      "noexcept {{\n"
      "    treeline::drive::ClosedLoops<Robot>::{0}(q, qd, {1}, output);\n  }}\n",
      function, arguments, input,
      std::string(function) == "control_torque" ? ", const double (&xdd)[kTaskRows]" : "");
}

}  // namespace

bool is_held_to_world(const Scene& scene) {
  return !scene.constraints.empty() ||
         std::any_of(scene.loops.begin(), scene.loops.end(),
                     [](const SceneLoop& loop) { return loop.second.link == kWorldEnd; });
}

std::vector<int> unmotored_velocities(const Scene& scene, const Mechanism& mechanism) {
  std::vector<int> velocities;
  for (const MovingLink& link : mechanism.links) {
    if (link.mimics) continue;
    const bool is_base = scene.base == Base::floating && link.v_index == 0;
    const bool listed =
        std::find(scene.passive.begin(), scene.passive.end(), link.joint) != scene.passive.end();
    if (!listed && !(is_base && is_held_to_world(scene))) continue;
    for (int i = 0; i < (link.kind == JointKind::floating ? 6 : 1); ++i) {
      velocities.push_back(link.v_index + i);
    }
  }
  return velocities;
}

std::string print_closed_loops(const Scene& control, const Mechanism& mechanism,
                               const Scene& links) {
  const std::vector<int> passive = unmotored_velocities(control, mechanism);
  std::string marks;
  for (int i = 0; i < mechanism.nv(); ++i) {
    marks += std::count(passive.begin(), passive.end(), i) > 0 ? "true, " : "false, ";
  }
  // An array needs an entry; where no joint is passive it is not read.
  const std::string listed = passive.empty() ? "0" : fmt::format("{}", fmt::join(passive, ", "));
  std::string text = fmt::format(
      "  static constexpr int kHeldRows = {};\n  static constexpr int kWorldRows = {};\n"
      "  static constexpr int kPassiveCount = {};\n"
      "  static constexpr int kPassiveVelocities[] = {{{}}};\n"
      "  static constexpr bool kPassive[] = {{{}}};\n",
      count_rows(control), count_world_rows(control), passive.size(), listed, marks);
  if (!control.constraints.empty()) text += print_world_holds(control, links);
  text += print_call("inverse_dynamics", "input", "input") +
          print_call("forward_dynamics", "input, nullptr", "input");
  if (!control.operational_points.empty()) {
    text +=
        print_effective_mass_limits(control) + print_call("control_torque", "input, xdd", "input");
  }
  return text;
}

}  // namespace treeline
