#include "cli/start_on_ground.hpp"

#include <fmt/format.h>

#include <utility>

#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

constexpr double kTyped = 1e-3;  // m: coordinates are typed to so many digits

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
                                              std::vector<simulation::GroundShape> shapes) {
  for (auto& shape : shapes) shape.body = find_body<double>(model, shape.link);
  return simulation::Ground(model, std::move(shapes));
}

bool start_on_ground(const simulation::Model& model, const simulation::Ground& ground,
                     const MotionSettings& settings, simulation::State& state,
                     Diagnostics& diagnostics) {
  const auto refuse = [&](const char* option, std::string fault, std::string remedy) {
    diagnostics.add({Severity::error, "", 0, option, std::move(fault), std::move(remedy)});
    return false;
  };
  if (!ground.is_in_reach()) {
    return refuse("ground", "no link that moves has a shape that could touch it",
                  "give links a <collision>: a box, cylinder, capsule, sphere or mesh");
  }
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
