#include "description/read_scene_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "description/read_number.hpp"
#include "description/robot_queries.hpp"
#include "description/scene_queries.hpp"
#include "text/identifier.hpp"

namespace treeline {

std::string read_point_name(const SceneElement& point, const SceneFields& fields) {
  const auto found = fields.find("name");
  if (found == fields.end()) {
    point.error("the key \"name\" is missing", "give the point a name");
    return {};
  }
  const auto name = found->second.text();
  if (name && !is_identifier(*name)) {
    found->second.error(fmt::format("\"{}\" cannot be a name in emitted code", *name),
                        fmt::format("write {}", identifier_from(*name)));
  }
  return name.value_or("");
}

std::string read_known_link(const SceneElement& element, const Robot& robot) {
  const auto name = element.text();
  if (!name) return {};
  const bool known = std::any_of(robot.links.begin(), robot.links.end(),
                                 [&](const Link& link) { return link.name == *name; });
  if (!known) {
    element.error(fmt::format("the robot has no link \"{}\"", *name), suggest_link(*name, robot));
  }
  return *name;
}

Axes read_axes(const SceneElement& element) {
  return element.choice({"world", "local"}) == 1 ? Axes::local : Axes::world;
}

std::array<bool, 6> read_rows(const SceneElement& element) {
  static const std::vector<std::string> kRows(kRowNames.begin(), kRowNames.end());
  std::array<bool, 6> rows{};
  const std::vector<SceneElement> items = element.items();
  if (items.empty())
    element.error("no row is listed", "list some of x y z rx ry rz, or leave out the key for all");
  if (items.size() > kRows.size()) {
    element.error(fmt::format("{} rows are listed", items.size()),
                  "list each of x y z rx ry rz once at most");
    return rows;
  }
  std::size_t next = 0;
  for (const SceneElement& item : items) {
    const auto row = item.choice(kRows);
    if (!row) continue;
    if (rows[*row]) {
      item.error(fmt::format("the row {} is listed twice", kRows[*row]), "list it once");
    } else if (*row < next) {
      item.error("the rows are not in their order", "the order is always x y z rx ry rz");
    }
    rows[*row] = true;
    next = *row + 1;
  }
  return rows;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<SceneElement> one_or_more(const SceneElement& element) {
  return element.is_list() ? element.items() : std::vector<SceneElement>{element};
}

const Link* find_moving_link(const SceneElement& element, const std::string& name,
                             const Robot& robot, const Scene& scene) {
  const auto link = std::find_if(robot.links.begin(), robot.links.end(),
                                 [&](const Link& each) { return each.name == name; });
  if (link == robot.links.end()) {
    element.error(fmt::format("the robot has no link \"{}\"", name), suggest_link(name, robot));
    return nullptr;
  }
  if (find_freedoms_of_link(robot, scene, name).empty()) {
    element.error(fmt::format("the link \"{}\" cannot move", name),
                  "name a link behind a joint that moves");
    return nullptr;
  }
  return &*link;
}

namespace {

std::string read_link_name(const SceneElement& point, const SceneFields& fields,
                           const Robot& robot) {
  const auto found = fields.find("link");
  if (found != fields.end()) return read_known_link(found->second, robot);
  point.error("the key \"link\" is missing", "name the link that carries the point");
  return {};
}

int read_priority(const SceneElement& element) {
  const double priority = element.number().value_or(1);
  if (priority >= 1 && priority <= 1000 && priority == std::floor(priority)) {
    return static_cast<int>(priority);
  }
  element.error(fmt::format("{} is no priority", priority),
                "write a whole number from 1 on; 1 comes first, equal ones share a level");
  return 1;
}

/// The rows of the centre of mass, and errors for what only frames on links have.
void read_center_of_mass(const SceneFields& fields, ScenePoint& point) {
  constexpr const char* kRemedy =
      "the centre of mass is on no link, and its rows are in world axes: leave out this key";
  for (const char* key : {"link", "origin"}) {
    if (const auto found = fields.find(key); found != fields.end()) {
      found->second.error(fmt::format("the centre of mass has no {}", key), kRemedy);
    }
  }
  if (point.axes == Axes::local) {
    fields.at("axes").error("the centre of mass has no axes of its own", kRemedy);
  }
  if (!fields.contains("rows")) point.rows = {true, true, true, false, false, false};
  if (point.rows[3] || point.rows[4] || point.rows[5]) {
    fields.at("rows").error("the centre of mass does not turn", "list some of x y z");
  }
}

ScenePoint read_point(const SceneElement& element, const Robot& robot,
                      const std::vector<std::string>& keys) {
  ScenePoint point;
  const SceneFields fields = element.fields(keys);
  point.name = read_point_name(element, fields);
  if (const auto center = fields.find("center_of_mass"); center != fields.end()) {
    point.center_of_mass = center->second.choice({"false", "true"}) == 1;
  }
  if (!point.center_of_mass) point.link = read_link_name(element, fields, robot);
  if (const auto origin = fields.find("origin"); origin != fields.end()) {
    point.origin = read_origin(origin->second);
  }
  if (const auto axes = fields.find("axes"); axes != fields.end()) {
    point.axes = read_axes(axes->second);
  }
  if (const auto rows = fields.find("rows"); rows != fields.end()) {
    point.rows = read_rows(rows->second);
  }
  if (const auto priority = fields.find("priority"); priority != fields.end()) {
    point.priority = read_priority(priority->second);
  }
  if (point.center_of_mass) read_center_of_mass(fields, point);
  return point;
}

std::vector<ScenePoint> read_points(const SceneElement& element, const Robot& robot,
                                    const std::vector<std::string>& keys) {
  std::vector<ScenePoint> points;
  for (const SceneElement& item : element.items()) {
    ScenePoint point = read_point(item, robot, keys);
    const auto same_name = [&](const ScenePoint& other) { return other.name == point.name; };
    if (!point.name.empty() && std::any_of(points.begin(), points.end(), same_name)) {
      item.error(fmt::format("the name \"{}\" is already taken in this list", point.name),
                 "give each a name of its own");
    }
    if (point.center_of_mass && std::any_of(points.begin(), points.end(), is_center_of_mass)) {
      item.error("the centre of mass is listed twice", "list all of its rows at one point");
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace

const Joint* find_joint(const SceneElement& element, const std::string& name, const Robot& robot) {
  for (const Joint& joint : robot.joints) {
    if (joint.name == name) return &joint;
  }
  element.error(fmt::format("the robot has no joint \"{}\"", name), suggest_joint(name, robot));
  return nullptr;
}

Pose read_origin(const SceneElement& element) {
  Pose pose;
  pose.line = element.line();
  if (element.is_list()) {
    element.error("a map is expected here, not a list",
                  "write {xyz: [x, y, z], rpy: [roll, pitch, yaw]}; either may be left out");
    return pose;
  }
  const SceneFields fields = element.fields({"xyz", "rpy"});
  if (const auto xyz = fields.find("xyz"); xyz != fields.end()) {
    pose.xyz = xyz->second.three_numbers().value_or(pose.xyz);
  }
  if (const auto rpy = fields.find("rpy"); rpy != fields.end()) {
    pose.rpy = rpy->second.three_numbers(true).value_or(pose.rpy);
    if (std::any_of(pose.rpy.begin(), pose.rpy.end(), is_beyond_a_turn)) {
      rpy->second.warn("this is more than a whole turn", kRadiansForDegrees);
    }
  }
  return pose;
}

std::vector<ScenePoint> read_operational_points(const SceneElement& element, const Robot& robot) {
  return read_points(element, robot,
                     {"name", "link", "center_of_mass", "origin", "rows", "axes", "priority"});
}

std::vector<ScenePoint> read_external_forces(const SceneElement& element, const Robot& robot) {
  return read_points(element, robot, {"name", "link", "origin", "axes"});
}

std::vector<ScenePoint> read_contacts(const SceneElement& element, const Robot& robot) {
  std::vector<ScenePoint> contacts = read_points(element, robot, {"name", "link", "origin"});
  for (ScenePoint& contact : contacts) {
    contact.rows = {true, true, true, false, false, false};
  }
  return contacts;
}

void read_passive(const SceneElement& element, const Robot& robot, Scene& scene) {
  for (const SceneElement& item : element.items()) {
    const auto name = item.text();
    const Joint* joint = name ? find_joint(item, *name, robot) : nullptr;
    if (joint == nullptr) continue;
    if (joint->mimic) {
      const Joint& followed = robot.joints[static_cast<std::size_t>(joint->mimic->joint)];
      item.error("a joint that mimics has no motor of its own",
                 fmt::format("name the joint it follows, \"{}\"", followed.name));
    } else if (!info_of(joint->type).moves() || scene.locked.contains(*name)) {
      item.error("this joint does not move", "remove it from the list");
    } else if (std::count(scene.passive.begin(), scene.passive.end(), *name) > 0) {
      item.error(fmt::format("{} is listed twice", *name), "list it once");
    }
    scene.passive.push_back(*name);
  }
}

void read_locked(const SceneElement& element, const Robot& robot, Scene& scene) {
  for (const auto& [name, value] : element.entries("write lines of the form joint: value")) {
    const Joint* joint = find_joint(value, name, robot);
    const bool angle = joint != nullptr && !info_of(joint->type).slides();
    const auto held = value.number(angle);
    if (joint == nullptr || !held) continue;
    if (joint->mimic) {
      const Joint& followed = robot.joints[static_cast<std::size_t>(joint->mimic->joint)];
      value.error("a joint that mimics has no value of its own",
                  fmt::format("lock the joint it follows, \"{}\"", followed.name));
    } else if (!info_of(joint->type).moves()) {
      value.error("a fixed joint has no value", "remove this line");
    } else if (!info_of(joint->type).has_one_freedom()) {
      value.error("only a joint of one degree of freedom can be locked",
                  "make the joint fixed in the robot's file");
    } else if (joint->limits && (*held < joint->limits->lower || *held > joint->limits->upper)) {
      value.warn(fmt::format("{} is outside the joint's limits, {} to {}", *held,
                             joint->limits->lower.value(), joint->limits->upper.value()),
                 "check the value and its unit: radians or metres");
    }
    scene.locked.emplace(name, *held);
  }
}

}  // namespace treeline
