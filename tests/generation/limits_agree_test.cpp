// Would catch: a reader of joint limits with a rule of its own. Of random robots whose files have
// placeholders, missing limits and followers with limits, what the table of joints, the controller,
// drive, the domain of rounding bounds and torque_limits have must be what was drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "description/diagnosed.hpp"
#include "description/limited_arm.hpp"
#include "description/read_scene.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/descriptions.hpp"
#include "generation/compose.hpp"
#include "generation/describe_scene.hpp"
#include "launch/describe_robot.hpp"
#include "mechanism/build_mechanism.hpp"

namespace treeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Files' digits that fold a follower's limits are dropped below a millionth.
constexpr double kRounding = 1e-5;

/// What a file says of a joint, and what that means.
struct DrawnJoint {
  std::string name, type, attributes;
  double lower = -kInfinity, upper = kInfinity, velocity = kInfinity, effort = kInfinity;

  [[nodiscard]] bool has_range() const { return type != "continuous"; }
  [[nodiscard]] bool slides() const { return type == "prismatic"; }
};

struct DrawnRobot {
  std::string text;
  std::map<std::string, DrawnJoint> joints;  ///< that lead or are alone
};

class Draw {
 public:
  explicit Draw(unsigned seed) : rng_(seed) {}

  DrawnRobot robot() {
    DrawnRobot drawn;
    drawn.text = "<robot name='r'><link name='l0'/>";
    for (int i = 0; i < 5; ++i) {
      const std::string at = std::to_string(i), child = "l" + std::to_string(i + 1);
      DrawnJoint drawn_joint = joint("j" + at);
      if (i == 0) state_effort(drawn_joint);
      std::string mimic;
      if (i > 2) {
        const double multiplier = std::array{-2.0, -0.5, 0.25, 3.0}[below(4)];
        const std::string leader = "j" + std::to_string(below(3));
        mimic = "<mimic joint='" + leader + "' multiplier='" + std::to_string(multiplier) + "'/>";
        fold(drawn_joint, multiplier, drawn.joints.at(leader));
      } else {
        drawn.joints[drawn_joint.name] = drawn_joint;
      }
      drawn.text +=
          limited_link(child) + limited_joint(drawn_joint.name, drawn_joint.type, "l" + at, child,
                                              drawn_joint.attributes, mimic);
    }
    drawn.text += "</robot>";
    return drawn;
  }

 private:
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(rng_);
  }

  /// With the digits that a file has.
  double number(double most) {
    return std::round(std::uniform_real_distribution<double>(0.1, most)(rng_) * 100) / 100;
  }

  static std::string print(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
  }

  void add(DrawnJoint& joint, const char* name, const std::string& value) {
    joint.attributes += std::string(name) + "='" + value + "' ";
  }

  DrawnJoint joint(const std::string& name) {
    DrawnJoint joint;
    joint.name = name;
    joint.type = std::array{"revolute", "prismatic", "continuous"}[below(3)];
    if (below(8) == 0) return joint;
    draw_range(joint);
    if (const std::size_t kind = below(7); kind < 3) {
      joint.velocity = std::array{number(9), number(99), 100 + number(900)}[kind];
      add(joint, "velocity", print(joint.velocity));
    } else if (kind < 6) {
      add(joint, "velocity", std::array{"0", "-1", "1e8"}[kind - 3]);
    }
    if (const std::size_t kind = below(6); kind < 2) {
      state_effort(joint);
    } else if (kind < 5) {
      add(joint, "effort", std::array{"0", "-1", "1e9"}[kind - 2]);
    }
    return joint;
  }

  void state_effort(DrawnJoint& joint) {
    if (joint.attributes.find("effort") != std::string::npos) {
      joint.attributes.erase(joint.attributes.find("effort"));  // it stands last
    }
    joint.effort = number(400);
    add(joint, "effort", print(joint.effort));
  }

  void draw_range(DrawnJoint& joint) {
    const double low = -number(3), high = number(3);
    const std::size_t kind = below(7);
    if (kind == 6) return;
    const std::array<std::array<std::string, 2>, 6> ends = {{{print(low), print(high)},
                                                             {"", print(high)},
                                                             {print(high), print(low)},
                                                             {"0", "0"},
                                                             {"-1e8", "1e8"},
                                                             {print(low), "1e16"}}};
    const auto& [lower, upper] = ends[kind];
    if (!lower.empty()) add(joint, "lower", lower);
    add(joint, "upper", upper);
    if (!joint.has_range()) return;
    if (kind == 0 || kind == 5) joint.lower = low;
    if (kind == 1) joint.lower = 0;
    if (kind < 2) joint.upper = high;
  }

  static void fold(const DrawnJoint& follower, double multiplier, DrawnJoint& leader) {
    leader.velocity = std::min(leader.velocity, follower.velocity / std::abs(multiplier));
    double low = follower.lower / multiplier, high = follower.upper / multiplier;
    if (low > high) std::swap(low, high);
    low = std::max(low, leader.lower);
    high = std::min(high, leader.upper);
    if (low >= high) return;
    leader.lower = low;
    leader.upper = high;
  }

  std::mt19937 rng_;
};

