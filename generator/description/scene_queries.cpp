#include "description/scene_queries.hpp"

#include "description/parse_yaml.hpp"
#include "description/urdf_parts.hpp"

namespace treeline {

std::string list_rows(const ScenePoint& point, std::string_view between) {
  std::string list;
  for (std::size_t i = 0; i < kRowNames.size(); ++i) {
    if (!point.rows[i]) continue;
    if (!list.empty()) list += between;
    list += kRowNames[i];
  }
  return list;
}

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

Base default_base(const Robot& robot) {
  if (robot.hints.floats) return Base::floating;
  const bool moves = !find_freedoms(robot, Scene{}).empty();
  return moves || !moves_inertia(robot) ? Base::fixed : Base::floating;
}

const char* why_floating(const Robot& robot) {
  return robot.hints.floats ? "the file says so" : "no joint moves";
}

const std::string& file_of_scene(const Scene& scene, const Robot& robot) {
  return scene.file.empty() ? robot.file : scene.file;
}

bool states_key(const std::string& scene_text, const std::string& key) {
  Diagnostics ignored;
  const auto document = parse_yaml(scene_text, "", ignored);
  return document && document->IsMap() && (*document)[key];
}

}  // namespace treeline
