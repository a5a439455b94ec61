// A peer for a pendulum, which has one revolute joint. Its results and their errors are known:
//   mass_matrix       relative error of 1e-9; twice as large before it is finished
//   forward_dynamics  right, by two routes
//   inverse_dynamics  zero
//   constrained_forward_dynamics  zero, and a force that is none
// The inertia about the joint is 2, the moment of weight about it is 1.5 g sin(q).
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "bench/peers/make_peer.hpp"

namespace treeline::peer {
namespace {

struct Pendulum {
  double g = 0;
};

void mass_matrix(void*, const double* const*, double* out) {
  out[0] = 2 * 2 * (1 + 1e-9);
}

void halve(void*, double* out) {
  out[0] /= 2;
}

void forward_dynamics(void* self, const double* const* in, double* out) {
  const auto& pendulum = *static_cast<const Pendulum*>(self);
  out[0] = (in[2][0] - 1.5 * pendulum.g * std::sin(in[0][0])) / 2;
}

void inverse_dynamics(void*, const double* const*, double* out) {
  out[0] = 0;
}

void constrained_forward_dynamics(void*, const double* const*, double* out) {
  out[0] = 0;
  out[1] = 1e9;
}

Opened open(const Robot& robot, const Tell& tell) {
  if (robot.floating) {
    tell("has no floating base");
    return {};
  }
  if (!std::ifstream(robot.urdf)) throw std::runtime_error("cannot read the robot");
  std::string asked;
  for (int i = 0; i < robot.function_count; ++i) asked += ' ' + std::string(robot.functions[i]);
  tell("moves " + std::string(robot.links[0]) + " alone for" + asked);
  for (int i = 0; i < robot.constraint_count; ++i) {
    const Constraint& held = robot.constraints[i];
    const std::string other = held.other.link == nullptr ? "the world" : held.other.link;
    tell("holds " + std::string(held.name) + " between " + held.frame.link + " and " + other);
  }
  Opened opened;
  auto& pendulum = opened.keep<Pendulum>();
  pendulum.g = -robot.gravity[2];
  opened.routines = {
      {"inverse_dynamics", "", &pendulum, inverse_dynamics, nullptr},
      {"mass_matrix", "", &pendulum, mass_matrix, halve},
      {"forward_dynamics", "first", &pendulum, forward_dynamics, nullptr},
      {"forward_dynamics", "second", &pendulum, forward_dynamics, nullptr},
      {"constrained_forward_dynamics", "", &pendulum, constrained_forward_dynamics, nullptr}};
  return opened;
}

constexpr Peer make_fake() {
  Peer made = make_peer<open>("Fake", "1.2");
  made.version += FAKE_PEER_VERSIONS_LATER;
  return made;
}

constexpr Peer kPeer = make_fake();

}  // namespace
}  // namespace treeline::peer

const treeline::peer::Peer* treeline_peer() {
  return &treeline::peer::kPeer;
}
