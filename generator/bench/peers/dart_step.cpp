#include "bench/peers/dart_step.hpp"

#include <dart/constraint/BallJointConstraint.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/constraint/WeldJointConstraint.hpp>
#include <dart/simulation/World.hpp>

namespace treeline::peer {
namespace {

using dart::constraint::BallJointConstraint;
using dart::constraint::DynamicJointConstraint;
using dart::constraint::WeldJointConstraint;

/// s. The error grows with it. Where it is much shorter, DART solves less exactly for impulses.
constexpr double kStep = 0x1p-22;

struct HeldFrame {
  dart::dynamics::BodyNode* body = nullptr;
  Eigen::Vector3d origin;                     ///< in the axes of the body
  dart::dynamics::BodyNode* other = nullptr;  ///< null: the world
  bool turns = false;
};

struct HeldStep {
  Solver solver;  ///< with a skeleton of the world's own
  dart::simulation::WorldPtr world;
  std::vector<HeldFrame> frames;
  Eigen::VectorXd before;
  bool is_held = false;

  /// DART takes frames from the pose in which a constraint is made, which must keep it.
  void hold() {
    for (const HeldFrame& frame : frames) {
      world->getConstraintSolver()->addConstraint(constraint_of(frame));
    }
    is_held = true;
  }

  static dart::constraint::ConstraintBasePtr constraint_of(const HeldFrame& frame) {
    if (frame.turns) {
      if (frame.other == nullptr) return std::make_shared<WeldJointConstraint>(frame.body);
      return std::make_shared<WeldJointConstraint>(frame.body, frame.other);
    }
    const Eigen::Vector3d at = frame.body->getTransform() * frame.origin;
    if (frame.other == nullptr) return std::make_shared<BallJointConstraint>(frame.body, at);
    return std::make_shared<BallJointConstraint>(frame.body, frame.other, at);
  }
};

/// A step makes rows of J stand still in the pose where it begins, so that without more the motion
/// would lack Jd qd. It begins one step ahead: then J(q + step qd) qd = step Jd qd.
void step(void* self, const double* const* in, double* out) {
  auto& s = *static_cast<HeldStep*>(self);
  auto& skeleton = *s.solver.skeleton;
  s.solver.load_position(in[0]);
  skeleton.setVelocities(s.before = s.solver.ordered(in[1]));
  skeleton.setForces(s.solver.ordered(in[2]));
  if (!s.is_held) s.hold();
  skeleton.integratePositions(kStep);
  s.world->step();
  s.solver.store((skeleton.getVelocities() - s.before) / kStep, out);
}

}  // namespace

void add_held_step(const Robot& robot, const Tell& tell, const Solver& s, Opened& opened) {
  auto& made = opened.keep<HeldStep>();
  made.solver = s;
  made.solver.skeleton = s.skeleton->cloneSkeleton();
  made.before = s.x;
  made.world = dart::simulation::World::create();
  made.world->setGravity(s.skeleton->getGravity());
  made.world->setTimeStep(kStep);
  made.world->addSkeleton(made.solver.skeleton);
  for (int i = 0; i < robot.constraint_count; ++i) {
    const Constraint& from = robot.constraints[i];
    HeldFrame frame{made.solver.skeleton->getBodyNode(from.frame.link),
                    Eigen::Map<const Eigen::Vector3d>(from.frame.p), nullptr,
                    holds_turns(from, tell)};
    if (from.other.link != nullptr) {
      frame.other = made.solver.skeleton->getBodyNode(from.other.link);
    }
    made.frames.push_back(frame);
  }
  // What leads drift back has no part in the motion at an instant.
  DynamicJointConstraint::setErrorReductionParameter(0);
  DynamicJointConstraint::setConstraintForceMixing(1e-9);
  opened.routines.push_back(
      {"constrained_forward_dynamics", "a step of 2.4e-7 s with impulses", &made, step, nullptr});
}

}  // namespace treeline::peer
