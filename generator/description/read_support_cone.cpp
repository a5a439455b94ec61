#include <fmt/format.h>

#include <algorithm>

#include "description/read_keys.hpp"

namespace treeline {
namespace {

/// A number above `least`, or `least` too if `or_equal`; what a fault was reported of is 1.
double read_size(const SceneElement& element, bool or_equal, const char* remedy) {
  const auto number = element.number();
  if (!number) return 1;
  if (*number > 0 || (or_equal && *number == 0)) return *number;
  element.error(fmt::format("{} is {}", *number, or_equal ? "negative" : "not positive"), remedy);
  return 1;
}

void need_rows(const SceneElement& element, const ScenePoint& held, std::size_t first,
               std::size_t last, const char* what, const char* rows) {
  if (std::all_of(held.rows.begin() + static_cast<std::ptrdiff_t>(first),
                  held.rows.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                  [](bool row) { return row; })) {
    return;
  }
  element.error(fmt::format("{} is about forces in the rows {}, which \"{}\" does not hold all",
                            what, rows, held.name),
                fmt::format("add {} to its rows, or remove the key", rows));
}

std::optional<std::array<double, 2>> read_half_extents(const SceneElement& element) {
  const std::vector<SceneElement> items = element.items();
  if (items.size() != 2) {
    element.error(fmt::format("{} numbers are given", items.size()),
                  "write [x, y]: half lengths of the support along its axes, m");
    return std::nullopt;
  }
  constexpr const char* kRemedy = "half a length is positive, m";
  return std::array{read_size(items[0], false, kRemedy), read_size(items[1], false, kRemedy)};
}

}  // namespace

void read_support_cone(const SceneElement& item, const SceneFields& fields, const ScenePoint& held,
                       Scene& scene) {
  const auto friction = fields.find("friction");
  if (friction == fields.end()) {
    for (const char* key : kConeKeys) {
      if (!fields.contains(key)) continue;
      item.error(fmt::format("the key \"{}\" has no effect without friction", key),
                 "add friction, the ratio of tangential to normal force, or remove the key");
    }
    return;
  }
  SceneCone cone;
  cone.constraint = held.name;
  cone.friction =
      read_size(friction->second, false, "give the ratio of tangential to normal force");
  need_rows(friction->second, held, 0, 2, "friction", "x y z");
  if (const auto found = fields.find("sides"); found != fields.end()) {
    cone.sides = found->second.choice({"4", "8"}).value_or(0) == 1 ? 8 : 4;
  }
  if (const auto found = fields.find("least_force"); found != fields.end()) {
    cone.least_force = read_size(found->second, true, "a support cannot pull; give N, 0 or more");
  }
  if (const auto found = fields.find("torsional"); found != fields.end()) {
    cone.torsional = read_size(found->second, false, "give the ratio of moment to force, m");
    need_rows(found->second, held, 5, 5, "torsional", "rz");
  }
  if (const auto found = fields.find("half_extents"); found != fields.end()) {
    cone.half_extents = read_half_extents(found->second);
    need_rows(found->second, held, 3, 4, "half_extents", "rx ry");
  }
  scene.cones.push_back(std::move(cone));
}

}  // namespace treeline
