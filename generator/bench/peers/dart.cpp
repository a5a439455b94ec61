// DART: inverse and forward dynamics, nonlinear effects, the mass matrix, and steps with rows held.
// Compiled without -march=native, because Eigen's alignment would differ from that of Debian's
// library.
#include <tinyxml2.h>

#include <dart/config.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/utils/urdf/DartLoader.hpp>
#include <iostream>

#include "bench/peers/dart_solver.hpp"
#include "bench/peers/dart_step.hpp"
#include "bench/peers/make_peer.hpp"

namespace treeline::peer {
namespace {

namespace dynamics = dart::dynamics;

void inverse_dynamics(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  s.load_position(in[0]);
  s.skeleton->setVelocities(s.ordered(in[1]));
  s.skeleton->setAccelerations(s.ordered(in[2]));
  s.skeleton->computeInverseDynamics();
  s.store(s.skeleton->getForces(), out);
}

void gravity(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  s.load_position(in[0]);
  s.store(s.skeleton->getGravityForces(), out);
}

void nonlinear_effects(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  s.load_position(in[0]);
  s.skeleton->setVelocities(s.ordered(in[1]));
  s.store(s.skeleton->getCoriolisAndGravityForces(), out);
}

void forward_dynamics(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  s.load_position(in[0]);
  s.skeleton->setVelocities(s.ordered(in[1]));
  s.skeleton->setForces(s.ordered(in[2]));
  s.skeleton->computeForwardDynamics();
  s.store(s.skeleton->getAccelerations(), out);
}

void mass_matrix(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<Solver*>(self);
  s.load_position(in[0]);
  const Eigen::MatrixXd& M = s.skeleton->getMassMatrix();
  const std::size_t n = s.place.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) out[i * n + k] = M(s.place[i], s.place[k]);
  }
}

/// DART gives 1 kg to a link without an inertia. It warns of zero masses; these warnings are not
/// shown.
void remove_invented_inertias(const char* urdf, dynamics::Skeleton& skeleton) {
  tinyxml2::XMLDocument file;
  file.LoadFile(urdf);
  auto* const shown = std::cerr.rdbuf(nullptr);
  for (auto* link = file.RootElement()->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    auto* body = skeleton.getBodyNode(link->Attribute("name"));
    if (body != nullptr && link->FirstChildElement("inertial") == nullptr) {
      body->setInertia(dynamics::Inertia(0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()));
    }
  }
  std::cerr.rdbuf(shown);
}

void remove_losses(dynamics::Skeleton& skeleton) {
  for (std::size_t i = 0; i < skeleton.getNumDofs(); ++i) {
    skeleton.getDof(i)->setDampingCoefficient(0);
    skeleton.getDof(i)->setCoulombFriction(0);
    skeleton.getDof(i)->setSpringStiffness(0);
  }
}

/// Returns the place of each velocity. A floating base comes first: linear over angular for us, the
/// reverse for DART.
std::vector<Eigen::Index> find_places(const Robot& robot, const dynamics::Skeleton& skeleton) {
  std::vector<Eigen::Index> places;
  if (robot.floating) places = {3, 4, 5, 0, 1, 2};
  for (int i = static_cast<int>(places.size()); i < robot.velocities; ++i) {
    const auto* joint = skeleton.getBodyNode(robot.links[i])->getParentJoint();
    places.push_back(static_cast<Eigen::Index>(joint->getIndexInSkeleton(0)));
  }
  return places;
}

Opened open(const Robot& robot, const Tell& tell) {
  using Loader = dart::utils::DartLoader;
  const auto root = robot.floating ? Loader::RootJointType::FLOATING : Loader::RootJointType::FIXED;
  Loader loader(Loader::Options(nullptr, root));
  const auto skeleton = loader.parseSkeleton(dart::common::Uri::createFromPath(robot.urdf));
  if (!skeleton || skeleton->getNumDofs() != static_cast<std::size_t>(robot.velocities)) {
    tell("cannot read the robot");
    return {};
  }
  remove_invented_inertias(robot.urdf, *skeleton);
  remove_losses(*skeleton);
  skeleton->setGravity(Eigen::Map<const Eigen::Vector3d>(robot.gravity));

  Opened opened;
  auto& s = opened.keep<Solver>();
  s.skeleton = skeleton;
  s.place = find_places(robot, *skeleton);
  s.floating = robot.floating;
  s.q = s.x = Eigen::VectorXd::Zero(robot.velocities);
  opened.routines = {{"inverse_dynamics", "", &s, inverse_dynamics, nullptr},
                     {"gravity", "", &s, gravity, nullptr},
                     {"nonlinear_effects", "", &s, nonlinear_effects, nullptr},
                     {"forward_dynamics", "", &s, forward_dynamics, nullptr},
                     {"mass_matrix", "", &s, mass_matrix, nullptr}};
  if (robot.constraint_count > 0) add_held_step(robot, tell, s, opened);
  return opened;
}

constexpr Peer kPeer = make_peer<open>("DART", DART_VERSION);

}  // namespace
}  // namespace treeline::peer

const treeline::peer::Peer* treeline_peer() {
  return &treeline::peer::kPeer;
}