void expect_limit(double found, double expected, const char* what) {
  if (std::isinf(expected)) {
    EXPECT_EQ(found, expected) << what;
  } else {
    EXPECT_NEAR(found, expected, kRounding * std::max(1.0, std::abs(expected))) << what;
  }
}

std::vector<double> numbers_of(const std::string& list) {
  std::vector<double> numbers;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ',');) numbers.push_back(std::stod(word));
  return numbers;
}

/// A controller with every limit that the robot lacks waived by name, or with none.
std::string controller_text(const DrawnRobot& drawn, bool waives) {
  std::string text = "controller: {laws: joint_impedance, limits: {";
  for (const auto& [name, joint] : drawn.joints) {
    std::string keys;
    const auto waive = [&keys](double limit, const char* key) {
      if (std::isinf(limit)) keys += (keys.empty() ? "" : ", ") + std::string(key) + ": none";
    };
    waive(joint.lower, "lower");
    waive(joint.upper, "upper");
    waive(joint.velocity, "speed");
    waive(joint.effort, "torque");
    if (!keys.empty() && waives) text += name + ": {" + keys + "}, ";
  }
  return text + "}}";
}

bool lacks_limits(const DrawnRobot& drawn) {
  return std::any_of(drawn.joints.begin(), drawn.joints.end(), [](const auto& named) {
    const DrawnJoint& joint = named.second;
    return std::isinf(joint.velocity) || std::isinf(joint.effort) ||
           (joint.has_range() && (std::isinf(joint.lower) || std::isinf(joint.upper)));
  });
}

class LimitsAgree : public testing::TestWithParam<unsigned> {
 protected:
  LimitsAgree() {
    Diagnostics diagnostics;
    robot_ = parse_urdf(drawn_.text, "r.urdf", diagnostics);
    EXPECT_TRUE(robot_) << to_string(diagnostics) << drawn_.text;
    scene_ = parse_scene(controller_text(drawn_, true), "s.yaml", robot_.value(), diagnostics);
    EXPECT_TRUE(scene_) << to_string(diagnostics) << drawn_.text;
    mechanism_ = build_mechanism(*robot_, scene_.value());
  }

  /// Calls visit(i, joint) for each coordinate.
  template <class Visit>
  void for_each_joint(const Visit& visit) const {
    for (std::size_t i = 0; i < mechanism_.coordinates.size(); ++i) {
      const DrawnJoint& joint = drawn_.joints.at(mechanism_.coordinates[i].joint);
      SCOPED_TRACE(joint.name + ": " + joint.attributes);
      visit(i, joint);
    }
  }

