#include "description/read_urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "description/confirm_with_urdfdom.hpp"
#include "description/inertias.hpp"
#include "description/parse_xml.hpp"
#include "description/read_robot_text.hpp"
#include "description/urdf_element.hpp"
#include "description/urdf_parts.hpp"
#include "description/xml_faults.hpp"

namespace treeline {
namespace {

struct Elements {
  std::vector<UrdfElement> links;
  std::vector<UrdfElement> joints;
  std::vector<UrdfElement> loops;
  std::vector<UrdfElement> constraints;
};

void check_version(const UrdfElement& robot) {
  if (!robot.has("version")) return;
  const std::string text = robot.xml().Attribute("version");
  int major = 0, minor = 0;
  const char* const end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, major);
  const bool has_major = first.ec == std::errc{} && text.front() != '-';
  const bool has_point = has_major && first.ptr != end && *first.ptr == '.';
  const bool has_minor = has_point && first.ptr + 1 != end && first.ptr[1] != '-' &&
                         std::from_chars(first.ptr + 1, end, minor).ptr == end;
  if (!has_major || (first.ptr != end && !has_minor) || major > 1) {
    robot.error(fmt::format("version=\"{}\" is not a version of URDF that is known", text),
                "write version=\"1.0\" or leave it out");
  } else if (major != 1 || minor != 0 || !has_minor) {
    robot.warn(fmt::format("version=\"{}\" is read as version 1.0", text),
               "write version=\"1.0\" or leave it out", Minor::form);
  }
}

/// Elements that would make another mechanism than the tree of links and joints.
bool changes_mechanism(std::string_view name) {
  const auto colon = name.find(':');
  const bool foreign = colon != std::string_view::npos;
  const std::string_view local = foreign ? name.substr(colon + 1) : name;
  if (local == "loop_joint" || local == "loop" || local == "constraint") return true;
  if (local.ends_with("_constraint") || local.ends_with("_loop_joint")) return true;
  return foreign && (local == "joint" || local == "link");
}

void read_other(const UrdfElement& robot, const UrdfElement& element) {
  constexpr std::array<std::string_view, 8> kSilent = {
      "material", "transmission", "sensor", "frame", "group", "ros2_control", "mujoco", "gazebo"};
  const std::string_view name = element.name();
  if (name.starts_with("xacro:")) return;  // see find_leftover_xacro
  if (changes_mechanism(name)) {
    element.error(
        fmt::format("<{}> is not part of URDF and changes the mechanism", name),
        "write a tree of links and joints of URDF, and close loops by constraints in the scene");
    return;
  }
  if (name == "gazebo" && element.xml().FirstChildElement("joint") != nullptr) {
    element.warn("a joint inside <gazebo> is ignored; loops of the mechanism stay open",
                 "be sure that the open tree is the robot you mean");
  }
  if (std::find(kSilent.begin(), kSilent.end(), name) != kSilent.end()) return;
  robot.pass_over_child(element, {"link", "joint"});
}

/// Drake writes joints that are not of URDF under a name of its own.
bool is_ball_of_drake(const UrdfElement& element) {
  const char* type = element.xml().Attribute("type");
  return element.name() == "drake:joint" && type != nullptr && std::string_view(type) == "ball";
}

Elements list_elements(const UrdfElement& robot) {
  Elements elements;
  for (const auto* xml = robot.xml().FirstChildElement(); xml; xml = xml->NextSiblingElement()) {
    const UrdfElement element = robot.as_child(*xml);
    if (element.name() == "link") {
      elements.links.push_back(element);
    } else if (element.name() == "joint" || is_ball_of_drake(element)) {
      elements.joints.push_back(element);
    } else if (is_loop_joint(element)) {
      elements.loops.push_back(element);
    } else if (is_constraint(element)) {
      elements.constraints.push_back(element);
    } else {
      read_other(robot, element);
    }
  }
  return elements;
}

/// False, with an error, if two of these elements have one name: joints then name no one link.
bool have_own_names(const std::vector<UrdfElement>& elements, const char* what) {
  std::map<std::string_view, int> lines;
  bool own = true;
  for (const UrdfElement& element : elements) {
    const char* const name = element.xml().Attribute("name");
    if (name == nullptr || *name == '\0') continue;
    const auto [first, is_new] = lines.try_emplace(name, element.line());
    if (is_new) continue;
    own = false;
    element.error(fmt::format("a {} of this name is already in line {}", what, first->second),
                  fmt::format("give each {} a name of its own", what));
  }
  return own;
}

void read_head(const UrdfElement& robot, Robot& result) {
  const char* const remedy = "write <robot name=\"...\">";
  if (robot.has("name") && *robot.xml().Attribute("name") == '\0') {
    robot.warn("the robot's name is empty", remedy, Minor::form);
  } else {
    result.name = robot.required_name(remedy);
  }
  robot.only_attributes({"name", "version"});
  robot.no_text();
  check_version(robot);
}

std::optional<Robot> read_robot(const UrdfElement& element, UrdfReading& reading) {
  Robot robot;
  robot.file = reading.file();
  read_head(element, robot);
  const Elements elements = list_elements(element);
  if (elements.links.empty()) element.error("the robot has no <link>", "describe its links");
  if (elements.links.size() > kMostLinks) {
    element.error(
        fmt::format("the robot has {} links, more than {}", elements.links.size(), kMostLinks),
        "describe a smaller robot");
  }
  if (elements.joints.size() > kMostLinks) {
    element.error(
        fmt::format("the robot has {} joints, more than {}", elements.joints.size(), kMostLinks),
        "describe a smaller robot");
  }
  if (reading.failed()) return std::nullopt;
  for (const UrdfElement& link : elements.links) robot.links.push_back(read_link(link));
  std::vector<NamedJoint> joints;
  for (const UrdfElement& joint : elements.joints) joints.push_back(read_joint(joint));
  const bool own_links = have_own_names(elements.links, "link");
  const bool own_joints = have_own_names(elements.joints, "joint");
  if (!own_links || !own_joints) return std::nullopt;
  connect_tree(joints, elements.links, robot, reading);
  for (const UrdfElement& loop : elements.loops) read_loop_joint(loop, robot);
  for (const UrdfElement& each : elements.constraints) read_constraint_hint(each, robot);
  find_closing_frames(robot, reading);
  if (reading.failed()) return std::nullopt;
  if (!resolve_mimics(joints, robot)) return std::nullopt;
  fold_follower_limits(joints, robot);
  read_rotors(element, robot.joints);
  if (reading.failed()) return std::nullopt;
  if (!confirm_with_urdfdom(robot, joints, elements.links, reading)) return std::nullopt;
  check_inertias(robot, elements.links);
  check_motion(robot, elements.links, reading);
  return robot;
}

void warn_of_entities(const std::string& text, UrdfReading& reading) {
  const auto entities = find_undefined_entities(text);
  if (!entities) return;
  const std::string more =
      entities->count > 1 ? fmt::format(" (and {} more)", entities->count - 1) : "";
  reading.report(Severity::warning, entities->line, "",
                 fmt::format("the attribute \"{}\" has {}, which no one defines; it is read as "
                             "these characters{}",
                             entities->attribute, entities->first, more),
                 fmt::format("write out what it stands for, or &amp;{} if that is the text",
                             entities->first.substr(1)));
}

/// Reports xacro that was ignored: an error only where nothing else describes the robot.
void report_leftover(const LeftoverXacro& leftover, const std::string& file, bool is_robot,
                     Diagnostics& diagnostics) {
  if (is_robot) {
    diagnostics.add({Severity::warning, file, leftover.line, leftover.element,
                     "left over from xacro and passed over: " + leftover.fault,
                     "if that was meant to add links, joints or masses, " + leftover.remedy});
  } else {
    diagnostics.add({Severity::error, file, leftover.line, leftover.element,
                     "this is xacro text, not yet a URDF: " + leftover.fault, leftover.remedy});
  }
}

}  // namespace

