#include <fmt/format.h>

#include <algorithm>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

constexpr const char* kBetween = "write between: [link, world] or between: [link, other link]";

/// Names of the two things that are held together. Empty texts where a fault was reported.
struct Ends {
  std::string link, other;
  [[nodiscard]] bool to_world() const { return other == "world"; }
};

Ends read_ends(const SceneElement& item, const SceneFields& fields, const Robot& robot) {
  const auto found = fields.find("between");
  if (found == fields.end()) {
    item.error("the key \"between\" is missing", kBetween);
    return {};
  }
  const std::vector<SceneElement> ends = found->second.items();
  if (ends.size() != 2) {
    found->second.error("two things are held together, no more and no less", kBetween);
    return {};
  }
  if (ends[0].is("world") && !ends[1].is("world")) {
    found->second.error("the world comes second", "write between: [link, world], the link first");
    return {};
  }
  const std::string link = read_known_link(ends[0], robot);
  return {link, ends[1].is("world") ? "world" : read_known_link(ends[1], robot)};
}

/// Reports a key that does not belong to this kind of constraint.
void refuse(const SceneFields& fields, const char* key, const char* fault, const char* remedy) {
  if (const auto found = fields.find(key); found != fields.end()) {
    found->second.error(fault, remedy);
  }
}

void read_pose(const SceneFields& fields, const char* key, Pose& pose) {
  if (const auto found = fields.find(key); found != fields.end()) {
    pose = read_origin(found->second);
  }
}

/// Rows that a kind of contact holds; its normal is z, and a line lies along x.
struct ContactKind {
  const char* name;
  std::array<bool, 6> rows;
};
constexpr std::array kContacts{ContactKind{"point", {true, true, true, false, false, false}},
                               ContactKind{"soft_finger", {true, true, true, false, false, true}},
                               ContactKind{"line", {true, true, true, false, true, true}},
                               ContactKind{"plane", {true, true, true, true, true, true}},
                               ContactKind{"rigid", {true, true, true, true, true, true}},
                               ContactKind{"frictionless_point", {false, false, true}},
                               ContactKind{"frictionless_line", {false, false, true, false, true}},
                               ContactKind{"frictionless_plane", {false, false, true, true, true}}};

/// The rows that are listed, or those of the kind of contact that is named.
void read_held_rows(const SceneFields& fields, ScenePoint& point) {
  const auto rows = fields.find("rows"), contact = fields.find("contact");
  if (rows != fields.end()) point.rows = read_rows(rows->second);
  if (contact == fields.end()) return;
  std::vector<std::string> names;
  for (const ContactKind& kind : kContacts) names.emplace_back(kind.name);
  if (const auto kind = contact->second.choice(names)) point.rows = kContacts[*kind].rows;
  if (rows != fields.end()) {
    contact->second.error("rows are given too", "write contact or rows, not both");
  } else if (fields.contains("rolling")) {
    contact->second.error("what rolls holds other rows", "write rows, or leave out both");
  }
}

SceneLoop read_loop(const SceneFields& fields, const ScenePoint& first, const std::string& other) {
  SceneLoop loop{first, first};
  loop.second.link = other;
  loop.second.axes = Axes::local;
  loop.second.origin = {};
  read_pose(fields, "other_origin", loop.second.origin);
  refuse(fields, "axes", "rows between two links are along the axes of the second frame",
         "leave out axes; turn other_origin where other axes are meant");
  if (fields.contains("rolling")) read_rolling(fields, loop);
  return loop;
}

/// Whether the keys of a cone, if any, are those that what rolls can have. Its rows are along the
/// axes of the second frame, in which a plane's normal stays what it is.
bool can_have_cone(const SceneLoop& loop, const SceneFields& fields) {
  if (!loop.rolling) return true;
  refuse(fields, "half_extents", "what rolls touches at a point, which has no extent",
         "remove the key");
  if (loop.rolling->on_radius) {
    refuse(fields, "friction", "the normal of two balls turns with them, and rows do not",
           "remove the key; on planes, what rolls can have friction");
  }
  return !fields.contains("half_extents") &&
         !(loop.rolling->on_radius && fields.contains("friction"));
}

