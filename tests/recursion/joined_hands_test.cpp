#include <gtest/gtest.h>

#include <iostream>

#include "interpreter/object_forward_dynamics.hpp"
#include "joined_mechanisms.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/function_results.hpp"
#include "recursion/routes/trace_function.hpp"

// Objects in the hands of several robots of one scene. The truth is a chain of separate robots, as
// somebody couples them by hand (Chang 7.2.2), and the whole as one linear system. Would catch: a
// hand that is taken for another robot's, and a coupling that is lost between trees.

namespace treeline::tests {
namespace {

namespace ip = interpreter;
using Chain = ip::ClosedChain<Digits50>;
using Vector50 = ip::Vector<Digits50>;
using Matrix50 = ip::Matrix<Digits50>;

/// Which robots hold each object, one hand each; a hand is a point of its own.
struct Hands {
  const char* name;
  int robots;
  std::vector<std::vector<int>> objects;
};

std::ostream& operator<<(std::ostream& out, const Hands& hands) {
  return out << hands.name;
}

struct Carried {
  RandomMechanism joined;
  Chain as_one;    ///< the joined robots
  Chain separate;  ///< each robot by itself, coupled by the objects alone
};

PlacedMechanism draw_part(std::uint64_t seed, int points, bool floats) {
  RandomOptions options;
  options.joints = 8 * points;
  options.branching = 0.15;
  options.mix = {5, 1, 2, 0.5, 0.1, 0.3, 0};
  options.operational_points = points;
  options.floating_base = floats;
  options.drives = 0.3;
  PlacedMechanism part{random_mechanism(seed, options), {}};
  part.made.scene.gravity = {0, 0, -9.81};
  Rng rng(seed + 3);
  if (!floats) part.pose = {detail::random_vector(rng, 2), {0, 0, rng.rounded(-3, 3)}};
  return part;
}

Carried draw(std::uint64_t seed, const Hands& hands) {
  std::vector<int> points(static_cast<std::size_t>(hands.robots), 0);
  for (const auto& object : hands.objects) {
    for (const int robot : object) ++points[static_cast<std::size_t>(robot)];
  }
  std::vector<PlacedMechanism> parts;
  for (const int count : points) {
    parts.push_back(draw_part(seed + 17 * parts.size(), count, parts.size() == 1));
  }
  Carried carried;
  carried.joined = joined(parts);
  Rng rng(seed + 5);
  std::vector<int> next(points.size(), 0);
  for (std::size_t k = 0; k < hands.objects.size(); ++k) {
    SceneObject object;
    object.name = "object" + std::to_string(k);
    object.inertial = detail::random_inertial(rng, 0.4);
    object.inertial.origin.rpy = {};
    for (const int robot : hands.objects[k]) {
      const auto r = static_cast<std::size_t>(robot);
      object.grasps.push_back({part_name(r) + "_point_" + std::to_string(next[r]++),
                               detail::random_pose(rng, 0.4, 0.4)});
    }
    carried.joined.scene.objects.push_back(object);
  }
  carried.as_one = chain_from_scene<Digits50>(carried.joined.robot, carried.joined.scene);
  // The same objects, and each grasp on a robot's own model.
  carried.separate.objects = carried.as_one.objects;
  for (const PlacedMechanism& part : parts) {
    const RandomMechanism alone = joined({part});
    carried.separate.robots.push_back(model_from_robot<Digits50>(alone.robot, alone.scene));
  }
  std::fill(next.begin(), next.end(), 0);
  for (std::size_t k = 0; k < hands.objects.size(); ++k) {
    for (std::size_t i = 0; i < hands.objects[k].size(); ++i) {
      const auto r = static_cast<std::size_t>(hands.objects[k][i]);
      const RandomMechanism alone = joined({parts[r]});
      const auto own =
          points_from_scene(carried.separate.robots[r], alone.scene.operational_points);
      auto& grasp = carried.separate.objects[k].grasps[i];
      grasp.robot = hands.objects[k][i];
      grasp.point = own[static_cast<std::size_t>(next[r]++)];
    }
  }
  return carried;
}

struct Drawn {
  Carried carried;
  Vector50 q, qd, qdd_0, tau, xdd, internal;
};

Drawn draw_state(std::uint64_t seed, const Hands& hands) {
  Drawn drawn{draw(seed, hands), {}, {}, {}, {}, {}, {}};
  const Chain& chain = drawn.carried.as_one;
  Rng rng(seed + 9);
  const int nv = chain.robots[0].nv;
  const auto entries = [&](int count, double size) {
    return Vector50(random_entries<double>(rng, count, size).template cast<Digits50>());
  };
  drawn.q = random_position(rng, chain.robots[0], 2.0);
  drawn.qd = entries(nv, 2);
  drawn.qdd_0 = entries(nv, 5);
  drawn.tau = entries(nv, 20);
  drawn.xdd = entries(6 * static_cast<int>(chain.objects.size()), 5);
  drawn.internal = entries(ip::internal_force_count(chain), 10);
  return drawn;
}

/// The first state from this seed on whose hands move independently.
Drawn draw_regular(std::uint64_t seed, const Hands& hands) {
  for (;; seed += 13) {
    Drawn drawn = draw_state(seed, hands);
    const Chain& chain = drawn.carried.as_one;
    const auto hands_of = ip::object_points(chain, 0);
    double growth =
        std::max(condition(ip::mass_matrix<Digits50>(chain.robots[0], drawn.q)),
                 condition(ip::lambda_inverse<Digits50>(chain.robots[0], hands_of, drawn.q)));
    for (const auto& object : chain.objects) {
      growth = std::max(growth, condition(ip::grasp_description(object)));
    }
    if (growth > 1e7) continue;
    std::cout << "seed " << seed << ", condition " << growth << '\n';
    return drawn;
  }
}

/// The part of a vector of coordinates or velocities that belongs to each robot.
ip::PerRobot<Digits50> parted(const Chain& chain, const Vector50& all, bool positions) {
  ip::PerRobot<Digits50> parts;
  Eigen::Index first = 0;
  for (const auto& robot : chain.robots) {
    const Eigen::Index count = positions ? robot.nq : robot.nv;
    parts.push_back(all.segment(first, count));
    first += count;
  }
  return parts;
}

Vector50 put_together(const ip::PerRobot<Digits50>& parts) {
  Vector50 all(0);
  for (const auto& part : parts) {
    const Eigen::Index first = all.size();
    all.conservativeResize(first + part.size());
    all.tail(part.size()) = part;
  }
  return all;
}

double difference(const Vector50& a, const Vector50& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  if (a.size() == 0) return 0;
  const Digits50 scale = std::max(Digits50(1), b.cwiseAbs().maxCoeff());
  return static_cast<double>(Vector50(a - b).cwiseAbs().maxCoeff() / scale);
}

class JoinedHands : public testing::TestWithParam<std::tuple<Hands, int>> {
 protected:
  JoinedHands()
      : drawn_(draw_regular(3 + 71 * static_cast<std::uint64_t>(std::get<1>(GetParam())),
                            std::get<0>(GetParam()))) {}
  [[nodiscard]] const Chain& as_one() const { return drawn_.carried.as_one; }
  [[nodiscard]] const Chain& separate() const { return drawn_.carried.separate; }
  Drawn drawn_;
  const ip::Stabilisation<Digits50> gains_{Digits50(20), Digits50(100)};
};

const Hands kHands[] = {{"two_robots", 2, {{0, 1}}},
                        {"three_robots", 3, {{0, 1, 2}}},
                        {"two_hands_and_one", 2, {{0, 1, 0}}},
                        {"two_objects", 2, {{0, 1}, {1, 0}}},
                        {"object_each", 2, {{1}, {0}}}};

INSTANTIATE_TEST_SUITE_P(Random, JoinedHands,
                         testing::Combine(testing::ValuesIn(kHands), testing::Range(0, 2)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param).name) + "_" +
                                  std::to_string(std::get<1>(tested.param));
                         });

