#include <gtest/gtest.h>

#include "interpreter/loop_instances.hpp"
#include "interpreter/physics.hpp"
#include "interpreter/supported_cases.hpp"

// Constraints between links and joints, from positions and from other robots. Would catch: a wrong
// sign, axis, reference point or Coriolis term of a loop's rows, joints that carry both links and
// move them against each other, and a weld that is not one.

namespace treeline::tests {
namespace {

class Loops : public testing::TestWithParam<Standing> {
 protected:
  Loops() : c_(draw_standing(11, GetParam())) {
    for (auto& loop : c_.task.loops.frames) loop.second.rows = kAllRows;
  }
  [[nodiscard]] const interpreter::Loops<Digits50>& loops() const { return c_.task.loops; }
  [[nodiscard]] Matrix50 jacobian(const Vector50& q) const {
    return interpreter::loop_jacobian<Digits50>(c_.model, loops(), q);
  }
  [[nodiscard]] Vector50 after(const Digits50& t) const { return moved(c_.model, c_.q, c_.qd, t); }

  StandingCase c_;
};

INSTANTIATE_TEST_SUITE_P(Random, Loops, testing::ValuesIn(looped()),
                         [](const auto& tested) { return std::string(tested.param.name); });

Digits50 size_of(const Matrix50& x) {
  return x.size() == 0 ? Digits50(0) : x.cwiseAbs().maxCoeff();
}

// Displacements and couplings are measured by coordinates, whose derivatives their rows must be.
TEST_P(Loops, RowsAreDerivativesOfTheErrors) {
  const Vector50 rates = derivative([&](const Digits50& t) {
    return interpreter::loop_errors<Digits50>(c_.model, loops(), after(t));
  });
  const Vector50 expected = jacobian(c_.q) * c_.qd;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < loops().frames.size(); ++i, row += 6) {
    EXPECT_LE(size_of(rates.segment(row, 3) - expected.segment(row, 3)), kDifference * 100);
  }
  const auto left = rates.size() - row;
  EXPECT_LE(size_of(rates.tail(left) - expected.tail(left)), kDifference * 100);
}

// dE/dt = [w]x E, E: the first frame's axes in those of the second.
TEST_P(Loops, TurnsAreThoseOfTheFrames) {
  const Vector50 velocity = jacobian(c_.q) * c_.qd;
  Eigen::Index row = 3;
  for (const auto& loop : loops().frames) {
    const auto turn = [&](const Digits50& t) {
      const auto k = interpreter::kinematics<Digits50>(c_.model, after(t), c_.qd);
      const interpreter::detail::LoopState<Digits50> at(loop, k);
      return Matrix50(at.R.transpose() * at.R_first);
    };
    const Matrix50 rate = derivative(turn) * turn(0).transpose();
    const interpreter::Vector3<Digits50> w = velocity.segment(row, 3);
    EXPECT_LE(size_of(rate - interpreter::cross_matrix(w)), kDifference * 100);
    row += 6;
  }
}

TEST_P(Loops, BiasIsTheDerivativeOfTheRows) {
  const Vector50 expected =
      derivative([&](const Digits50& t) { return Vector50(jacobian(after(t)) * c_.qd); });
  const Vector50 bias = interpreter::loop_bias<Digits50>(c_.model, loops(), c_.q, c_.qd);
  EXPECT_LE(size_of(bias - expected), kDifference * 1000);
}

/// A contact that rolls, at a state at which it touches: the second frame is put where it does.
class Rolling : public testing::TestWithParam<Standing> {
 protected:
  Rolling() : c_(draw_standing(23, GetParam())) {
    for (auto& loop : c_.task.loops.frames) touch(loop);
  }

  /// Turns and moves the second frame so that the first one touches it.
  void touch(interpreter::Loop<Digits50>& loop) const {
    const auto k = interpreter::kinematics<Digits50>(c_.model, c_.q, c_.qd);
    const interpreter::detail::LoopState<Digits50> at(loop, k);
    const auto& rolling = *loop.rolling;
    interpreter::Vector3<Digits50> wanted(0, 0, rolling.radius);
    if (rolling.on_radius) {
      wanted = interpreter::Vector3<Digits50>(2, -1, 2) * (rolling.radius + *rolling.on_radius) / 3;
    } else if (rolling.axis) {
      const Digits50 lean = at.R.col(2).dot(Vector50(at.R_first * *rolling.axis));
      wanted(2) *= sqrt(Digits50(1 - lean * lean));
    }
    const interpreter::Vector3<Digits50> seen = at.R.transpose() * at.d;
    loop.second.p += loop.second.R * (seen - wanted);
  }
  /// Sine of the angle between a disc's axis and the normal; 1 for balls.
  [[nodiscard]] Digits50 sine_of(const interpreter::Loop<Digits50>& loop) const {
    if (!loop.rolling->axis) return 1;
    const interpreter::detail::LoopState<Digits50> at(
        loop, interpreter::kinematics<Digits50>(c_.model, c_.q, c_.qd));
    const Digits50 lean = at.R.col(2).dot(Vector50(at.R_first * *loop.rolling->axis));
    return sqrt(Digits50(1 - lean * lean));
  }
  [[nodiscard]] Vector50 rates() const {
    return interpreter::loop_jacobian<Digits50>(c_.model, c_.task.loops, c_.q) * c_.qd;
  }

