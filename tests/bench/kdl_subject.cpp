// Compiled without -march=native: Eigen's alignment would differ from that of Debian's library.
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/tree.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <kdl_parser/kdl_parser.hpp>

#include "peers.hpp"

namespace treeline::bench {
namespace {

/// Places of our coordinates in KDL's arrays and the arrays.
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

KDL::Vector gravity(const Case& robot) {
  const auto& g = robot.model.gravity;
  return {g(0), g(1), g(2)};
}

/// Where the tree keeps each of our joints; a chain to the last link numbers its joints alike.
std::vector<unsigned> places(const Case& robot, const KDL::Tree& tree) {
  std::vector<unsigned> result;
  for (const auto& link : robot.joints) {
    result.push_back(GetTreeElementQNr(tree.getSegment(link)->second));
  }
  return result;
}

}  // namespace

std::vector<Subject> kdl_subjects(const Case& robot) {
  KDL::Tree tree;
  if (robot.floating || !kdl_parser::treeFromFile(robot.urdf, tree)) {
    return {};
  }
  auto by_tree = std::make_shared<TreeSolver>(tree, gravity(robot), places(robot, tree));
  std::vector<Subject> subjects{
      {"KDL, tree", {{Function::inverse_dynamics, {inverse_by_tree, by_tree}}}, ""}};
  KDL::Chain chain;
  const auto root = tree.getRootSegment()->first;
  // Serial: every segment is on the way to the last link.
  if (tree.getChain(root, robot.model.bodies.back().name, chain) &&
      chain.getNrOfSegments() == tree.getNrOfSegments()) {
    auto by_chain = std::make_shared<ChainSolver>(chain, gravity(robot), places(robot, tree));
    subjects.push_back({"KDL, chain",
                        {{Function::inverse_dynamics, {inverse_by_chain, by_chain}},
                         {Function::forward_dynamics, {forward_by_chain, by_chain}},
                         {Function::mass_matrix, {mass_matrix_of_chain, by_chain}}},
                        ""});
  }
  return subjects;
}

}  // namespace treeline::bench
