#include "comparison/paired_models.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/joint_parts.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

using interpreter::Model;
using interpreter::Vector;
using Body = interpreter::Body<double>;

constexpr double kPi = 3.14159265358979323846;

interpreter::Model<double> model_of(const Robot& robot, Base base) {
  Scene scene;
  scene.base = base;
  return model_from_robot<double>(robot, scene);
}

Vector<double> rest(const Model<double>& model) {
  Vector<double> q = Vector<double>::Zero(model.nq);
  for (const Body& body : model.bodies) {
    const int quaternion = interpreter::quaternion_of(body);
    if (quaternion >= 0) q[quaternion + 3] = 1;
  }
  return q;
}

const std::string& link_name(const Robot& robot, int link) {
  return robot.links[static_cast<std::size_t>(link)].name;
}

void draw(const Body& body, double lower, double upper, Rng& rng, Vector<double>& q) {
  const int count = interpreter::position_count(body.kind);
  for (int i = 0; i < count; ++i) q[body.q + i] = rng.within(lower, upper);
  if (!interpreter::has_quaternion(body.kind)) return;
  auto quaternion = q.segment<4>(interpreter::quaternion_of(body));
  quaternion[3] += 2;  // so that the norm is never near zero
  quaternion.normalize();
}

}  // namespace

int body_named(const Model<double>& model, const std::string& link) {
  const auto has_name = [&](const Body& body) { return body.name == link; };
  return static_cast<int>(std::find_if(model.bodies.begin(), model.bodies.end(), has_name) -
                          model.bodies.begin());
}

PairedModels::PairedModels(const Robot& first, const Robot& second, const RobotMatch& match,
                           Base base)
    : first_(model_of(first, base)), second_(model_of(second, base)) {
  // The bodies of the base are the root links, the first bodies in both models.
  if (base == Base::floating) {
    pairs_.push_back({0, 0, -1, 1});
    add_velocities(pairs_.back(), "base");
  }
  for (const Match& joint : match.joints) {
    const Joint& a = first.joints[static_cast<std::size_t>(joint.first)];
    const Joint& b = second.joints[static_cast<std::size_t>(joint.second)];
    Pair pair{body_named(first_, link_name(first, a.child)),
              body_named(second_, link_name(second, b.child)), 0, 0};
    const Body& body = first_.body(pair.first);
    if (body.kind == interpreter::JointKind::fixed || body.kind != second_.body(pair.second).kind)
      continue;
    const double reach = body.kind == interpreter::JointKind::revolute ? kPi : 1;
    const Limits limits = a.limits.value_or(Limits{});
    pair.lower = std::max(limits.lower.value(), -reach);
    pair.upper = std::min(limits.upper.value(), reach);
    if (pair.lower > pair.upper) pair.lower = pair.upper;
    pairs_.push_back(pair);
    add_velocities(pair, a.name);
  }
}

void PairedModels::add_velocities(const Pair& pair, const std::string& joint) {
  const Body& a = first_.body(pair.first);
  const Body& b = second_.body(pair.second);
  if (a.mimics || b.mimics) return;
  const int count = interpreter::velocity_count(a.kind);
  for (int i = 0; i < count; ++i) {
    const bool turns = i >= interpreter::translation_count(a.kind);
    velocities_.push_back({a.v + i, b.v + i, joint, turns});
  }
}

/// Puts the second robot's joint where the first robot's is. A mimic follows its own joint.
void PairedModels::place_second(const Pair& pair, const Vector<double>& q,
                                Vector<double>& q_second) const {
  const Body& to = second_.body(pair.second);
  if (to.mimics) return;
  const auto own = interpreter::joint_position<double>(first_.body(pair.first), q);
  q_second.segment(to.q, own.size()) = own;
}

PairedState PairedModels::draw_position(Rng& rng) const {
  PairedState state{rest(first_), rest(second_)};
  for (const Pair& pair : pairs_) {
    const Body& body = first_.body(pair.first);
    if (!body.mimics) draw(body, pair.lower, pair.upper, rng, state.first);
  }
  for (const Pair& pair : pairs_) place_second(pair, state.first, state.second);
  return state;
}

PairedState PairedModels::draw_velocity(Rng& rng) const {
  PairedState state{Vector<double>::Zero(first_.nv), Vector<double>::Zero(second_.nv)};
  for (const SharedVelocity& shared : velocities_) {
    state.first[shared.first] = state.second[shared.second] = rng.within(1);
  }
  return state;
}

}  // namespace treeline
