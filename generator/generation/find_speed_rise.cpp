#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "emission/controller_unit.hpp"
#include "generation/compose.hpp"
#include "generation/warnings.hpp"
#include "recursion/methods/inverse_dynamics.hpp"
#include "recursion/methods/mass_matrix.hpp"
#include "recursion/methods/ordinary_states.hpp"

namespace treeline {

double find_speed_rise(const Mechanism& mechanism,
                       const std::vector<ControllerUnit::Joint>& joints) {
  constexpr double kShare = 0.5;
  constexpr double kLongest = 10;  // s, the most that a scene may state
  const auto tree = tree_of<double>(mechanism, {});
  std::vector<std::vector<double>> seconds(joints.size());
  for (int state = 0; state < kOrdinaryStates; ++state) {
    const auto X = joint_transforms<double>(tree, ordinary_state(mechanism, state));
    const auto gravity = inverse_dynamics<double>(tree, X, {}, {});
    const auto M = mass_matrix(tree, X);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const double torque = joints[i].torque;
      double momentum = 0;
      for (std::size_t k = 0; k < joints.size(); ++k) {
        if (std::isfinite(joints[k].speed)) momentum += std::abs(M(i, k)) * joints[k].speed;
      }
      const double left = std::max(torque - std::abs(gravity[i]), 0.1 * torque);
      seconds[i].push_back(std::isfinite(torque) ? momentum / (kShare * left) : 0);
    }
  }
  double longest = 0;
  for (const auto& each : seconds) longest = std::max(longest, median(each));
  return std::min(std::ceil(longest * 100) / 100, kLongest);  // the same on every host
}

void warn_of_speed_rise(const Scene& scene, const Generation& generation,
                        Diagnostics& diagnostics) {
  if (!generation.controller || !scene.controller) return;
  const double asked = scene.controller->speed_rise;
  const double emitted = generation.controller->settings.speed_rise;
  const int line = scene.controller->speed_rise_line;
  if (line == 0 || !(emitted > asked)) return;
  diagnostics.add(
      {Severity::warning, scene.file, line, "controller/speed_rise",
       fmt::format("{} s is asked for, and {} s is emitted: joints that rise to their limits of "
                   "speed sooner take more than half of the torque that gravity leaves the motors",
                   asked, emitted),
       fmt::format("write speed_rise: {}, or lower the limits of speed (key limits)", emitted)});
}

}  // namespace treeline
