#include "inspect/propose_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "description/group_bodies.hpp"
#include "description/scene_queries.hpp"
#include "inspect/end_names.hpp"
#include "inspect/recognise_robot.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

constexpr std::size_t kMostPoints = 8;
constexpr double kFrameMass = 1e-6;  ///< kg, that exporters give to links that are mere frames

/// A link that may get an operational point.
struct End {
  int body = 0;
  int link = 0;
  EndName name;
  bool at_joint = false;  ///< at the joint before it, since the file has no frame at the tip
};

/// What the choice of ends looks at.
struct Tree {
  const Robot& robot;
  BodyTree bodies;
  std::vector<bool> is_frame;     ///< by link: without mass and without links behind it
  std::set<std::string> meeting;  ///< links that are only to meet another and close a loop

  explicit Tree(const Robot& of)
      : robot(of), bodies(group_bodies(of)), is_frame(of.links.size(), true) {
    for (const Joint& joint : robot.joints) {
      is_frame[static_cast<std::size_t>(joint.parent)] = false;
    }
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      const auto& inertial = robot.links[i].inertial;
      if (inertial && inertial->mass > kFrameMass) is_frame[i] = false;
    }
    for (const LoopHint& hint : robot.hints.loops) {
      meeting.insert({hint.loop.first.link, hint.loop.second.link});
    }
  }

  [[nodiscard]] const Body& body(int b) const { return bodies.bodies[static_cast<std::size_t>(b)]; }
  /// Whether a link is a frame that somebody placed for another purpose than a loop.
  [[nodiscard]] bool is_placed(int link) const {
    return is_frame[static_cast<std::size_t>(link)] && !meeting.contains(name(link));
  }
  /// Whether a body is a rod to where a loop closes: its one frame is of that kind.
  [[nodiscard]] bool is_rod(const Body& of) const {
    const auto meets = [&](int link) { return meeting.contains(name(link)); };
    const auto placed = [&](int link) { return is_placed(link); };
    return std::count_if(of.links.begin(), of.links.end(), meets) == 1 &&
           std::none_of(of.links.begin(), of.links.end(), placed);
  }
  [[nodiscard]] const std::string& name(int link) const {
    return robot.links[static_cast<std::size_t>(link)].name;
  }
};

/// The first link of a body, or the first with mass where that is only a frame that carries it.
int carried_link(const Tree& tree, const Body& body) {
  const auto has_mass = [&](int link) {
    const auto& inertial = tree.robot.links[static_cast<std::size_t>(link)].inertial;
    return inertial && inertial->mass > kFrameMass;
  };
  const auto found = std::find_if(body.links.begin(), body.links.end(), has_mass);
  return body.parent < 0 || found == body.links.end() ? body.links.front() : *found;
}

/// The frame without mass that lies farthest from the body's joint; else the link that has the
/// body's mass. Frames of sensors do not count.
int tip_of(const Tree& tree, const Body& body) {
  const auto place = [&](int link) {
    return tree.bodies.frames[static_cast<std::size_t>(link)].translation();
  };
  int tip = carried_link(tree, body);
  double farthest = 1e-3;
  for (const int link : body.links) {
    const double distance = (place(link) - place(body.links.front())).norm();
    if (!tree.is_placed(link) || is_sensor(tree.name(link))) continue;
    if (distance <= farthest) continue;
    farthest = distance;
    tip = link;
  }
  return tip;
}

/// The link of the body with the best name; of equal names a frame without mass, which somebody
/// placed for this, of tools the farthest, and the shortest name; the tip if no name is known.
End best_of(const Tree& tree, int index) {
  const Body& body = tree.body(index);
  const auto frame = [&](int link) { return tree.is_placed(link); };
  const auto place = [&](int link) {
    return tree.bodies.frames[static_cast<std::size_t>(link)].translation();
  };
  End best{index, body.links.front(), end_name(tree.name(body.links.front()))};
  const EndName own = best.name;
  if (is_sensor(tree.name(best.link))) best.name = {};
  for (const int link : body.links) {
    const EndName name = end_name(tree.name(link));
    if (name.kind >= EndKind::other || is_sensor(tree.name(link))) continue;
    const auto key = [&](const EndName& of, int at) {
      const double reach = (place(at) - place(body.links.front())).norm();
      return std::tuple(of.kind, of.rank, !frame(at), of.kind == EndKind::tool ? -reach : 0,
                        tree.name(at).size());
    };
    if (key(name, link) < key(best.name, best.link)) best = {index, link, name};
  }
  if (best.name.kind >= EndKind::other) best = {index, tip_of(tree, body), own};
  best.at_joint =
      best.link == body.links.front() ||
      (best.name.kind >= EndKind::other && place(best.link) == place(body.links.front()));
  return best;
}

