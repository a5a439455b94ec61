#include "description/effective_mass_limits.hpp"

namespace treeline {

std::vector<double> effective_mass_limits(const Scene& scene) {
  std::vector<double> limits;
  if (!scene.damped) return limits;
  const auto rounded = [&scene](double x) {
    return scene.real == Real::float32 ? static_cast<double>(static_cast<float>(x)) : x;
  };
  for (const ScenePoint& point : scene.operational_points) {
    for (std::size_t row = 0; row < point.rows.size(); ++row) {
      if (!point.rows[row]) continue;
      limits.push_back(rounded(row < 3 ? scene.damped->mass : scene.damped->inertia));
    }
  }
  return limits;
}

}  // namespace treeline
