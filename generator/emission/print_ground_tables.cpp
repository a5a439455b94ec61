#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "emission/backend.hpp"
#include "emission/body_steps.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/print_files.hpp"

namespace treeline {
namespace {

/// Whole numbers, or those of a place.
struct GroundTable {
  const char* name;
  std::vector<int> whole = {};
  std::vector<double> numbers = {};
};

void append_three(std::vector<double>& numbers, const std::array<double, 3>& v) {
  numbers.insert(numbers.end(), v.begin(), v.end());
}

/// `TL_TABLE real TL_GROUND_RADII[3] = {1.0, 2.0, 3.0};`
std::string print_ground_table(const Syntax& syntax, const GroundTable& table) {
  std::vector<std::string> entries;
  for (const int entry : table.whole) entries.push_back(std::to_string(entry));
  for (const double entry : table.numbers) {
    entries.push_back(signed_literal(syntax, entry));
  }
  const char* const type = table.numbers.empty() ? "int32_t" : "real";
  return print_table(fmt::format("TL_TABLE {} TL_GROUND_{}", type, table.name), std::move(entries),
                     0) +
         "\n";
}

/// Where parts begin in a list of all, and at last where they end.
class GroundPlaces {
 public:
  explicit GroundPlaces(const char* name) : table_{name, {0}} {}
  void add(std::size_t count) {
    table_.whole.push_back(table_.whole.back() + static_cast<int>(count));
  }
  [[nodiscard]] const GroundTable& table() const { return table_; }

 private:
  GroundTable table_;
};

std::vector<GroundTable> list_shapes(const GroundUnit& unit) {
  GroundPlaces shapes_of("SHAPES_OF");
  GroundPlaces points_of("POINTS_OF");
  GroundTable tips{"TIPS"}, balls{"BALLS"}, radii{"RADII"}, axes{"AXES"}, levels{"LEVELS"},
      points{"POINTS"};
  for (const GroundUnit::Group& group : unit.groups) {
    tips.whole.push_back(group.tip);
    shapes_of.add(group.shapes.size());
    append_three(balls.numbers, group.around.middle);
    balls.numbers.push_back(group.around.radius);
    for (const GroundUnit::Shape& shape : group.shapes) {
      points_of.add(shape.points.size());
      radii.numbers.push_back(shape.radius);
      append_three(axes.numbers, shape.axis);
      append_three(levels.numbers, shape.level);
      for (const auto& point : shape.points) append_three(points.numbers, point);
    }
  }
  return {tips, shapes_of.table(), balls, points_of.table(), radii, axes, levels, points};
}

/// The path from the root that ends with a velocity.
std::vector<int> path_to(const GroundUnit& unit, int velocity) {
  std::vector<int> path = unit.before[static_cast<std::size_t>(velocity)];
  path.push_back(velocity);
  return path;
}

/// How many velocities move both of each two groups.
GroundTable list_shared(const GroundUnit& unit) {
  GroundTable shared{"SHARED"};
  for (const GroundUnit::Group& one : unit.groups) {
    for (const GroundUnit::Group& other : unit.groups) {
      const std::vector<int> a = path_to(unit, one.tip);
      const std::vector<int> b = path_to(unit, other.tip);
      const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
      shared.whole.push_back(static_cast<int>(end - a.begin()));
    }
  }
  return shared;
}

std::vector<GroundTable> list_paths(const GroundUnit& unit) {
  GroundPlaces factor_at("FACTOR_AT");
  GroundTable before{"BEFORE"};
  for (const std::vector<int>& each : unit.before) {
    factor_at.add(each.size());
    before.whole.insert(before.whole.end(), each.begin(), each.end());
  }
  return {factor_at.table(), before, list_shared(unit)};
}

GroundTable list_turns(const GroundUnit& unit) {
  GroundTable turns{"QUATERNIONS"};
  for (const GroundUnit::Turn& turn : unit.turns) {
    turns.whole.insert(turns.whole.end(), {turn.q, turn.v, turn.slides ? 1 : 0});
  }
  return turns;
}

/// Points of a group, those of rims four times.
int count_points(const GroundUnit::Group& group) {
  std::size_t count = 0;
  for (const GroundUnit::Shape& shape : group.shapes) {
    const bool is_rim = shape.axis != std::array<double, 3>{};
    count += shape.points.size() * (is_rim ? 4 : 1);
  }
  return static_cast<int>(count);
}

}  // namespace

std::string print_ground_sizes(const GroundUnit& unit, const Adaptation& own) {
  int most_points = 0;
  for (const GroundUnit::Group& group : unit.groups) {
    most_points = std::max(most_points, count_points(group));
  }
  std::size_t entries = 0;
  for (const std::vector<int>& each : unit.before) entries += each.size();
  const Constant sizes[] = {
      {"GROUND_COORDINATES", unit.coordinates, ""},
      {"GROUND_VELOCITIES", static_cast<int>(unit.before.size()), ""},
      {"GROUND_GROUPS", static_cast<int>(unit.groups.size()), "of links that move as one"},
      {"GROUND_MOST_POINTS", most_points, "of one group"},
      {"GROUND_TURNS", static_cast<int>(unit.turns.size()), "joints with a quaternion"},
      {"GROUND_FACTOR", std::max(static_cast<int>(entries), 1), "entries of L, at least one"}};
  return print_constants(own, sizes);
}

std::string print_ground_tables(const EmissionContext& context, const GroundUnit& unit) {
  const Syntax syntax = backend_of(context.language).syntax(context);
  std::vector<GroundTable> tables = list_shapes(unit);
  for (GroundTable& table : list_paths(unit)) tables.push_back(std::move(table));
  tables.push_back(list_turns(unit));
  std::string text;
  for (const GroundTable& table : tables) text += print_ground_table(syntax, table);
  return text;
}

}  // namespace treeline
