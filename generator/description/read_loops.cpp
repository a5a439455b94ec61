#include "description/read_loops.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/list_links.hpp"

namespace treeline {
namespace {

constexpr const char* kEnds =
    "write <link1 link=\"...\" xyz=\"...\" rpy=\"...\"/> and <link2 .../>";

RobotLoop::End read_end(const UrdfElement& element, const char* name, const Robot& robot) {
  RobotLoop::End end;
  const auto found = element.child(name);
  if (!found) {
    element.error(fmt::format("<{}> is missing", name), kEnds);
    return end;
  }
  found->holds_only_attributes({"link", "xyz", "rpy"});
  const auto link = found->required_text("link", kEnds);
  end.origin.xyz = found->three_numbers("xyz").value_or(end.origin.xyz);
  end.origin.rpy = found->three_numbers("rpy").value_or(end.origin.rpy);
  if (!link) return end;
  end.link = *link;
  if (std::none_of(robot.links.begin(), robot.links.end(),
                   [&](const Link& each) { return each.name == end.link; })) {
    found->error(fmt::format("there is no link \"{}\"", end.link), suggest_link(end.link, robot));
  }
  return end;
}

}  // namespace

bool is_loop_joint(const UrdfElement& element) {
  return element.name() == "loop_joint" && element.xml().FirstChildElement("link1") != nullptr;
}

void read_loop_joint(const UrdfElement& element, Robot& robot) {
  element.only_attributes({"name", "type"});
  RobotLoop loop;
  loop.name = element.required_name("give it a name");
  const auto type = element.required_text("type", "write type=\"spherical\" or type=\"fixed\"");
  loop.holds_turns = type == "fixed";
  if (type && *type != "spherical" && *type != "fixed") {
    element.error(fmt::format("type=\"{}\" does not say along which axes it holds", *type),
                  "remove it here, and write it under constraints in the scene, with rows");
  }
  loop.first = read_end(element, "link1", robot);
  loop.second = read_end(element, "link2", robot);
  const auto same = [&](const RobotLoop& other) { return other.name == loop.name; };
  if (std::any_of(robot.loops.begin(), robot.loops.end(), same)) {
    element.error("a loop of this name is already there", "give each loop a name of its own");
  }
  robot.loops.push_back(std::move(loop));
}

}  // namespace treeline