std::optional<Robot> parse_urdf(const std::string& text, const std::string& file_name,
                                Diagnostics& diagnostics) {
  tinyxml2::XMLDocument document;
  const auto* root = parse_urdf_xml(text, file_name, document, diagnostics);
  if (root == nullptr) return std::nullopt;
  Diagnostics xacro;
  const LeftoverXacro leftover = find_leftover_xacro(*root, file_name, xacro);
  for (const Diagnostic& diagnostic : xacro.list()) diagnostics.add(diagnostic);
  if (xacro.has_errors()) return std::nullopt;
  if (leftover.line > 0 && root->FirstChildElement("link") == nullptr) {
    report_leftover(leftover, file_name, false, diagnostics);
    return std::nullopt;
  }
  UrdfReading reading(file_name, diagnostics);
  warn_of_entities(text, reading);
  declare_world(*document.RootElement(), reading);
  check_looks({*root, "robot", reading});
  auto robot = read_robot({*root, "robot", reading}, reading);
  reading.report_passed_over();
  if (leftover.line > 0) report_leftover(leftover, file_name, robot.has_value(), diagnostics);
  return robot;
}

std::optional<Robot> read_urdf(const std::string& path, Diagnostics& diagnostics) {
  const auto text = read_robot_text(path, diagnostics);
  if (!text) return std::nullopt;
  return parse_robot(*text, diagnostics);
}

}  // namespace treeline
