// Would catch: a setting of the controller that is not taken, and robots or numbers that permit
// none and are not reported with their place and a remedy.
#include <gtest/gtest.h>

#include <array>

#include "description/read_keys.hpp"
#include "description/read_scene.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

const std::string kPoint = "operational_points: [{name: tip, link: tool}]\n";

/// Limits of the joint of which the URDF states none.
const std::string kShoulder = "shoulder: {speed: 2, torque: 9}";

TEST(ReadController, ReadsEverySetting) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(
      kPoint +
          "controller:\n  laws: [joint_impedance, force]\n  saturation: clamp\n  period: 0.002\n"
          "  joint_frequency: 12\n  task_frequency: 13\n  posture_frequency: 4\n"
          "  damping_ratio: 0.7\n  brake_damping: 9\n  position_margin: 0.01\n  speed_margin: 0.2\n"
          "  fade: 0.3\n  force_gain: 1\n  force_rate: 2\n  force_damping: 30\n  largest_force: 4\n"
          "  stale_ticks: 5\n  blind_ticks: 6\n"
          "  limits: {elbow: {lower: -0.5, upper: 0.5, speed: 2, torque: 3}, " +
          kShoulder + "}\n",
      "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  ASSERT_TRUE(scene->controller);
  const SceneController& c = *scene->controller;
  EXPECT_TRUE(c.task);
  EXPECT_TRUE(c.force);
  EXPECT_TRUE(c.clamps);
  EXPECT_EQ(c.period, 0.002);
  EXPECT_EQ(c.joint_frequency, 12);
  EXPECT_EQ(c.task_frequency, 13);
  EXPECT_EQ(c.posture_frequency, 4);
  EXPECT_EQ(c.damping_ratio, 0.7);
  EXPECT_EQ(c.brake_damping, 9);
  EXPECT_EQ(c.position_margin, 0.01);
  EXPECT_EQ(c.speed_margin, 0.2);
  EXPECT_EQ(c.fade, 0.3);
  EXPECT_EQ(c.force_gain, 1);
  EXPECT_EQ(c.force_rate, 2);
  EXPECT_EQ(c.force_damping, 30);
  EXPECT_EQ(c.largest_force, 4);
  EXPECT_EQ(c.stale_ticks, 5);
  EXPECT_EQ(c.blind_ticks, 6);
  const SceneJointLimits& elbow = c.limits.at("elbow");
  EXPECT_EQ(elbow.lower, -0.5);
  EXPECT_EQ(elbow.upper, 0.5);
  EXPECT_EQ(elbow.speed, 2);
  EXPECT_EQ(elbow.torque, 3);
}

/// A controller with these keys beside its law.
std::optional<Scene> read_with(const std::string& keys, Diagnostics& diagnostics) {
  return parse_scene("controller: {laws: joint_impedance, " + keys + "}\n", "s.yaml", make_robot(),
                     diagnostics);
}

