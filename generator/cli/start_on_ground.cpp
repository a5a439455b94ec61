#include <fmt/format.h>

#include <utility>

#include "cli/simulate_motion.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

constexpr double kTyped = 1e-3;  // m, rad: coordinates are typed to so many digits

/// Whether anything carries a body but joints that float.
bool floats(const simulation::Model& model, int body) {
  while (body != interpreter::kWorld) {
    if (model.body(body).kind == interpreter::JointKind::floating) return true;
    body = model.body(body).parent;
  }
  return false;
}

/// Moves all floating joints up.
void lift(const simulation::Model& model, double height, simulation::State& state) {
  const auto k = interpreter::kinematics<double>(model, state.q, state.qd);
  for (const auto& body : model.bodies) {
    if (body.kind != interpreter::JointKind::floating) continue;
    const simulation::Matrix3 axes = k.R_world[body.parent] * body.R_parent_joint;
    state.q.segment<3>(body.q) += height * axes.row(2).transpose();
  }
}

}  // namespace

std::optional<simulation::Ground> make_ground(const simulation::Model& model,
                                              const std::vector<Coordinate>& coordinates,
                                              const std::optional<GroundOfRobot>& ground,
                                              bool stops) {
  if (!ground && !stops) return std::nullopt;
  std::vector<simulation::GroundShape> shapes;
  if (ground) shapes = ground->shapes;
  for (auto& shape : shapes) shape.body = find_body<double>(model, shape.link);
  std::vector<simulation::JointRange> ranges;
  for (const auto& body : model.bodies) {
    const bool has_range = interpreter::velocity_count(body.kind) == 1 && !body.mimics;
    if (!stops || !has_range) continue;
    const Coordinate& coordinate = coordinates[static_cast<std::size_t>(body.q)];
    ranges.push_back({body.q, body.v, coordinate.lower, coordinate.upper});
  }
  return simulation::Ground(model, std::move(shapes), std::move(ranges));
}

bool can_touch(const simulation::Ground& ground, Diagnostics& diagnostics) {
  if (ground.is_in_reach()) return true;
  diagnostics.add({Severity::error, "", 0, "ground",
                   "no link that moves has a shape that could touch it",
                   "give links a <collision>: a box, cylinder, capsule, sphere or mesh"});
  return false;
}

std::optional<simulation::Surface> make_surface(const simulation::Model& model,
                                                const std::optional<GroundOfRobot>& ground,
                                                double step) {
  if (!ground) return std::nullopt;
  const double slow = 1e-6 + 4 * model.gravity.norm() * step;
  return simulation::Surface{ground->law.restitution, ground->law.friction, slow};
}

bool starts_between_stops(const std::vector<Coordinate>& coordinates,
                          const simulation::State& start, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    const Coordinate& coordinate = coordinates[i];
    const double q = start.q[static_cast<Eigen::Index>(i)];
    if (q >= coordinate.lower - kTyped && q <= coordinate.upper + kTyped) continue;
    diagnostics.add({Severity::error, "", 0, "--q",
                     fmt::format("{} would start at {:g}, beyond its stops at {:g} and {:g}",
                                 coordinate.joint, q, coordinate.lower, coordinate.upper),
                     "give another --q, or no --stops"});
    return false;
  }
  return true;
}

bool start_on_ground(const simulation::Model& model, const simulation::Ground& ground,
                     const MotionSettings& settings, simulation::State& state,
                     Diagnostics& diagnostics) {
  const auto refuse = [&](const char* option, std::string fault, std::string remedy) {
    diagnostics.add({Severity::error, "", 0, option, std::move(fault), std::move(remedy)});
    return false;
  };
  if (!can_touch(ground, diagnostics)) return false;
  simulation::Touch lowest = ground.lowest(model, state.q);
  const bool can_lift = floats(model, lowest.body);
  if (settings.height && !can_lift) {
    return refuse("--height", "the robot does not float", "remove it, or write base: floating");
  }
  if (settings.height) {
    lift(model, lowest.depth + *settings.height, state);
  } else if (settings.q.empty() && can_lift && lowest.depth > 0) {
    lift(model, lowest.depth, state);
    diagnostics.add({Severity::note, "", 0, "ground",
                     fmt::format("the robot starts {:.4g} m higher than its file has it, on the "
                                 "ground",
                                 lowest.depth),
                     "give --height or --q for another start"});
  }
  lowest = ground.lowest(model, state.q);
  if (lowest.depth <= kTyped) return true;
  const std::string& link = ground.shapes()[static_cast<std::size_t>(lowest.shape)].link;
  return refuse(
      settings.q.empty() ? "ground" : "--q",
      fmt::format("the robot would start in the ground, link {} {:.4g} m deep", link, lowest.depth),
      can_lift ? "give --height 0, or another --q" : "give another --q");
}

}  // namespace treeline