  StandingCase c_;
};

INSTANTIATE_TEST_SUITE_P(Random, Rolling, testing::ValuesIn(rolling()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Contacts that touch have no gap; it changes by the rows' velocity along the normal, a disc's
// times the sine between its axis and the normal.
TEST_P(Rolling, OnlyTheNormalIsHeldInPosition) {
  const auto errors = [&](const Digits50& t) {
    return interpreter::loop_errors<Digits50>(c_.model, c_.task.loops,
                                              moved(c_.model, c_.q, c_.qd, t));
  };
  const Vector50 at_rest = errors(0);
  const auto couplings = static_cast<Eigen::Index>(c_.task.loops.couplings.size());
  EXPECT_LE(size_of(at_rest.head(at_rest.size() - couplings)), kAlgebra);
  const Vector50 rate = derivative(errors), expected = rates();
  Eigen::Index row = 0;
  for (const auto& loop : c_.task.loops.frames) {
    Vector50 normal = Vector50::Zero(3);
    normal(2) = 1;
    if (loop.rolling->on_radius) normal = (Vector50(3) << 2, -1, 2).finished() / 3;
    for (int i = 0; i < 6; ++i) {
      if (!loop.second.rows[detail::at(i)]) continue;
      Digits50 along = 0;
      if (i < 3 && loop.rolling->on_radius) {
        along = normal(i) * normal.dot(expected.segment(row - i, 3));
      } else if (i == 2) {
        along = expected(row) * sine_of(loop);
      }
      EXPECT_LE(abs(Digits50(rate(row) - along)), kDifference * 1000);
      ++row;
    }
  }
}

TEST_P(Rolling, BiasIsTheDerivativeOfTheRows) {
  const Vector50 expected = derivative([&](const Digits50& t) {
    return Vector50(interpreter::loop_jacobian<Digits50>(c_.model, c_.task.loops,
                                                         moved(c_.model, c_.q, c_.qd, t)) *
                    c_.qd);
  });
  const Vector50 bias = interpreter::loop_bias<Digits50>(c_.model, c_.task.loops, c_.q, c_.qd);
  EXPECT_LE(size_of(bias - expected), kDifference * 1000);
  EXPECT_GT(size_of(bias), Digits50("0.01"));
}

// A base that floats carries both ends of every loop.
TEST(LoopsOfAFloatingRobot, DoNotFeelHowItMovesAsAWhole) {
  StandingCase c = draw_standing(5, looped()[2]);
  const Matrix50 J = interpreter::loop_jacobian<Digits50>(c.model, c.task.loops, c.q);
  EXPECT_EQ(size_of(J.leftCols(6)), Digits50(0));
  EXPECT_GT(size_of(J), Digits50("0.01"));
}

/// A random chain, one of whose joints is given another type.
RandomMechanism chain_with(JointType type) {
  RandomMechanism made = random_mechanism(17, {.joints = 7, .branching = 0.3, .mix = {1}});
  Joint& joint = made.robot.joints[detail::at(3)];
  joint.type = type;
  joint.limits.reset();
  return made;
}

// A link that hangs on six freedoms and is welded to its parent moves like one on a fixed joint.
TEST(WeldedLoop, MovesLikeAFixedJoint) {
  const RandomMechanism fixed = chain_with(JointType::fixed);
  RandomMechanism welded = chain_with(JointType::floating);
  const Joint& joint = welded.robot.joints[detail::at(3)];
  const auto link_name = [&](int link) { return welded.robot.links[detail::at(link)].name; };
  SceneLoop weld;
  weld.first.link = link_name(joint.child);
  weld.second.link = link_name(joint.parent);
  weld.second.origin = joint.origin;
  welded.scene.loops.push_back(weld);
  const auto model = model_from_robot<Digits50>(fixed.robot, fixed.scene);
  const auto open = model_from_robot<Digits50>(welded.robot, welded.scene);
  int at = 0;  // of the floating joint's coordinates
  for (const auto& body : open.bodies) {
    if (body.kind == interpreter::JointKind::floating) at = body.v;
  }
  Rng rng(3);
  const auto q = random_entries<Digits50>(rng, model.nq, 2);
  const auto qd = random_entries<Digits50>(rng, model.nv, 2);
  const auto tau = random_entries<Digits50>(rng, model.nv, 10);
  const auto opened = [&](const Vector50& x, int gap) {
    Vector50 y = Vector50::Zero(x.size() + gap);
    y.head(at) = x.head(at);
    y.tail(x.size() - at) = x.tail(x.size() - at);
    return y;
  };
  interpreter::ConstrainedState<Digits50> state;
  state.q = opened(q, 7);
  state.qd = opened(qd, 6);
  state.tau = opened(tau, 6);
  state.q(at + 6) = 1;
  state.loops = loops_from_scene(open, welded.robot, welded.scene);
  const auto moving = interpreter::constrained_forward_dynamics<Digits50>(open, Points50{}, state);
  const Vector50 expected = interpreter::forward_dynamics<Digits50>(model, q, qd, tau);
  EXPECT_LE(size_of(moving.qdd - opened(expected, 6)), kAlgebra * size_of(expected));
  EXPECT_GT(size_of(moving.f), Digits50(1));
}

}  // namespace
}  // namespace treeline::tests