// Would catch: a current without a torque, a motor that gives more than its current, a joint whose
// current nobody tells.
TEST(ReadController, ReadsMotors) {
  const std::string limits = "limits: {shoulder: {speed: 2}}, ";
  const std::string elbow = "elbow: {ratio: -50, torque_constant: 0.1, current: 2}";
  const std::string shoulder =
      "slide: {ratio: 900, torque_constant: 0.1}, "
      "shoulder: {ratio: 100, torque_constant: 0.05, current: 4}";
  Diagnostics diagnostics;
  const auto scene = read_with(limits + "motors: {" + elbow + ", " + shoulder + "}", diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_EQ(scene->controller->motors.at("elbow").ratio, -50);
  EXPECT_EQ(scene->controller->motors.at("shoulder").constant, 0.05);
  const Robot robot = make_robot();
  for (const Joint& joint : robot.joints) {
    // 100 * 0.05 N m/A * 4 A, where the URDF states nothing.
    if (joint.name == "shoulder") {
      EXPECT_EQ(limits_in_controller(joint, *scene->controller).effort.value(), 20);
    }
    if (joint.name == "elbow") {
      EXPECT_LE(limits_in_controller(joint, *scene->controller).effort.value(), 10);
    }
  }
  const auto expect_refused = [&](const std::string& keys, const std::string& fault) {
    Diagnostics refused;
    EXPECT_FALSE(read_with(limits + keys, refused)) << keys;
    EXPECT_NE(to_string(refused).find(fault), std::string::npos) << to_string(refused);
  };
  expect_refused("motors: {" + shoulder + "}", "not of joint \"elbow\"");
  expect_refused("motors: {" + shoulder + ", elbow: {ratio: 2}}", "\"torque_constant\" is missing");
  expect_refused("motors: {" + shoulder + ", elbow: {torque_constant: -1}}", "not positive");
  expect_refused("motors: {" + shoulder + ", elbow: {ratio: 0, torque_constant: 1}}", "no ratio");
}

// Would catch: sets of tasks that the step would not find, names that C does not take, and tasks
// that nobody does.
TEST(ReadController, ReadsBehaviours) {
  const auto read = [](const std::string& active, const std::string& keys,
                       Diagnostics& diagnostics) {
    return parse_scene("operational_points: [{name: tip, link: tool}, {name: mid, link: upper}]\n" +
                           active + "controller: {laws: task_impedance, limits: {" + kShoulder +
                           "}, " + keys + "}\n",
                       "s.yaml", make_robot(), diagnostics);
  };
  const std::string both = "inputs: {active: [mid, tip]}\n", mid = "inputs: {active: [mid]}\n";
  Diagnostics diagnostics;
  const auto scene =
      read(both, "behaviours: {reach: [tip], free: [], all: [tip, mid]}", diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  const auto& behaviours = scene->controller->behaviours;
  ASSERT_EQ(behaviours.size(), 3U);
  EXPECT_EQ(behaviours[0].name, "reach");
  EXPECT_TRUE(behaviours[1].tasks.empty());
  EXPECT_EQ(behaviours[2].tasks, (std::vector<std::string>{"tip", "mid"}));
  const std::array<std::string, 3> refused[] = {
      {both, "fade: 0.2",
       "the task of \"mid\" comes and goes, but the controller has no behaviour"},
      {mid, "behaviours: {reach: [tip]}", "the task of \"tip\" does not come and go"},
      {mid, "behaviours: {reach: [mit]}", "there is no operational point \"mit\""},
      {mid, "behaviours: {reach: [mid, mid]}", "listed twice"},
      {mid, "behaviours: {reach out: [mid]}", "cannot be a name"},
      {mid, "behaviours: {reach: [mid], Reach: []}", "in capitals it is the same name"},
      {mid, "behaviours: {reach: mid}", "list"}};
  for (const auto& [active, keys, fault] : refused) {
    Diagnostics told;
    EXPECT_FALSE(read(active, keys, told)) << keys;
    EXPECT_NE(to_string(told).find(fault), std::string::npos) << to_string(told);
  }
  Diagnostics told;
  EXPECT_FALSE(read_with("limits: {" + kShoulder + "}, behaviours: {none: []}", told));
  EXPECT_NE(to_string(told).find("no law of tasks"), std::string::npos) << to_string(told);
}

// Would catch: scenes whose defaults the step itself calls unsound, so that the robot never runs;
// and faults of a controller that are told at the first line of the scene.
TEST(ReadController, RefusesWhatItsStepWouldNotTake) {
  const std::pair<std::string, std::string> scenes[] = {
      {"brake_damping: 0, limits: {" + kShoulder + "}", "0 is not between"},
      {"limits: {shoulder: {speed: 2, torque: none}}, motors: {elbow: {torque_constant: 1}, "
       "slide: {torque_constant: 1}, shoulder: {torque_constant: 1}}",
       "s.yaml:2: error: controller: the torque of joint \"shoulder\" has no limit"}};
  for (const auto& [keys, fault] : scenes) {
    Diagnostics refused;
    EXPECT_FALSE(
        parse_scene("gravity: [0, 0, -9.81]\ncontroller: {laws: joint_impedance, " + keys + "}\n",
                    "s.yaml", make_robot(), refused));
    EXPECT_NE(to_string(refused).find(fault), std::string::npos) << to_string(refused);
  }
}

TEST(ReadController, RefusesAnObserverThatIsTooLate) {
  const std::string limits = "limits: {" + kShoulder + "}, ";
  Diagnostics diagnostics;
  EXPECT_TRUE(read_with(limits + "observer: 300", diagnostics)) << to_string(diagnostics);
  EXPECT_FALSE(read_with(limits + "observer: 100", diagnostics));
  EXPECT_NE(to_string(diagnostics).find("too late for a hold_frequency"), std::string::npos);
  Diagnostics fast;
  EXPECT_FALSE(read_with(limits + "observer: 600", fast));
  EXPECT_NE(to_string(fast).find("which a period of 0.001 s cannot follow"), std::string::npos);
}

// Would catch: gains of laws that the controller does not have, which a slow loop cannot follow.
TEST(ReadController, JudgesGainsOfItsOwnLaws) {
  const std::string slow = "period: 0.02, brake_damping: 10, limits: {" + kShoulder + "}}";
  Diagnostics joints;
  EXPECT_TRUE(
      parse_scene("controller: {laws: joint_impedance, " + slow, "s.yaml", make_robot(), joints))
      << to_string(joints);
  Diagnostics forces;
  EXPECT_FALSE(
      parse_scene(kPoint + "controller: {laws: force, " + slow, "s.yaml", make_robot(), forces));
  EXPECT_NE(to_string(forces).find("force_damping is 60 a second"), std::string::npos);
}

TEST(ReadController, OneLawNeedsNoListAndJointsNoPoint) {
  Diagnostics diagnostics;
  const auto scene = parse_scene("controller: {laws: joint_impedance, limits: {" + kShoulder + "}}",
                                 "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_FALSE(scene->controller->task);
  EXPECT_FALSE(scene->controller->force);
}

TEST(ReadController, TakesForcesAndInputsOfTheScene) {
  Diagnostics diagnostics;
  const auto scene =
      parse_scene(kPoint +
                      "functions: [center_of_mass]\nexternal_forces: [{name: cable, link: fore}]\n"
                      "inputs: {gravity: true, tool: tip, payload: tool}\n"
                      "controller: {laws: [force], limits: {" +
                      kShoulder + "}}\n",
                  "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene);
  for (const Diagnostic& each : diagnostics.list()) {
    EXPECT_EQ(each.fault.find("no function"), std::string::npos) << to_string(each);
  }
}

TEST(ReadController, SaysWhatIsWrong) {
  expect_told({
      {"controller: {law: force}",
       {Severity::error, 1, "controller/law", "unknown", "did you mean \"laws\"?"}},
      {"controller: {period: 0.001}",
       {Severity::error, 1, "controller", "\"laws\" is missing", "joint_impedance"}},
      {"controller: {laws: impedance}",
       {Severity::error, 1, "controller/laws", "\"impedance\"", "joint_impedance"}},
      {"controller: {laws: []}",
       {Severity::error, 1, "controller/laws", "no law is listed", "joint_impedance"}},
      {"controller: {laws: [force, force]}",
       {Severity::error, 1, "controller/laws[1]", "listed twice", "once"}},
      {"controller: {laws: joint_impedance, period: 0}",
       {Severity::error, 1, "controller/period", "0 is not between", "such as 0.001"}},
      {"controller: {laws: joint_impedance, joint_frequency: 800}",
       {Severity::error, 1, "controller", "joint_frequency is 800", "at 500 or below"}},
      {kPoint + "controller: {laws: force, force_rate: 70}",
       {Severity::error, 2, "controller", "force_rate 70", "below force_damping"}},
      {"controller: {laws: joint_impedance, stale_ticks: 1.5}",
       {Severity::error, 1, "controller/stale_ticks", "1.5 is no number of steps", "whole number"}},
      {"controller: {laws: joint_impedance, saturation: cut}",
       {Severity::error, 1, "controller/saturation", "\"cut\"", "scale"}},
      {"controller: {laws: joint_impedance, limits: {elbo: {speed: 1}}}",
       {Severity::error, 1, "controller/limits/elbo", "elbo", "did you mean \"elbow\"?"}},
      {"controller: {laws: joint_impedance, limits: {follow: {speed: 1}}}",
       {Severity::error, 1, "controller/limits/follow", "follows another", "that it follows"}},
      {"controller: {laws: joint_impedance, limits: {elbow: {torque: 0}}}",
       {Severity::error, 1, "controller/limits/elbow/torque", "0 is not positive", "no limit"}},
      {"controller: {laws: joint_impedance, limits: {elbow: {lower: 1, upper: 0}}}",
       {Severity::error, 1, "controller/limits/elbow", "not below", "exchange"}},
      {"controller: {laws: task_impedance}",
       {Severity::error, 1, "controller", "no operational point", "operational_points"}},
      {"base: floating\ncontroller: {laws: joint_impedance}",
       {Severity::error, 2, "controller", "floating base", "supported_control_torque"}},
      {"passive: [elbow]\ncontroller: {laws: joint_impedance}\n"
       "functions: [supported_control_torque]\noperational_points: [{name: t, link: tool, rows: "
       "[x]}]",
       {Severity::error, 2, "controller", "\"elbow\" is passive", "supported_control_torque"}},
      {"couplings: [{name: belt, joints: {elbow: 1, shoulder: -1}}]\n"
       "controller: {laws: joint_impedance}",
       {Severity::error, 2, "controller", "constraints or couplings", "loop of your own"}},
      {"singular: exact\ncontroller: {laws: task_impedance}\n"
       "operational_points: [{name: t, link: tool, rows: [x]}]",
       {Severity::error, 2, "controller", "singular: exact", "leave out singular"}},
  });
}

}  // namespace
}  // namespace treeline