// Rounding in 50 digits, times condition numbers up to 1e7 of three solves in a row.
constexpr double kFifty = 1e-28;

TEST_P(JoinedHands, AreRobotsThatSomebodyCouples) {
  const Drawn& d = drawn_;
  const auto q = parted(separate(), d.q, true), qd = parted(separate(), d.qd, false);
  const auto tau = ip::object_control_torque<Digits50>(
      separate(), q, qd, parted(separate(), d.qdd_0, false), d.xdd, d.internal);
  EXPECT_LE(difference(ip::object_control_torque<Digits50>(as_one(), {d.q}, {d.qd}, {d.qdd_0},
                                                           d.xdd, d.internal)[0],
                       put_together(tau)),
            kFifty);
  const auto one = ip::object_forward_dynamics<Digits50>(as_one(), {d.q}, {d.qd}, {d.tau}, gains_);
  const auto many = ip::object_forward_dynamics<Digits50>(separate(), q, qd,
                                                          parted(separate(), d.tau, false), gains_);
  EXPECT_LE(difference(one.qdd[0], put_together(many.qdd)), kFifty);
  EXPECT_LE(difference(one.xdd_object, many.xdd_object), kFifty);
  EXPECT_LE(difference(one.f_grasp, many.f_grasp), kFifty);
  EXPECT_LE(difference(one.internal, many.internal), kFifty);
}

