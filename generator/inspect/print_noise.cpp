#include "inspect/print_noise.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/noise.hpp"
#include "mechanism/build_mechanism.hpp"

namespace treeline {
namespace {

/// Limit for suggestions: rounding errors of programs that computed with a few digits less.
constexpr double kCoarse = 1e-12;

std::string print_line(const NoiseDecision& decision) {
  const std::string place =
      decision.line > 0 ? fmt::format("line {}", decision.line) : std::string("-");
  return fmt::format("  {:<10} {:<10.1e} {}: {}\n", place, decision.change, decision.element,
                     decision.text);
}

/// Says what a wider limit would change, if it would change more.
std::string print_suggestion(const Robot& robot, const Scene& scene, std::size_t taken) {
  if (scene.noise >= kCoarse) return "";
  Scene wide = scene;
  wide.noise = kCoarse;
  NoiseDecisions decisions;
  const NoiseLimits limits = noise_limits(robot, wide);
  without_noise(robot, limits, &decisions);
  without_noise(scene, limits, &decisions);
  if (decisions.size() <= taken) return "";
  return fmt::format(
      "Used as written, though within {:.0e} of an exact number: {}. `noise: {:.0e}` in the scene\n"
      "takes them as exact too, which saves operations.\n",
      kCoarse, decisions.size() - taken, kCoarse);
}

}  // namespace

std::string print_noise(const Robot& robot, const Scene& scene) {
  const NoiseLimits limits = noise_limits(robot, scene);
  NoiseDecisions of_numbers;
  without_noise(robot, limits, &of_numbers);
  without_noise(scene, limits, &of_numbers);
  const NoiseDecisions decisions = reduced_mechanism(robot, scene).noise;
  std::string text =
      scene.noise == 0
          ? "`noise: keep`: every number is used as written.\n"
          : fmt::format("Taken as exact: {} that differ by at most {:.2g} rad, {:.2g} m.\n",
                        decisions.size(), limits.angle, limits.length);
  if (!decisions.empty()) text += "  where      change     what\n";
  for (const NoiseDecision& decision : decisions) text += print_line(decision);
  return text + print_suggestion(robot, scene, of_numbers.size());
}

}  // namespace treeline
