#include "description/read_surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/parse_yaml.hpp"
#include "description/read_scene_point.hpp"

namespace treeline {
namespace {

constexpr std::size_t kMostListed = 64;  // of obstacles and of points: a loop looks at all pairs

/// A length that is positive; an error and `fallback` for any other.
double read_length(const SceneElement& element, double fallback) {
  const double value = element.number().value_or(fallback);
  if (value > 0) return value;
  element.error(fmt::format("{} is not positive", value), "give it in metres");
  return fallback;
}

void read_sphere(const SceneElement& element, SceneShape& shape) {
  const SceneFields fields = element.fields({"radius"});
  const auto radius = fields.find("radius");
  if (radius == fields.end()) {
    element.error("the key \"radius\" is missing", "write sphere: {radius: m}");
    return;
  }
  shape.radius = read_length(radius->second, 1);
}

void read_box(const SceneElement& element, SceneShape& shape) {
  const SceneFields fields = element.fields({"size"});
  const auto size = fields.find("size");
  if (size == fields.end()) {
    element.error("the key \"size\" is missing", "write box: {size: [x, y, z]}, its edges in m");
    return;
  }
  shape.size = size->second.three_numbers().value_or(std::array<double, 3>{1, 1, 1});
  if (*std::min_element(shape.size.begin(), shape.size.end()) > 0) return;
  size->second.error("an edge is not positive", "give the lengths of its edges in m");
}

/// Reads the keys `sphere`, `box` and `origin` of `what`, which has exactly one of the first two.
void read_shape(const SceneElement& element, const SceneFields& fields, const char* what,
                SceneShape& shape) {
  const auto sphere = fields.find("sphere");
  const auto box = fields.find("box");
  if ((sphere == fields.end()) == (box == fields.end())) {
    element.error(fmt::format("{} is one sphere or one box", what),
                  "write sphere: {radius: m} or box: {size: [x, y, z]}");
  }
  if (sphere != fields.end()) read_sphere(sphere->second, shape);
  if (box != fields.end()) read_box(box->second, shape);
  if (const auto origin = fields.find("origin"); origin != fields.end()) {
    shape.origin = read_origin(origin->second);
  }
}

SceneObstacle read_obstacle(const SceneElement& element) {
  SceneObstacle obstacle;
  const SceneFields fields = element.fields({"name", "sphere", "box", "origin", "avoid"});
  obstacle.name = read_point_name(element, fields);
  read_shape(element, fields, "an obstacle", obstacle);
  if (const auto avoid = fields.find("avoid"); avoid != fields.end()) {
    obstacle.avoided = avoid->second.choice({"true", "false"}).value_or(0) == 0;
  }
  return obstacle;
}

/// The key `shapes` of an object, whose other keys `read_objects` reads.
std::vector<SceneShape> read_object_shapes(const SceneElement& object) {
  std::vector<SceneShape> shapes;
  if (!object.is_map()) return shapes;
  for (const auto& [key, element] : object.entries()) {
    if (key != "shapes") continue;
    for (const SceneElement& item : element.items()) {
      shapes.emplace_back();
      read_shape(item, item.fields({"sphere", "box", "origin"}), "a shape", shapes.back());
    }
  }
  return shapes;
}

void read_obstacles(const SceneElement& element, SceneSurroundings& surroundings) {
  for (const SceneElement& item : element.items()) {
    SceneObstacle obstacle = read_obstacle(item);
    const bool taken =
        std::any_of(surroundings.obstacles.begin(), surroundings.obstacles.end(),
                    [&](const SceneObstacle& other) { return other.name == obstacle.name; });
    if (taken && !obstacle.name.empty()) {
      item.error(fmt::format("the name \"{}\" is already taken in this list", obstacle.name),
                 "give each a name of its own");
    }
    surroundings.obstacles.push_back(std::move(obstacle));
  }
  if (surroundings.obstacles.size() > kMostListed) {
    element.error(fmt::format("{} obstacles are listed", surroundings.obstacles.size()),
                  fmt::format("list at most {}", kMostListed));
  }
}

void read_guards(const SceneElement& element, const Robot& robot, SceneAvoidance& avoidance) {
  for (const SceneElement& item : element.items()) {
    SceneGuard guard;
    const SceneFields fields = item.fields({"link", "xyz"});
    if (const auto link = fields.find("link"); link != fields.end()) {
      guard.link = read_known_link(link->second, robot);
    } else {
      item.error("the key \"link\" is missing", "name the link that keeps away");
    }
    if (const auto xyz = fields.find("xyz"); xyz != fields.end()) {
      guard.xyz = xyz->second.three_numbers().value_or(guard.xyz);
    }
    const bool repeated =
        std::any_of(avoidance.points.begin(), avoidance.points.end(), [&](const SceneGuard& other) {
          return other.link == guard.link && other.xyz == guard.xyz;
        });
    if (repeated && !guard.link.empty()) item.error("this point is listed twice", "list it once");
    avoidance.points.push_back(std::move(guard));
  }
  if (avoidance.points.size() > kMostListed / 2) {
    element.error(fmt::format("{} points are listed", avoidance.points.size()),
                  fmt::format("list at most {}", kMostListed / 2));
  }
}

void read_avoidance(const SceneElement& element, const Robot& robot, SceneAvoidance& avoidance) {
  const SceneFields fields = element.fields({"reach", "clearance", "strength", "points"});
  if (const auto reach = fields.find("reach"); reach != fields.end()) {
    avoidance.reach = read_length(reach->second, avoidance.reach);
  }
  if (const auto clearance = fields.find("clearance"); clearance != fields.end()) {
    avoidance.clearance = clearance->second.number().value_or(avoidance.clearance);
    if (avoidance.clearance < 0) {
      clearance->second.error("this is negative", "give what is to stay free, in m");
    }
  }
  if (const auto strength = fields.find("strength"); strength != fields.end()) {
    avoidance.strength = read_length(strength->second, avoidance.strength);
  }
  if (const auto points = fields.find("points"); points != fields.end()) {
    read_guards(points->second, robot, avoidance);
  }
}

SceneGround read_ground(const SceneElement& element) {
  SceneGround ground;
  const SceneFields fields = element.fields({"friction", "restitution", "step"});
  if (const auto friction = fields.find("friction"); friction != fields.end()) {
    ground.friction = friction->second.number().value_or(ground.friction);
    if (ground.friction < 0) {
      friction->second.error("this is negative", "give Coulomb's coefficient, 0 without friction");
    }
  }
  if (const auto restitution = fields.find("restitution"); restitution != fields.end()) {
    ground.restitution = restitution->second.number().value_or(ground.restitution);
    if (ground.restitution < 0 || ground.restitution > 1) {
      restitution->second.error("this is not between 0 and 1",
                                "give 0 where blows end the approach, 1 where they reverse it");
    }
  }
  if (const auto step = fields.find("step"); step != fields.end()) {
    ground.step = step->second.choice({"false", "true"}) == 1;
  }
  return ground;
}

}  // namespace

SceneSurroundings read_surroundings(const SceneFields& fields, const Robot& robot) {
  SceneSurroundings surroundings;
  const auto objects = fields.find("objects");
  if (objects != fields.end() && objects->second.is_list()) {
    for (const SceneElement& object : objects->second.items()) {
      surroundings.shapes.push_back(read_object_shapes(object));
    }
  }
  if (const auto ground = fields.find("ground"); ground != fields.end()) {
    surroundings.ground = read_ground(ground->second);
  }
  if (const auto obstacles = fields.find("obstacles"); obstacles != fields.end()) {
    read_obstacles(obstacles->second, surroundings);
  }
  if (const auto avoidance = fields.find("avoidance"); avoidance != fields.end()) {
    read_avoidance(avoidance->second, robot, surroundings.avoidance);
    if (surroundings.obstacles.empty()) {
      avoidance->second.error("there are no obstacles to avoid", "list obstacles, or remove this");
    }
  }
  return surroundings;
}

SceneSurroundings surroundings_of(const std::string& scene_text, const Robot& robot) {
  Diagnostics said;  // when the scene was read
  const auto document = parse_yaml(scene_text, "", said);
  if (!document || !document->IsMap()) return {};
  SceneReading reading{"", said};
  SceneFields fields;
  for (const auto& [key, element] : SceneElement(*document, "", reading).entries()) {
    fields.insert({key, element});
  }
  return read_surroundings(fields, robot);
}

}  // namespace treeline
