#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "data/list_data.hpp"
#include "description/read_urdf.hpp"
#include "passes/count_operations.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/read_robots.hpp"
#include "with_noise.hpp"

// Every function by every route, for robots whose zeros, quarter turns and axes contain noise,
// compared with the interpreter in 50 digits for the noisy file as written. Would catch: frames
// placed where axes intersect that are parallel up to noise, matrices that noise has made no
// rotations, meaningful numbers that are dropped, and operations for meaningless ones.

namespace treeline::tests {
namespace {

/// From the errors of a scanner to differences that no number can express.
constexpr std::array kNoise{1e-3,  1e-5,  1e-8,  1e-11, 1e-13, 1e-14, 1e-15, 5e-16, 1e-16,
                            1e-17, 1e-20, 1e-24, 1e-27, 1e-30, 1e-32, 1e-40, 1e-45, 1e-60};
/// Noise below this costs nothing.
constexpr double kFree = 1e-16;

int total_operations(const CheckedPrograms& programs) {
  int total = 0;
  for (const auto& [function, routes] : programs.programs()) {
    for (const Program& program : routes) total += count_operations(program).flops();
  }
  return total;
}

double moved_mass(const interpreter::Model<Digits50>& model) {
  double mass = 0;
  std::vector<bool> moves;
  for (const auto& body : model.bodies) {
    const bool carried = body.parent >= 0 && moves[static_cast<std::size_t>(body.parent)];
    moves.push_back(carried || body.kind != interpreter::JointKind::fixed);
    if (moves.back()) mass += static_cast<double>(body.mass);
  }
  return mass;
}

/// The usual scales, except for the robot's weight. In sum m g . (column of J) the terms are at
/// most |g| sqrt(sum m) sqrt(M_ii), by Cauchy-Schwarz. Changing an angle by its last bit, which is
/// the size of noise, causes forces of that size times this bit, even if gravity does almost no
/// work.
Yardstick with_weight(const CheckedPrograms& programs, const Inputs<Digits50>& in) {
  Yardstick size = yardstick(programs.oracle(), in);
  const auto& model = programs.oracle().model();
  const auto g = static_cast<double>(model.gravity.norm());
  size.force = std::max(size.force, g * std::sqrt(moved_mass(model) * size.force));
  return size;
}

/// Errors of all routes at one ordinary state, except for functions whose solve keeps no digits
/// there.
void compare(const CheckedPrograms& programs, std::uint64_t seed, ErrorTable& table) {
  Rng rng(seed);
  const Inputs<double> in = rounded_to<double>(programs.oracle().random_inputs(rng));
  const Inputs<Digits50> exact = rounded_to<Digits50>(in);
  const Yardstick size = with_weight(programs, exact);
  for (const auto& [function, routes] : programs.programs()) {
    if (!permits(function, programs.oracle().has_points(), size)) continue;
    if (!(size.growth(function) < 1e12)) continue;
    const Results<Digits50> expected = programs.oracle().results(function, exact);
    for (const Program& program : routes) {
      const auto results = evaluate<double>(program, CheckedPrograms::arguments(program, in));
      const double error = relative_error(results, expected, size.least_scale(function));
      table.note(function, describe(program.route), error * 0x1p52, size.growth(function));
    }
  }
}

/// Compares at every `stride`-th kind of noise.
void expect_same_digits(const RandomMechanism& made, std::uint64_t seed, std::size_t first,
                        std::size_t stride) {
  const CheckedPrograms clean(made.robot, made.scene);
  const int operations = total_operations(clean);
  for (std::size_t k = first; k < kNoise.size(); k += stride) {
    SCOPED_TRACE(testing::Message() << "noise " << kNoise[k] << ", seed " << seed);
    const RandomMechanism noisy = with_noise(made, kNoise[k], seed);
    const CheckedPrograms programs(noisy.robot, noisy.scene);
    ErrorTable table;
    compare(programs, seed, table);
    table.expect_below(kUlpBound);
    if (kNoise[k] <= kFree) {
      EXPECT_LE(total_operations(programs), operations);
    }
  }
}

RandomOptions options_of(std::uint64_t seed) {
  RandomOptions options;
  options.joints = 6;
  options.aligned = seed % 3 == 0 ? 0.5 : 0.95;
  options.floating_base = seed % 4 == 1;
  options.mix.fixed = 2;
  options.external_forces = 1;
  options.mimic = seed % 4 == 2 ? 0.3 : 0;
  if (seed % 5 == 3) options.mix.ball = 5;
  return options;
}

RandomMechanism drawn(std::uint64_t seed) {
  RandomMechanism made = random_mechanism(seed, options_of(seed));
  made.scene.noise = kResolution;
  return made;
}

TEST(Noise, CostsNoDigitsInRandomRobots) {
  // In the last two, gravity does almost no work.
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 70U, 83U}) {
    SCOPED_TRACE(described(seed, options_of(seed)));
    expect_same_digits(drawn(seed), seed, seed % 3, 3);
  }
}