// M qdd + h + J^T f = tau, Lambda_obj xdd + mu + p = C^T f, J qdd + Jd qd = C xdd - corrections, as
// one system.
TEST_P(JoinedHands, ObeyTheWholeSystem) {
  const Drawn& d = drawn_;
  const auto& robot = as_one().robots[0];
  const auto points = ip::object_points(as_one(), 0);
  const Matrix50 J = ip::jacobian<Digits50>(robot, points, d.q);
  const Matrix50 C = ip::connectivity(as_one(), 0);
  const Eigen::Index nv = robot.nv, objects = C.cols(), hands = C.rows();
  Matrix50 A = Matrix50::Zero(nv + objects + hands, nv + objects + hands);
  Vector50 b(A.rows());
  A.topLeftCorner(nv, nv) = ip::mass_matrix<Digits50>(robot, d.q);
  A.topRightCorner(nv, hands) = J.transpose();
  A.bottomLeftCorner(hands, nv) = J;
  A.block(nv, nv + objects, objects, hands) = -C.transpose();
  A.block(nv + objects, nv, hands, objects) = -C;
  b.head(nv) = d.tau - ip::nonlinear_effects<Digits50>(robot, d.q, d.qd);
  const auto poses = ip::held_poses<Digits50>(as_one(), {d.q}, {d.qd});
  Vector50 wanted = -ip::bias_acceleration<Digits50>(robot, points, d.q, d.qd);
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Eigen::Index own = nv + 6 * static_cast<Eigen::Index>(k);
    const auto bias = ip::object_bias(as_one().objects[k], poses[k].front(), robot.gravity);
    A.block<6, 6>(own, own) = ip::object_inertia(as_one().objects[k], poses[k].front().R);
    b.segment<6>(own) = -bias.mu - bias.p;
    for (const auto& held : poses[k]) {
      const auto drift = ip::grasp_drift(poses[k].front(), held);
      wanted.segment<6>(at) -= gains_.damping * drift.velocity + gains_.stiffness * drift.pose;
      at += 6;
    }
  }
  b.tail(hands) = wanted;
  const Vector50 x = A.fullPivLu().solve(b);
  const auto motion =
      ip::object_forward_dynamics<Digits50>(as_one(), {d.q}, {d.qd}, {d.tau}, gains_);
  EXPECT_LE(difference(motion.qdd[0], x.head(nv)), kFifty);
  EXPECT_LE(difference(motion.xdd_object, x.segment(nv, objects)), kFifty);
}

// Every route of the emitted functions, in double, against the separate robots.
TEST_P(JoinedHands, ProgramsAreRobotsThatSomebodyCouples) {
  const Drawn& d = drawn_;
  const auto rounded = [](const Vector50& v) { return rounded_to<double>(listed(v)); };
  const auto exact = [&](const Vector50& v) {
    const std::vector<double> values = rounded(v);
    return Vector50(Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()))
                        .template cast<Digits50>());
  };
  const auto q = parted(separate(), exact(d.q), true);
  const auto qd = parted(separate(), exact(d.qd), false);
  const auto expected = [&](Function function) -> Results<Digits50> {
    if (function == Function::object_control_torque) {
      return {listed(put_together(ip::object_control_torque<Digits50>(
          separate(), q, qd, parted(separate(), exact(d.qdd_0), false), exact(d.xdd),
          exact(d.internal))))};
    }
    const auto motion = ip::object_forward_dynamics<Digits50>(
        separate(), q, qd, parted(separate(), exact(d.tau), false), gains_);
    Results<Digits50> results{listed(put_together(motion.qdd)), listed(motion.xdd_object),
                              listed(motion.f_grasp)};
    if (motion.internal.size() > 0) results.push_back(listed(motion.internal));
    return results;
  };
  const Mechanism mechanism =
      reduced_mechanism(drawn_.carried.joined.robot, drawn_.carried.joined.scene);
  const std::map<std::string, std::vector<double>> values{{"q", rounded(d.q)},
                                                          {"qd", rounded(d.qd)},
                                                          {"qdd_0", rounded(d.qdd_0)},
                                                          {"tau", rounded(d.tau)},
                                                          {"xdd_object", rounded(d.xdd)},
                                                          {"internal", rounded(d.internal)},
                                                          {"stabilisation", {20, 100}}};
  for (const Function function :
       {Function::object_control_torque, Function::object_forward_dynamics}) {
    const auto truth = expected(function);
    for (const Program& program : trace_function(mechanism, function)) {
      std::vector<std::vector<double>> arguments;
      for (const Argument& argument : program.arguments) {
        arguments.push_back(values.at(argument.name));
      }
      // Condition numbers are up to 1e7, and solves follow each other: 1e-6 is far above rounding
      // and far below a wrong sign.
      EXPECT_LE(relative_error(evaluate<double>(program, arguments), truth, 1), 1e-6)
          << program.name << " " << describe(program.route);
    }
  }
}

}  // namespace
}  // namespace treeline::tests
