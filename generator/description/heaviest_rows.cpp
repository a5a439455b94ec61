#include "description/heaviest_rows.hpp"

namespace treeline {

std::vector<double> heaviest_rows(const Scene& scene) {
  std::vector<double> heaviest;
  if (!scene.damped) return heaviest;
  const auto rounded = [&scene](double x) {
    return scene.real == Real::float32 ? static_cast<double>(static_cast<float>(x)) : x;
  };
  for (const ScenePoint& point : scene.operational_points) {
    for (std::size_t row = 0; row < point.rows.size(); ++row) {
      if (!point.rows[row]) continue;
      heaviest.push_back(rounded(row < 3 ? scene.damped->mass : scene.damped->inertia));
    }
  }
  return heaviest;
}

}  // namespace treeline
