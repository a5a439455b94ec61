#include "overlaps/find_overlaps.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "drawing/recorded_motion.hpp"
#include "overlaps/collision_bodies.hpp"

namespace treeline::experiments {
namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
constexpr double kStep = 0.005;  // s
constexpr const char* kFloor = "floor";

/// A body as FCL has it.
struct Solid {
  CollisionBody body;
  Geometry geometry;
  double radius = 0;  ///< of a ball about it, m; infinite for the ground
};

Geometry geometry_of(const CollisionBody& body) {
  const Eigen::Vector3d& s = body.size;
  if (body.kind == VisualKind::sphere) return std::make_shared<fcl::Sphered>(s.x());
  if (body.kind == VisualKind::cylinder) return std::make_shared<fcl::Cylinderd>(s.x(), s.y());
  return std::make_shared<fcl::Boxd>(s);
}

double radius_of(const CollisionBody& body) {
  if (body.kind == VisualKind::sphere) return body.size.x();
  if (body.kind == VisualKind::cylinder) return std::hypot(body.size.x(), 0.5 * body.size.y());
  return 0.5 * body.size.norm();
}

/// The links that fixed joints make one body are one number.
std::vector<int> rigid_bodies(const Robot& robot) {
  std::vector<int> body(robot.links.size());
  for (std::size_t i = 0; i < body.size(); ++i) body[i] = static_cast<int>(i);
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed) continue;
    const int kept = body[static_cast<std::size_t>(joint.parent)];
    const int joined = body[static_cast<std::size_t>(joint.child)];
    std::replace(body.begin(), body.end(), joined, kept);
  }
  return body;
}

/// Whether two links are one body, or a joint connects their bodies.
bool are_neighbours(const Robot& robot, const std::vector<int>& rigid, int first, int second) {
  const auto of = [&](int link) { return rigid[static_cast<std::size_t>(link)]; };
  if (of(first) == of(second)) return true;
  return std::any_of(robot.joints.begin(), robot.joints.end(), [&](const Joint& joint) {
    const auto ends = std::minmax(of(joint.parent), of(joint.child));
    return ends == std::minmax(of(first), of(second));
  });
}

/// The name without an ending that it has; nothing if it has another.
std::optional<std::string> beginning(const std::string& name, const std::string& ending) {
  if (!name.ends_with(ending)) return std::nullopt;
  return name.substr(0, name.size() - ending.size());
}

bool fits(const std::string& pair, const std::string& first, const std::string& second) {
  const std::size_t colon = pair.find(':');
  if (colon == std::string::npos) return false;
  const auto a = beginning(first, pair.substr(0, colon));
  const auto b = beginning(second, pair.substr(colon + 1));
  return a && b && *a == *b;
}

bool is_left_out(const OverlapQuestion& question, const std::string& first,
                 const std::string& second) {
  return std::any_of(question.left_out.begin(), question.left_out.end(), [&](const auto& pair) {
    return fits(pair, first, second) || fits(pair, second, first);
  });
}

/// All that is asked about, read from the files.
struct Scenery {
  Robot robot;
  LinkPlacer placer;
  RecordedMotion motion;
  std::vector<Solid> solids;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

void add_floor(std::vector<Solid>& solids) {
  CollisionBody ground;
  ground.name = kFloor;
  solids.push_back({ground, std::make_shared<fcl::Halfspaced>(fcl::Vector3d::UnitZ(), 0.0),
                    std::numeric_limits<double>::infinity()});
}

void choose_pairs(const OverlapQuestion& question, Scenery& scenery) {
  const std::vector<int> rigid = rigid_bodies(scenery.robot);
  const auto may_overlap = [&](const CollisionBody& a, const CollisionBody& b) {
    if (a.carrier != b.carrier) return is_left_out(question, a.name, b.name);
    if (a.carrier != Carrier::link) return a.carrier == Carrier::world || a.name == b.name;
    return !question.itself || are_neighbours(scenery.robot, rigid, a.index, b.index) ||
           is_left_out(question, a.name, b.name);
  };
  for (std::size_t j = 0; j < scenery.solids.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (!may_overlap(scenery.solids[i].body, scenery.solids[j].body)) {
        scenery.pairs.emplace_back(i, j);
      }
    }
  }
}

