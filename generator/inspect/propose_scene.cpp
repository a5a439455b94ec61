#include "inspect/propose_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "description/count_freedoms.hpp"
#include "description/default_base.hpp"
#include "inspect/choose_rows.hpp"
#include "inspect/end_names.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

constexpr std::size_t kMostPoints = 6;

/// Links that move as one, in the order of the tree. The first one carries the others.
struct Body {
  std::vector<int> links;
  int parent = -1;  ///< index of a body
  int joint = -1;   ///< the joint that moves it
  bool is_leaf = true;
};

class Bodies {
 public:
  explicit Bodies(const Robot& robot) : robot_(robot), children_(robot.links.size()) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      children_[static_cast<std::size_t>(robot.joints[j].parent)].push_back(static_cast<int>(j));
    }
    bodies.push_back({});
    std::vector<std::pair<int, int>> stack{{robot.root, 0}};  // link and its body
    while (!stack.empty()) {
      const auto [link, body] = stack.back();
      stack.pop_back();
      bodies[static_cast<std::size_t>(body)].links.push_back(link);
      const auto& joints = children_[static_cast<std::size_t>(link)];
      for (auto j = joints.rbegin(); j != joints.rend(); ++j) {
        stack.emplace_back(robot.joints[static_cast<std::size_t>(*j)].child, body_behind(*j, body));
      }
    }
  }

  std::vector<Body> bodies;

 private:
  int body_behind(int j, int body) {
    if (robot_.joints[static_cast<std::size_t>(j)].type == JointType::fixed) return body;
    bodies[static_cast<std::size_t>(body)].is_leaf = false;
    bodies.push_back({{}, body, j, true});
    return static_cast<int>(bodies.size()) - 1;
  }

  const Robot& robot_;
  std::vector<std::vector<int>> children_;
};

/// A link that may get an operational point.
struct End {
  int body = 0;
  int link = 0;
  EndName name;
};

bool is_better(const EndName& a, const EndName& b) {
  return a.kind != b.kind ? a.kind < b.kind : a.rank < b.rank;
}

/// The link of the body with the best name; the first link if no name is known.
End best_of(const Robot& robot, const Body& body, int index) {
  End best{index, body.links.front(), {}};
  best.name = end_name(robot.links[static_cast<std::size_t>(best.link)].name);
  const EndName own = best.name;
  for (const int link : body.links) {
    const EndName name = end_name(robot.links[static_cast<std::size_t>(link)].name);
    if (name.kind < EndKind::other && is_better(name, best.name)) best = {index, link, name};
  }
  return best.name.kind < EndKind::other ? best : End{index, body.links.front(), own};
}

/// Finds the link for a point at a leaf of the tree: the leaf itself, or the body before it with
/// the best name.
End end_for(const Robot& robot, const std::vector<Body>& bodies, int leaf) {
  End best = best_of(robot, bodies[static_cast<std::size_t>(leaf)], leaf);
  for (int b = bodies[static_cast<std::size_t>(leaf)].parent; b > 0;
       b = bodies[static_cast<std::size_t>(b)].parent) {
    const End other = best_of(robot, bodies[static_cast<std::size_t>(b)], b);
    const bool known = other.name.kind < EndKind::tip;
    if (known && other.name.kind < best.name.kind) best = other;
  }
  return best;
}

bool is_worth_a_point(const End& end) {
  return end.name.kind <= EndKind::other;
}

/// Chooses the ends that get points, in the order of the tree. Heads and cameras get one only if
/// nothing else does.
std::vector<End> choose_ends(const std::vector<End>& all) {
  std::vector<End> chosen;
  const bool any = std::any_of(all.begin(), all.end(), is_worth_a_point);
  for (const End& end : all) {
    if (is_worth_a_point(end) || (!any && end.name.kind == EndKind::watching)) {
      chosen.push_back(end);
    }
  }
  if (chosen.size() <= kMostPoints) return chosen;
  std::vector<End> best = chosen;
  std::stable_sort(best.begin(), best.end(),
                   [](const End& a, const End& b) { return a.name.kind < b.name.kind; });
  best.resize(kMostPoints);
  std::sort(best.begin(), best.end(), [](const End& a, const End& b) { return a.body < b.body; });
  return best;
}

std::vector<End> find_ends(const Robot& robot, const std::vector<Body>& bodies) {
  std::map<int, End> ends;
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    if (!bodies[b].is_leaf) continue;
    const End end = end_for(robot, bodies, static_cast<int>(b));
    ends.emplace(end.body, end);
  }
  std::vector<End> list;
  for (const auto& [body, end] : ends) list.push_back(end);
  return list;
}