  DrawnRobot drawn_ = Draw(GetParam()).robot();
  std::optional<Robot> robot_;
  std::optional<Scene> scene_;
  Mechanism mechanism_;
};

TEST_P(LimitsAgree, InTheTableOfJoints) {
  const EmissionContext context = describe_scene(*robot_, *scene_, mechanism_);
  const auto holes = describe_joints(context, cpp::make_syntax(context), "inf").holes;
  for_each_joint([&](std::size_t i, const DrawnJoint& joint) {
    expect_limit(numbers_of(holes.at("lower_limits")).at(i), joint.lower, "lower");
    expect_limit(numbers_of(holes.at("upper_limits")).at(i), joint.upper, "upper");
    expect_limit(numbers_of(holes.at("velocity_limits")).at(i), joint.velocity, "velocity");
    expect_limit(numbers_of(holes.at("effort_limits")).at(i), joint.effort, "effort");
  });
}

TEST_P(LimitsAgree, InTheController) {
  const ControllerUnit unit = compose_controller(*robot_, *scene_, mechanism_);
  for_each_joint([&](std::size_t i, const DrawnJoint& joint) {
    expect_limit(unit.joints.at(i).lower, joint.lower, "lower");
    expect_limit(unit.joints.at(i).upper, joint.upper, "upper");
    expect_limit(unit.joints.at(i).speed, joint.velocity, "speed");
    expect_limit(unit.joints.at(i).torque, joint.effort, "torque");
  });
  Diagnostics diagnostics;
  const bool is_taken =
      parse_scene(controller_text(drawn_, false), "s.yaml", *robot_, diagnostics).has_value();
  EXPECT_EQ(is_taken, !lacks_limits(drawn_)) << to_string(diagnostics);
}

TEST_P(LimitsAgree, InDrive) {
  const auto description = describe_robot(*robot_, {}, {}, mechanism_);
  for_each_joint([&](std::size_t i, const DrawnJoint& joint) {
    const drive::DrivenCoordinate& driven = description.coordinates.at(i);
    expect_limit(driven.lower, joint.lower, "lower");
    expect_limit(driven.upper, joint.upper, "upper");
    expect_limit(driven.velocity, joint.velocity, "velocity");
    expect_limit(driven.effort, joint.effort, "effort");
  });
}

TEST_P(LimitsAgree, InTheDomainOfBounds) {
  const Domain domain = make_domain(*robot_, *scene_, mechanism_);
  for_each_joint([&](std::size_t i, const DrawnJoint& joint) {
    const std::string index = "[" + std::to_string(i) + "]";
    const double reach = std::max(std::abs(joint.lower), std::abs(joint.upper));
    const double without = joint.slides() ? 10 : std::numbers::pi;
    expect_limit(domain.find("q" + index).value(), std::isinf(reach) ? without : reach, "q");
    const double speed = std::isinf(joint.velocity) ? 10 : std::min(joint.velocity, 100.0);
    expect_limit(domain.find("qd" + index).value(), speed, "qd");
    const double force = std::isinf(joint.effort) ? 1000 : joint.effort;
    expect_limit(domain.find("tau" + index).value(), force, "tau");
  });
}

TEST_P(LimitsAgree, InTorqueLimits) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(
      "base: floating\noperational_points: [{name: hand, link: l3, rows: [x]}]\n"
      "constraints: [{name: foot, between: [l0, world]}]\ntorque_limits: urdf\n",
      "s.yaml", *robot_, diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  std::map<std::string, double> expected;
  for (const auto& [name, joint] : drawn_.joints) {
    if (!std::isinf(joint.effort)) expected[name] = joint.effort;
  }
  EXPECT_EQ(scene->torque_limits, expected);
}

INSTANTIATE_TEST_SUITE_P(Seeds, LimitsAgree, testing::Range(0U, 60U));

}  // namespace
}  // namespace treeline