/// What the role of a limb says of its end where the end's own name does not.
EndKind kind_of(LimbRole role, EndKind named) {
  switch (role) {
    case LimbRole::leg:
      return named >= EndKind::tip ? EndKind::foot : named;
    case LimbRole::arm:
      return named > EndKind::other ? EndKind::other : named;
    case LimbRole::finger:
      return EndKind::tip;
    case LimbRole::wheel:
      return EndKind::wheel;
    case LimbRole::propeller:
      return EndKind::propeller;
    case LimbRole::watching:
    case LimbRole::surface:
    case LimbRole::trunk:
      return EndKind::watching;
    case LimbRole::unknown:
      return named;
  }
  return named;
}

/// The link that carries the jaw where the last joint of an arm moves only that, by names alone: a
/// jaw looks like one more link of the arm.
std::optional<End> gripper_before(const Tree& tree, const Limb& limb) {
  if (limb.carries_fingers || limb.joints <= 3) return std::nullopt;
  const auto is_of_gripper = [&](int link) {
    return tree.name(link).find("gripper") != std::string::npos;
  };
  const Joint& last = tree.robot.joints[static_cast<std::size_t>(tree.body(limb.last).joint)];
  const int before = tree.body(limb.last).parent;
  const int own = tree.body(limb.last).links.front();
  const auto& links = tree.body(before).links;
  const auto holder = std::find_if(links.begin(), links.end(), is_of_gripper);
  if (holder != links.end() && is_of_gripper(own)) return End{before, *holder, {}, false};
  const bool moves_a_jaw =
      limb_word(tree.name(own)) == LimbRole::finger ||
      (end_name(last.name).kind == EndKind::hand && end_name(tree.name(own)).kind > EndKind::hand);
  if (moves_a_jaw) return best_of(tree, before);
  return std::nullopt;
}

/// Finds the link for a point of a limb: its end, or the body before it with the best name.
End end_for(const Tree& tree, const Limb& limb) {
  End best = best_of(tree, limb.last);
  best.name.kind = kind_of(limb.role, best.name.kind);
  const bool moves_itself = limb.role == LimbRole::finger || limb.role >= LimbRole::wheel;
  if (moves_itself || limb.role == LimbRole::watching) return best;
  for (int b = tree.body(limb.last).parent; b > 0; b = tree.body(b).parent) {
    const End other = best_of(tree, b);
    const bool known = other.name.kind < EndKind::tip;
    if (known && other.name.kind < best.name.kind) best = other;
  }
  return best.body == limb.last ? gripper_before(tree, limb).value_or(best) : best;
}

bool is_worth_a_point(const End& end) {
  return end.name.kind <= EndKind::other;
}

