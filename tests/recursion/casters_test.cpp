#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "looped_robot.hpp"
#include "recursion/methods/supported_control_torque.hpp"
#include "samm_on_casters.hpp"

// SAMM on four powered casters, by the emitted recursion in double: its tool and base draw circles
// by torques of the casters and of the arm alone. Would catch: wheels that slip or fight each
// other, a base that is pushed by something else than its wheels, and a law that forgets the
// wheels' motion.

namespace treeline::tests {
namespace {

using V = interpreter::Vector<double>;

std::string scene_on_casters() {
  std::string text =
      "operational_points: [{name: tool, link: tool, rows: [x, y, z]}, {name: base, link: base, "
      "rows: [x, y, rz], priority: 2}]\npassive: [base_x, base_y, base_yaw]\nfunctions: "
      "[constrained_forward_dynamics, supported_control_torque]\nconstraints:\n";
  for (int k = 0; k < kCasters; ++k) {
    const std::string wheel = "wheel" + std::to_string(k);
    text += "  - {name: " + wheel + ", between: [" + wheel +
            ", world], rows: [x, y], rolling: {radius: 0.055}}\n";
  }
  return text;
}

Robot samm_on_casters() {
  Diagnostics diagnostics;
  return parse_urdf(urdf_on_casters(), "samm.urdf", diagnostics).value();
}

/// Positions of the tool over x, y and yaw of the base, and the rows that move them.
class Tasks {
 public:
  Tasks(const Robot& robot, const LoopedRobot& samm) : model_(samm.model()) {
    Diagnostics diagnostics;
    const auto scene = parse_scene(scene_on_casters(), "scene.yaml", robot, diagnostics);
    points_ = points_from_scene(model_, scene.value().operational_points);
    const Mechanism mechanism = reduced_mechanism(robot, *scene);
    const Mechanism seen = with_supports(mechanism);
    passive_ = mechanism.passive;
    rules_ = split_rules(*TaskLaws(seen).supported());
    tree_ = tree_of<double>(seen);
  }

  [[nodiscard]] const std::vector<int>& passive() const { return passive_; }

  [[nodiscard]] V places(const V& q) const {
    const auto k = interpreter::kinematics<double>(model_, q, V::Zero(model_.nv));
    const auto& tool = points_[0];
    return (V(6) << k.p_world[tool.body] + k.R_world[tool.body] * tool.p, q.head(3)).finished();
  }
  [[nodiscard]] V rates(const V& q, const V& qd) const {
    return interpreter::jacobian<double>(model_, points_, q) * qd;
  }

  /// Torques by which the tasks accelerate as `xdd` says, and the arm stays near `posture`.
  [[nodiscard]] SupportedTorque<double> torque(const V& q, const V& qd, const V& xdd,
                                               const V& posture) const {
    const V qdd_0 = 100 * (posture - q) - 20 * qd;
    const std::vector<double> at(q.begin(), q.end()), rates(qd.begin(), qd.end()),
        wanted(qdd_0.begin(), qdd_0.end()), asked(xdd.begin(), xdd.end()), none(2 * kCasters);
    const auto X = joint_transforms<double>(tree_, at);
    const LambdaChoice choice{{}, LambdaRoute::factors_inward};
    return supported_control_torque<double>(tree_, X, {{rates, wanted}, asked, none, {}}, passive_,
                                            choice, rules_);
  }

 private:
  const interpreter::Model<double>& model_;
  interpreter::Points<double> points_;
  Tree<double> tree_;
  SupportRules rules_;
  std::vector<int> passive_;
};

/// Circles of tool (0.1 m, in the vertical plane across) and base (0.05 m), which begin smoothly.
struct Circle {
  V x = V::Zero(6), v = V::Zero(6), a = V::Zero(6);