/// Whether a body hangs by one joint on the path to an end whose name is known, such as a spring or
/// a cover.
bool is_beside_the_way(const End& end, const std::vector<End>& ends,
                       const std::vector<Body>& bodies) {
  const int before = bodies[static_cast<std::size_t>(end.body)].parent;
  if (end.name.kind != EndKind::other || before <= 0) return false;
  return std::any_of(ends.begin(), ends.end(), [&](const End& other) {
    if (other.name.kind >= EndKind::other) return false;
    for (int b = other.body; b > 0; b = bodies[static_cast<std::size_t>(b)].parent) {
      if (b == before) return true;
    }
    return false;
  });
}

void guess_base(const Robot& robot, const std::vector<End>& ends, std::optional<Base> asked,
                SceneProposal& proposal) {
  const std::string& root = robot.links[static_cast<std::size_t>(robot.root)].name;
  const auto number = [&](EndKind kind) {
    return std::count_if(ends.begin(), ends.end(),
                         [kind](const End& end) { return end.name.kind == kind; });
  };
  const auto take = [&](Base base, const std::string& reason) {
    proposal.base = base;
    proposal.base_reason = reason;
  };
  if (asked) {
    take(*asked, "as asked for");
  } else if (default_base(robot) == Base::floating) {
    take(Base::floating, why_floating(robot));
  } else if (is_ground(root)) {
    take(Base::fixed, fmt::format("the root link is called \"{}\"", root));
  } else if (number(EndKind::foot) >= 2) {
    take(Base::floating, "the robot has feet");
  } else if (number(EndKind::propeller) >= 2) {
    take(Base::floating, "the robot has propellers");
  } else if (!ends.empty() && number(EndKind::wheel) == static_cast<long>(ends.size())) {
    take(Base::floating, "wheels are all that moves");
  } else {
    take(Base::fixed, fmt::format("the root link \"{}\" is taken as held by the ground", root));
  }
}

std::string point_name(const std::string& link, const std::vector<ScenePoint>& points) {
  const std::string name = identifier_from(link);
  const auto is_free = [&](const std::string& candidate) {
    return std::none_of(points.begin(), points.end(),
                        [&](const ScenePoint& point) { return point.name == candidate; });
  };
  for (int i = 2; !is_free(name); ++i) {
    const std::string numbered = fmt::format("{}{}{}", name, name.ends_with('_') ? "" : "_", i);
    if (is_free(numbered)) return numbered;
  }
  return name;
}

/// Joints of one degree of freedom beyond the bodies that have points.
std::vector<std::string> joints_beyond(const Robot& robot, const std::vector<Body>& bodies,
                                       const std::set<int>& pointed) {
  std::vector<std::string> names;
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(bodies[b].joint)];
    if (joint.mimic || !info_of(joint.type).has_one_freedom()) continue;
    for (int a = bodies[b].parent; a > 0; a = bodies[static_cast<std::size_t>(a)].parent) {
      if (!pointed.contains(a)) continue;
      names.push_back(joint.name);
      break;
    }
  }
  return names;
}

bool has_rows(const ScenePoint& point) {
  return std::any_of(point.rows.begin(), point.rows.end(), [](bool row) { return row; });
}

}  // namespace

SceneProposal propose_scene(const Robot& robot, std::optional<Base> base) {
  SceneProposal proposal;
  const std::vector<Body> bodies = Bodies(robot).bodies;
  const std::vector<End> ends = find_ends(robot, bodies);
  guess_base(robot, ends, base, proposal);
  std::vector<End> candidates = ends;
  std::erase_if(candidates, [&](const End& end) { return is_beside_the_way(end, ends, bodies); });
  std::vector<End> chosen = choose_ends(candidates);
  if (ends.empty() && proposal.base == Base::floating) {
    chosen.push_back(best_of(robot, bodies.front(), 0));
  }
  std::set<int> pointed;
  for (const End& end : chosen) {
    const std::string& link = robot.links[static_cast<std::size_t>(end.link)].name;
    ScenePoint point;
    point.name = point_name(link, proposal.points);
    point.link = link;
    proposal.points.push_back(point);
    pointed.insert(end.body);
  }
  Scene scene;
  scene.base = proposal.base;
  choose_rows(robot, scene, proposal.points);
  for (const ScenePoint& point : proposal.points) {
    if (!has_rows(point)) proposal.left_out.push_back(point.link);
  }
  std::erase_if(proposal.points, [](const ScenePoint& point) { return !has_rows(point); });
  for (const End& end : ends) {
    if (pointed.contains(end.body)) continue;
    proposal.left_out.push_back(robot.links[static_cast<std::size_t>(end.link)].name);
  }
  proposal.beyond = joints_beyond(robot, bodies, pointed);
  return proposal;
}

}  // namespace treeline