std::optional<Scenery> read_scenery(const OverlapQuestion& question, Diagnostics& diagnostics) {
  auto read = read_robot_files(question.robot, question.scene, diagnostics);
  const auto scene = read ? parse_scene_of(*read, diagnostics) : std::nullopt;
  if (!scene) return std::nullopt;
  LinkPlacer placer(read->robot, *scene);
  auto motion = read_motion(question.motion, placer.joints(), placer.home(), diagnostics);
  if (!motion) return std::nullopt;
  std::vector<Solid> solids;
  for (const CollisionBody& body : collision_bodies(*read, *scene, diagnostics)) {
    solids.push_back({body, geometry_of(body), radius_of(body)});
  }
  if (solids.empty()) {
    diagnostics.add({Severity::error, read->robot.file, 0, "robot/link/collision",
                     "the robot has no shape by which it collides",
                     "Give its links boxes, cylinders or spheres as <collision>."});
    return std::nullopt;
  }
  if (question.floor) add_floor(solids);
  Scenery scenery{
      std::move(read->robot), std::move(placer), std::move(*motion), std::move(solids), {}};
  choose_pairs(question, scenery);
  return scenery;
}

/// How deep two solids are in each other, m; 0 if they are not.
double depth_of(const Solid& a, const Eigen::Isometry3d& at, const Solid& b,
                const Eigen::Isometry3d& other) {
  if ((at.translation() - other.translation()).norm() > a.radius + b.radius) return 0;
  constexpr std::size_t kContacts = 16;  // of two boxes
  fcl::CollisionResultd result;
  fcl::collide(a.geometry.get(), at, b.geometry.get(), other,
               fcl::CollisionRequestd(kContacts, true), result);
  double depth = 0;
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    depth = std::max(depth, result.getContact(i).penetration_depth);
  }
  return depth;
}

}  // namespace

std::vector<std::string> read_left_out(const std::string& path) {
  std::ifstream stream(path);
  std::vector<std::string> pairs;
  for (std::string line; std::getline(stream, line);) {
    const std::string pair = line.substr(0, line.find(' '));
    if (pair.find(':') != std::string::npos) pairs.push_back(pair);
  }
  return pairs;
}

std::optional<std::vector<Overlap>> find_overlaps(const OverlapQuestion& question,
                                                  Diagnostics& diagnostics) {
  const auto scenery = read_scenery(question, diagnostics);
  if (!scenery) return std::nullopt;
  const auto& solids = scenery->solids;
  std::vector<CollisionBody> bodies;
  for (const Solid& solid : solids) bodies.push_back(solid.body);
  std::map<std::pair<std::string, std::string>, Overlap> deepest;
  double next = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < scenery->motion.times.size(); ++k) {
    const double time = scenery->motion.times[k];
    if (time < next && k + 1 < scenery->motion.times.size()) continue;
    next = time + kStep;
    const auto poses = place_bodies(bodies, scenery->placer, scenery->motion.q[k]);
    for (const auto& [i, j] : scenery->pairs) {
      const double depth = depth_of(solids[i], poses[i], solids[j], poses[j]);
      Overlap& found = deepest[{bodies[i].name, bodies[j].name}];
      if (depth > found.depth) found = {bodies[i].name, bodies[j].name, depth, time};
    }
  }
  std::vector<Overlap> overlaps;
  for (const auto& [names, overlap] : deepest) {
    if (overlap.depth > 0) overlaps.push_back(overlap);
  }
  std::sort(overlaps.begin(), overlaps.end(),
            [](const Overlap& a, const Overlap& b) { return a.depth > b.depth; });
  return overlaps;
}

}  // namespace treeline::experiments