// Without any correction of noise, the frames alone must be sound.
TEST(Noise, ThatIsKeptCostsNoDigits) {
  for (std::uint64_t seed = 11; seed <= 14; ++seed) {
    const RandomOptions options = options_of(seed);
    const RandomMechanism made = random_mechanism(seed, options);
    for (std::size_t k = seed % 4; k < kNoise.size(); k += 4) {
      SCOPED_TRACE(testing::Message() << described(seed, options) << ", noise " << kNoise[k]);
      const RandomMechanism noisy = with_noise(made, kNoise[k], seed);
      ErrorTable table;
      compare(CheckedPrograms(noisy.robot, noisy.scene), seed, table);
      table.expect_below(kUlpBound);
    }
  }
}

TEST(Noise, CostsNoDigitsInTheProjectsRobots) {
  std::size_t first = 0;
  for (const auto& [name, robot, scene] : read_robots()) {
    if (name.rfind("humanoid24", 0) == 0 && name != "humanoid24/scene") continue;
    SCOPED_TRACE(name);
    expect_same_digits({robot, scene}, 1, first++ % 6, 6);
  }
}

/// The published robot on this base, with a point on the last link of the file.
RandomMechanism published(const DataRobot& data, Base base) {
  Diagnostics diagnostics;
  RandomMechanism made;
  made.robot = read_urdf(data.path, diagnostics).value();
  made.scene.base = base;
  ScenePoint point;
  point.name = "last";
  point.link = made.robot.links.back().name;
  point.origin.xyz = {0.1, 0.02, 0};
  made.scene.operational_points = {point};
  return made;
}

// As published, with the residues of their CAD programs, and with more noise.
TEST(Noise, CostsNoDigitsInPublishedRobots) {
  std::uint64_t seed = 0;
  for (const DataRobot& data : data_robots("published")) {
    for (const Base base : {Base::fixed, Base::floating}) {
      const double added = kNoise[++seed % kNoise.size()];
      const RandomMechanism made = published(data, base);
      if (model_from_robot<double>(made.robot, made.scene).nv == 0) continue;
      for (const double noise : {0.0, added}) {
        SCOPED_TRACE(testing::Message()
                     << data.name << (base == Base::fixed ? ", fixed" : ", floating")
                     << ", noise added " << noise);
        const RandomMechanism noisy = with_noise(made, noise, seed);
        ErrorTable table;
        compare(CheckedPrograms(noisy.robot, noisy.scene), seed, table);
        table.expect_below(kUlpBound);
      }
    }
  }
}

/// Four revolute joints, each parallel to the one before up to noise.
RandomMechanism nearly_parallel_chain(double noise, std::size_t axis) {
  RandomMechanism made;
  Robot& robot = made.robot;
  robot.name = "chain";
  robot.root = 0;
  Rng rng(4);
  robot.links.push_back({"base", {}, 0});
  for (int i = 0; i < 4; ++i) {
    Joint joint;
    joint.name = "joint_" + std::to_string(i);
    joint.type = JointType::continuous;
    joint.parent = i;
    joint.child = i + 1;
    joint.origin.xyz = {0.05, 0.02, 0.03};
    joint.origin.rpy = {noise, noise / 7, 0};
    joint.axis = {0, 0, 0};
    joint.axis[axis] = 1;
    robot.joints.push_back(joint);
    robot.links.push_back({"link_" + std::to_string(i), detail::random_inertial(rng, 0), 0});
  }
  return made;
}

TEST(Noise, CostsNoDigitsInAChainOfNearlyParallelAxes) {
  for (int exponent = 3; exponent <= 60; ++exponent) {
    for (const std::size_t axis : {0U, 1U, 2U}) {
      SCOPED_TRACE(testing::Message() << "noise 1e-" << exponent << ", axis " << axis);
      RandomMechanism made = nearly_parallel_chain(std::pow(10, -exponent), axis);
      for (const double limit : {kResolution, 0.0}) {
        made.scene.noise = limit;
        ErrorTable table;
        compare(CheckedPrograms(made.robot, made.scene), 1, table);
        table.expect_below(kUlpBound);
      }
    }
  }
}

// What is taken as exact changes by at most the resolution of double, and a small angle stays an
// angle.
TEST(Noise, ThatIsAnAngleCounts) {
  const RandomMechanism exact = nearly_parallel_chain(0, 2);
  const RandomMechanism slight = nearly_parallel_chain(1e-14, 2);
  const CheckedPrograms programs(slight.robot, slight.scene);
  const CheckedPrograms other(exact.robot, exact.scene);
  EXPECT_GT(total_operations(programs), total_operations(other));
}

}  // namespace
}  // namespace treeline::tests
