// Orocos KDL: recursive Newton-Euler for trees; for serial robots also that of the chain, with the
// chain's gravity, mass matrix and forward dynamics. Compiled without -march=native, because
// Eigen's alignment would differ from that of Debian's library.
#include <kdl/config.h>

#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/tree.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <kdl_parser/kdl_parser.hpp>

#include "bench/peers/make_peer.hpp"

namespace treeline::peer {
namespace {

/// KDL's arrays, and the places of our coordinates in them.
struct Joints {
  std::vector<unsigned> place;
  KDL::JntArray q, qd, x, result;

  explicit Joints(std::vector<unsigned> places)
      : place(std::move(places)),
        q(static_cast<unsigned>(place.size())),
        qd(q.rows()),
        x(q.rows()),
        result(q.rows()) {}

  void load(const double* from, KDL::JntArray& to) const {
    for (std::size_t i = 0; i < place.size(); ++i) to(place[i]) = from[i];
  }
  void store(double* to) const {
    for (std::size_t i = 0; i < place.size(); ++i) to[i] = result(place[i]);
  }
};

struct TreeSolver {
  KDL::Tree tree;
  Joints joints;
  KDL::TreeIdSolver_RNE inverse;
  KDL::WrenchMap no_forces;

  TreeSolver(const KDL::Tree& of, const KDL::Vector& gravity, std::vector<unsigned> places)
      : tree(of), joints(std::move(places)), inverse(tree, gravity) {}
};

struct ChainSolver {
  KDL::Chain chain;
  Joints joints;
  KDL::ChainIdSolver_RNE inverse;
  KDL::ChainFdSolver_RNE forward;
  KDL::ChainDynParam parameters;
  KDL::JntSpaceInertiaMatrix M;
  KDL::Wrenches no_forces;

  ChainSolver(const KDL::Chain& of, const KDL::Vector& gravity, std::vector<unsigned> places)
      : chain(of),
        joints(std::move(places)),
        inverse(chain, gravity),
        forward(chain, gravity),
        parameters(chain, gravity),
        M(static_cast<int>(chain.getNrOfJoints())),
        no_forces(chain.getNrOfSegments(), KDL::Wrench::Zero()) {}
};

void inverse_by_tree(void* self, const double* const* in, double* out) {
  auto& [tree, j, inverse, no_forces] = *static_cast<TreeSolver*>(self);
  j.load(in[0], j.q);
  j.load(in[1], j.qd);
  j.load(in[2], j.x);
  inverse.CartToJnt(j.q, j.qd, j.x, no_forces, j.result);
  j.store(out);
}

void nonlinear_by_tree(void* self, const double* const* in, double* out) {
  auto& [tree, j, inverse, no_forces] = *static_cast<TreeSolver*>(self);
  j.load(in[0], j.q);
  j.load(in[1], j.qd);
  KDL::SetToZero(j.x);
  inverse.CartToJnt(j.q, j.qd, j.x, no_forces, j.result);
  j.store(out);
}

void nonlinear_by_chain(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<ChainSolver*>(self);
  s.joints.load(in[0], s.joints.q);
  s.joints.load(in[1], s.joints.qd);
  KDL::SetToZero(s.joints.x);
  s.inverse.CartToJnt(s.joints.q, s.joints.qd, s.joints.x, s.no_forces, s.joints.result);
  s.joints.store(out);
}

void gravity_of_chain(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<ChainSolver*>(self);
  s.joints.load(in[0], s.joints.q);
  s.parameters.JntToGravity(s.joints.q, s.joints.result);
  s.joints.store(out);
}

void inverse_by_chain(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<ChainSolver*>(self);
  s.joints.load(in[0], s.joints.q);
  s.joints.load(in[1], s.joints.qd);
  s.joints.load(in[2], s.joints.x);
  s.inverse.CartToJnt(s.joints.q, s.joints.qd, s.joints.x, s.no_forces, s.joints.result);
  s.joints.store(out);
}

void forward_by_chain(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<ChainSolver*>(self);
  s.joints.load(in[0], s.joints.q);
  s.joints.load(in[1], s.joints.qd);
  s.joints.load(in[2], s.joints.x);
  s.forward.CartToJnt(s.joints.q, s.joints.qd, s.joints.x, s.no_forces, s.joints.result);
  s.joints.store(out);
}

void mass_matrix_of_chain(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<ChainSolver*>(self);
  s.joints.load(in[0], s.joints.q);
  s.parameters.JntToMass(s.joints.q, s.M);
  const auto& place = s.joints.place;
  for (std::size_t i = 0; i < place.size(); ++i) {
    for (std::size_t k = 0; k < place.size(); ++k) {
      out[i * place.size() + k] = s.M(place[i], place[k]);
    }
  }
}

/// Returns the index of each of our joints in the tree. A chain to the last link has the same
/// indices.
std::vector<unsigned> find_places(const Robot& robot, const KDL::Tree& tree) {
  std::vector<unsigned> places;
  for (int i = 0; i < robot.velocities; ++i) {
    places.push_back(GetTreeElementQNr(tree.getSegment(robot.links[i])->second));
  }
  return places;
}

/// Takes the chain of a serial robot: every segment must be between the root and one link.
bool take_chain(const KDL::Tree& tree, KDL::Chain& chain) {
  for (const auto& [link, element] : tree.getSegments()) {
    if (!GetTreeElementChildren(element).empty()) continue;
    return tree.getChain(tree.getRootSegment()->first, link, chain) &&
           chain.getNrOfSegments() == tree.getNrOfSegments();
  }
  return false;
}

Opened open(const Robot& robot, const Tell& tell) {
  Opened opened;
  KDL::Tree tree;
  if (robot.floating) {
    tell("has no floating base");
    return opened;
  }
  if (!kdl_parser::treeFromFile(robot.urdf, tree)) {
    tell("cannot read the robot");
    return opened;
  }
  const auto& g = robot.gravity;
  const KDL::Vector gravity(g[0], g[1], g[2]);
  const auto places = find_places(robot, tree);
  auto& by_tree = opened.keep<TreeSolver>(tree, gravity, places);
  opened.routines = {{"inverse_dynamics", "tree", &by_tree, inverse_by_tree, nullptr},
                     {"nonlinear_effects", "tree", &by_tree, nonlinear_by_tree, nullptr}};
  KDL::Chain chain;
  if (!take_chain(tree, chain)) {
    tell("has all but recursive Newton-Euler for serial robots only");
    return opened;
  }
  auto& by_chain = opened.keep<ChainSolver>(chain, gravity, places);
  const Routine more[] = {{"inverse_dynamics", "chain", &by_chain, inverse_by_chain, nullptr},
                          {"gravity", "chain", &by_chain, gravity_of_chain, nullptr},
                          {"nonlinear_effects", "chain", &by_chain, nonlinear_by_chain, nullptr},
                          {"forward_dynamics", "chain", &by_chain, forward_by_chain, nullptr},
                          {"mass_matrix", "chain", &by_chain, mass_matrix_of_chain, nullptr}};
  opened.routines.insert(opened.routines.end(), std::begin(more), std::end(more));
  return opened;
}

constexpr Peer kPeer = make_peer<open>("KDL", KDL_VERSION_STRING);

}  // namespace
}  // namespace treeline::peer

const treeline::peer::Peer* treeline_peer() {
  return &treeline::peer::kPeer;
}