/// Chooses the ends that get points, in the order of the tree. Heads and cameras get one only if
/// nothing else does, and nothing floats that could.
std::vector<End> choose_ends(const std::vector<End>& all, bool is_held) {
  std::vector<End> chosen;
  const bool any = !is_held || std::any_of(all.begin(), all.end(), is_worth_a_point);
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

/// Whether a limb is only a joint or two that hang on the way to an end, such as springs and
/// covers, or a body that lies beside the robot, unless its name is one of an end.
bool is_minor(const Tree& tree, int base, const Limb& limb) {
  if (best_of(tree, limb.last).name.kind != EndKind::other) return false;
  if (limb.role == LimbRole::unknown) return limb.joints <= 2 || limb.masses == 1;
  const bool on_the_way = tree.body(limb.first).parent > base && limb.joints == 1;
  return (on_the_way || limb.is_side_branch) &&
         (limb.role == LimbRole::leg || limb.role == LimbRole::arm);
}

/// An end for each limb, in the order of the tree. A minor one gets no point where there are
/// whole limbs, and one that ends where a loop closes none where there are others.
std::vector<End> find_ends(const Tree& tree, const RecognisedRobot& found) {
  std::vector<Limb> limbs = found.limbs;
  const auto is_rod = [&](const Limb& limb) { return tree.is_rod(tree.body(limb.last)); };
  if (!std::all_of(limbs.begin(), limbs.end(), is_rod)) std::erase_if(limbs, is_rod);
  const bool whole = std::any_of(limbs.begin(), limbs.end(), [&](const Limb& limb) {
    return limb.role == LimbRole::leg || limb.role == LimbRole::arm || limb.joints > 2 ||
           best_of(tree, limb.last).name.kind == EndKind::tip;
  });
  std::map<int, End> ends;
  for (const Limb& limb : limbs) {
    End end = end_for(tree, limb);
    if (whole && is_minor(tree, found.base, limb)) end.name.kind = EndKind::watching;
    const auto [at, added] = ends.emplace(end.body, end);
    if (!added && end.name.kind < at->second.name.kind) at->second = end;
  }
  std::vector<End> list;
  for (const auto& [body, end] : ends) list.push_back(end);
  return list;
}

/// Where the foot at an end touches the ground; nothing of other ends.
std::optional<FootPlace> place_of(const Tree& tree, const End& end,
                                  const std::vector<TouchShape>& shapes) {
  const auto gravity = tree.robot.hints.gravity.value_or(Scene{}.gravity);
  const Eigen::Vector3d down(gravity[0], gravity[1], gravity[2]);
  if (end.name.kind != EndKind::foot || down.isZero()) return std::nullopt;
  return place_foot(tree.robot, tree.bodies, tree.body(end.body), -down.normalized(), shapes);
}

/// Moves a point, whose frame is that of its link, to a place in the axes of the root.
void move_to(const Tree& tree, const End& end, const Eigen::Vector3d& place, ScenePoint& point) {
  const auto& frame = tree.bodies.frames[static_cast<std::size_t>(end.link)];
  const Eigen::Vector3d at = frame.inverse() * place;
  for (int i = 0; i < 3; ++i) {
    point.origin.xyz[static_cast<std::size_t>(i)] = std::round(at[i] * 1e5) / 1e5 + 0.0;  // no -0
  }
}

void guess_base(const Robot& robot, const RecognisedRobot& found, std::optional<Base> asked,
                SceneProposal& proposal) {
  const std::string& root = robot.links[static_cast<std::size_t>(robot.root)].name;
  const auto take = [&](Base base, const std::string& reason) {
    proposal.base = base;
    proposal.base_reason = reason;
  };
  proposal.kind = found.kind;
  if (asked) {
    take(*asked, "as asked for");
  } else if (default_base(robot) == Base::floating) {
    take(Base::floating, why_floating(robot));
  } else if (is_ground(root)) {
    take(Base::fixed, fmt::format("the root link is called \"{}\"", root));
  } else {
    take(found.floats ? Base::floating : Base::fixed, found.reason);
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
std::vector<std::string> joints_beyond(const Tree& tree, const std::set<int>& pointed) {
  std::vector<std::string> names;
  for (std::size_t b = 1; b < tree.bodies.bodies.size(); ++b) {
    const Body& body = tree.bodies.bodies[b];
    const Joint& joint = tree.robot.joints[static_cast<std::size_t>(body.joint)];
    if (joint.mimic || !info_of(joint.type).has_one_freedom()) continue;
    for (int a = body.parent; a > 0; a = tree.body(a).parent) {
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

SceneProposal propose_scene(const Robot& robot, std::optional<Base> base,
                            const std::vector<TouchShape>& shapes) {
  SceneProposal proposal;
  const Tree tree(robot);
  const RecognisedRobot found = recognise_robot(robot, tree.bodies);
  const std::vector<End> ends = find_ends(tree, found);
  guess_base(robot, found, base, proposal);
  const bool floats = proposal.base == Base::floating || found.base > 0;
  std::vector<End> chosen = choose_ends(ends, !floats);
  if (chosen.empty() && floats) {
    chosen.push_back({found.base, tree.body(found.base).links.front(), {}, false});
  }
  std::set<int> pointed;
  for (const End& end : chosen) {
    ScenePoint point;
    point.link = tree.name(end.link);
    point.name = point_name(point.link, proposal.points);
    proposal.points.push_back(point);
    pointed.insert(end.body);
    const auto place = place_of(tree, end, shapes);
    const bool without_frame = end.at_joint && end.link == tree.body(end.body).links.front();
    if (place && without_frame) move_to(tree, end, place->at, proposal.points.back());
    if (end.at_joint) {
      proposal.remarks[point.link] =
          !place || !without_frame ? "at a joint: the file has no frame at the tip"
          : place->is_of_balls ? "where its ball touches the ground: the file has no frame there"
                               : "where it collides with the ground: the file has no frame there";
    }
    if (end.name.kind == EndKind::foot && proposal.base == Base::floating) {
      proposal.feet.push_back(proposal.points.back());
      if (place && place->is_of_balls) move_to(tree, end, place->at, proposal.feet.back());
    }
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
    proposal.left_out.push_back(tree.name(end.link));
  }
  proposal.beyond = joints_beyond(tree, pointed);
  return proposal;
}

}  // namespace treeline