  explicit Circle(double time) {
    const double turn = 2 * std::acos(-1.0) / 4, u = std::min(time, 1.0);  // 4 s a round
    const double angle = turn * (u * u * u * (1 - u / 2) + std::max(time - 1, 0.0));
    const double rate = turn * u * u * (3 - 2 * u), gain = turn * 6 * u * (1 - u);
    const double c = std::cos(angle), s = std::sin(angle);
    const Eigen::Vector2d place(c - 1, s), along(-s, c);
    const Eigen::Vector2d velocity = rate * along;
    const Eigen::Vector2d acceleration = gain * along - rate * rate * Eigen::Vector2d(c, s);
    x.segment(1, 2) = 0.1 * place, x.segment(3, 2) = 0.05 * place;
    v.segment(1, 2) = 0.1 * velocity, v.segment(3, 2) = 0.05 * velocity;
    a.segment(1, 2) = 0.1 * acceleration, a.segment(3, 2) = 0.05 * acceleration;
  }
};

struct Largest {
  double tool = 0, base = 0, slip = 0, force = 0, turned = 0;
};

Largest draw_circles(const LoopedRobot& samm, const Tasks& tasks, double seconds) {
  V q = V::Zero(samm.model().nq), qd = V::Zero(samm.model().nv);
  for (const auto& [name, value] : {std::pair{"link2", -1.42}, {"link3", 2.82}, {"link5", 0.95}}) {
    for (const auto& body : samm.model().bodies) {
      if (body.name == name) q(body.q) = value;
    }
  }
  const V posture = q, from = tasks.places(q);
  Largest largest;
  constexpr double kStep = 1e-3;
  const std::vector<double> gains{100, 0};
  for (int i = 0; i * kStep < seconds; ++i) {
    const Circle wanted(i * kStep);
    const V error = from + wanted.x - tasks.places(q), rates = wanted.v - tasks.rates(q, qd);
    largest.tool = std::max(largest.tool, error.head(3).norm());
    largest.base = std::max(largest.base, error.segment(3, 2).norm());
    const V xdd = wanted.a + 900 * error + 60 * rates;
    const auto torque = tasks.torque(q, qd, xdd, posture);
    const V tau = V::Map(torque.tau.data(), qd.size());
    for (const int v : tasks.passive()) EXPECT_EQ(tau(v), 0);
    const auto rate = [&](const V& x, const V& u) {
      const auto qdd = samm.motion(x, u, gains, tau).qdd;
      return V(V::Map(qdd.data(), u.size()));
    };
    const V middle = samm.moved(q, V(qd + kStep / 4 * rate(q, qd)), kStep / 2);
    const V half = qd + kStep / 2 * rate(q, qd);
    const V a = rate(middle, half);
    q = samm.moved(q, V(qd + kStep / 2 * a), kStep);
    qd += kStep * a;
    largest.slip = std::max(largest.slip, (samm.jacobian(q) * qd).cwiseAbs().maxCoeff());
    for (int k = 0; k < kCasters; ++k) {
      const auto at = static_cast<std::size_t>(2 * k);
      largest.force = std::max(largest.force, std::hypot(torque.f[at], torque.f[at + 1]));
    }
  }
  for (const auto& body : samm.model().bodies) {
    if (body.name == "fork0") largest.turned = q(body.q);
  }
  return largest;
}

TEST(SammOnCasters, DrawsItsCirclesByTorquesOfItsWheels) {
  const Robot robot = samm_on_casters();
  const LoopedRobot samm(robot, scene_on_casters());
  const Tasks tasks(robot, samm);
  ASSERT_EQ(samm.model().nv, 17);
  ASSERT_EQ(tasks.passive().size(), 3U);
  const Largest largest = draw_circles(samm, tasks, 5);
  std::cout << "5 s: the tool errs by " << largest.tool << " m, the base by " << largest.base
            << " m; wheels slip at " << largest.slip << " m/s and push with up to " << largest.force
            << " N; a fork has turned to " << largest.turned << " rad\n";
  // Torques are held for a millisecond, and what is left is of its first order.
  EXPECT_LE(largest.tool, 1e-5);
  EXPECT_LE(largest.base, 1e-6);
  EXPECT_LE(largest.slip, 1e-6);
  // The base alone, of 150 kg, presses each wheel with 368 N: friction of 0.05 is enough.
  EXPECT_LE(largest.force, 0.05 * 9.81 * 150 / 4);
  EXPECT_GT(std::abs(largest.turned), 1);  // wheels trail, so that forks follow the circle
}

}  // namespace
}  // namespace treeline::tests