bool is_taken(const Scene& scene, const std::string& name) {
  const auto in = [&](const auto& list, const auto& name_of) {
    return std::any_of(list.begin(), list.end(),
                       [&](const auto& each) { return name_of(each) == name; });
  };
  return in(scene.constraints, [](const ScenePoint& each) { return each.name; }) ||
         in(scene.loops, [](const SceneLoop& each) { return each.first.name; }) ||
         in(scene.couplings, [](const SceneCoupling& each) { return each.name; });
}

void check_name(const SceneElement& item, const std::string& name, const Scene& scene) {
  if (!name.empty() && is_taken(scene, name)) {
    item.error(fmt::format("the name \"{}\" is already taken by a constraint", name),
               "give each a name of its own");
  }
}

void read_constraint(const SceneElement& item, const Robot& robot, Scene& scene) {
  std::vector<std::string> known = {"name", "between", "origin",  "other_origin",
                                    "rows", "axes",    "contact", "rolling"};
  known.insert(known.end(), kConeKeys.begin(), kConeKeys.end());
  const SceneFields fields = item.fields(known);
  ScenePoint point;
  point.name = read_point_name(item, fields);
  const Ends ends = read_ends(item, fields, robot);
  point.link = ends.link;
  read_pose(fields, "origin", point.origin);
  read_held_rows(fields, point);
  check_name(item, point.name, scene);
  if (fields.contains("rolling") || !ends.to_world()) {
    SceneLoop loop = read_loop(fields, point, ends.other);
    if (can_have_cone(loop, fields)) read_support_cone(item, fields, loop.first, scene);
    scene.loops.push_back(std::move(loop));
    return;
  }
  refuse(fields, "other_origin", "the world's frame is where it is", "leave out other_origin");
  if (const auto axes = fields.find("axes"); axes != fields.end()) {
    point.axes = read_axes(axes->second);
  }
  read_support_cone(item, fields, point, scene);
  scene.constraints.push_back(std::move(point));
}

/// The joint and its factor, or nothing where a fault was reported.
void read_part(const std::string& name, const SceneElement& value, const Robot& robot,
               const Scene& scene, SceneCoupling& coupling) {
  const Joint* const joint = find_joint(value, name, robot);
  const auto factor = value.number();
  if (joint == nullptr || !factor) return;
  if (joint->mimic) {
    const Joint& followed = robot.joints[static_cast<std::size_t>(joint->mimic->joint)];
    value.error("a joint that mimics has no velocity of its own",
                fmt::format("couple the joint it follows, \"{}\"", followed.name));
  } else if (!info_of(joint->type).has_one_freedom() || scene.locked.contains(name)) {
    value.error("only a joint that moves in one degree of freedom can be coupled",
                "remove it from the coupling");
  } else if (*factor == 0) {
    value.error("the factor is 0", "remove the joint from the coupling");
  }
  coupling.parts.push_back({name, *factor});
}

}  // namespace

void read_constraints(const SceneElement& element, const Robot& robot, Scene& scene) {
  for (const SceneElement& item : element.items()) read_constraint(item, robot, scene);
}

void add_loops_of_robot(const Robot& robot, Scene& scene) {
  for (const RobotLoop& loop : robot.loops) {
    ScenePoint first{identifier_from(loop.name), loop.first.link, loop.first.origin};
    first.rows = loop.rows;
    ScenePoint second = first;
    second.link = loop.second.link;
    second.origin = loop.second.origin;
    second.axes = Axes::local;
    scene.loops.push_back({first, second});
  }
}

void read_couplings(const SceneElement& element, const Robot& robot, Scene& scene) {
  for (const SceneElement& item : element.items()) {
    const SceneFields fields = item.fields({"name", "joints", "offset"});
    SceneCoupling coupling;
    coupling.name = read_point_name(item, fields);
    if (const auto offset = fields.find("offset"); offset != fields.end()) {
      coupling.offset = offset->second.number().value_or(0);
    }
    const auto joints = fields.find("joints");
    if (joints == fields.end()) {
      item.error("the key \"joints\" is missing", "write joints: {joint: factor, joint: factor}");
      continue;
    }
    const auto parts = joints->second.entries("write lines joint: factor");
    if (joints->second.is_map() && parts.empty()) {
      joints->second.error("the coupling has no joint", "write joints: {joint: factor, ...}");
    }
    for (const auto& [name, value] : parts) read_part(name, value, robot, scene, coupling);
    check_name(item, coupling.name, scene);
    scene.couplings.push_back(std::move(coupling));
  }
}

}  // namespace treeline
