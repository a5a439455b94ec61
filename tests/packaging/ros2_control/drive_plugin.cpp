// Drives a generated controller as a controller manager does, and the step of the same code in C
// beside it. Would catch: joints in another order, parameters and messages that are read wrongly,
// commands that are lost or overtake an emergency stop, torques other than those of C, and an
// update that takes memory or waits for a lock.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <controller_interface/controller_interface.hpp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <limits>
#include <memory>
#include <std_srvs/srv/trigger.hpp>
#include <string>
#include <trajectory_msgs/msg/joint_trajectory.hpp>
#include <vector>

#include "arm.h"
#include "arm_joints.h"
#ifndef GRAVITY
#include "arm_controller.h"
#endif

extern "C" controller_interface::ControllerInterface* make_plugin();

// In count_taken.cpp: memory and locks that were taken while `updating`.
extern std::atomic<bool> updating;
extern std::atomic<int> taken;

namespace {

using controller_interface::CallbackReturn;
using controller_interface::return_type;
constexpr int kJoints = sizeof arm_velocity_joints / sizeof *arm_velocity_joints;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void require(bool holds, const char* what, int line) {
  if (holds) return;
  std::printf("line %d: %s\n", line, what);
  for (const std::string& logged : rclcpp::logged()) std::printf("  logged: %s\n", logged.c_str());
  std::exit(1);
}
#define REQUIRE(...) require((__VA_ARGS__), #__VA_ARGS__, __LINE__)

bool was_logged(const std::string& part) {
  bool found = false;
  for (const std::string& line : rclcpp::logged()) found = found || line.find(part) != line.npos;
  rclcpp::logged().clear();
  return found;
}

/// What a controller manager does with the plugin.
struct Manager {
  std::unique_ptr<controller_interface::ControllerInterface> plugin{make_plugin()};
  std::vector<std::string> state_names, command_names;
  std::vector<double> states, commands;

  rclcpp_lifecycle::LifecycleNode& node() { return *plugin->get_node(); }

  bool configure() { return plugin->on_configure({}) == CallbackReturn::SUCCESS; }

  bool activate() {
    state_names = plugin->state_interface_configuration().names;
    command_names = plugin->command_interface_configuration().names;
    states.assign(state_names.size(), 0);
    commands.assign(command_names.size(), kNaN);
    lend();
    return plugin->on_activate({}) == CallbackReturn::SUCCESS;
  }

  void lend() {
    std::vector<hardware_interface::LoanedStateInterface> lent_states;
    std::vector<hardware_interface::LoanedCommandInterface> lent_commands;
    for (std::size_t i = 0; i < states.size(); ++i) {
      lent_states.emplace_back(state_names[i], &states[i]);
    }
    for (std::size_t i = 0; i < commands.size(); ++i) {
      lent_commands.emplace_back(command_names[i], &commands[i]);
    }
    plugin->assign_interfaces(std::move(lent_commands), std::move(lent_states));
  }

  /// An update, which may neither take memory nor a lock.
  void update(double period) {
    updating = true;
    const return_type result = plugin->update({}, rclcpp::Duration(period));
    updating = false;
    REQUIRE(result == return_type::OK && taken == 0);
  }

  double& state(const std::string& joint, const char* kind) {
    return states[static_cast<std::size_t>(
        std::find(state_names.begin(), state_names.end(), joint + "/" + kind) -
        state_names.begin())];
  }
};

template <class Number>
bool same_bits(double given, Number expected) {
  const double wanted = static_cast<double>(expected);
  return std::memcmp(&given, &wanted, sizeof given) == 0;
}

/// Names of joints other than the robot's, in another order, or missing are refused by name.
void check_names() {
  std::vector<std::string> own(arm_velocity_joints, arm_velocity_joints + kJoints), other = own;
  std::swap(other[0], other[1]);
  Manager manager;
  REQUIRE(manager.plugin->on_init() == CallbackReturn::SUCCESS);
  for (const auto& names : {other, {own.begin(), own.end() - 1}, std::vector<std::string>{}}) {
    manager.node().overrides["joints"] = names;
    REQUIRE(!manager.configure() && was_logged("`" + own[0] + "`"));
  }
  manager.node().overrides["joints"] = own;
  manager.node().overrides["prefix"] = std::string("left_");
  REQUIRE(manager.configure() && manager.activate());
  REQUIRE(manager.command_names[0] == "left_" + own[0] + "/effort");
  std::swap(manager.state_names[0], manager.state_names[1]);
  manager.lend();
  REQUIRE(manager.plugin->on_activate({}) == CallbackReturn::ERROR && was_logged(own[0]));
}

#ifdef GRAVITY

void drive() {
  Manager manager;
  REQUIRE(manager.plugin->on_init() == CallbackReturn::SUCCESS);
  manager.node().overrides["brakes"] = std::string("brakes/closed");
  REQUIRE(manager.configure() && manager.activate());
  REQUIRE(manager.state_names.size() == kJoints && manager.command_names.size() == kJoints + 1);
  arm_real q[kJoints] = {}, g[kJoints];
  for (int k = 0; k < 1000; ++k) {
    for (int i = 0; i < kJoints; ++i) {
      q[i] = static_cast<arm_real>(std::sin(0.01 * k * (i + 1)));
      manager.states[i] = q[i];
    }
    if (k == 0) manager.states[2] = kNaN;  // no torque before all joints were measured
    if (k == 500) {                        // the joint stays where it was
      manager.states[1] = kNaN;
      q[1] = static_cast<arm_real>(std::sin(0.01 * 499 * 2));
    }
    manager.update(0.001);
    arm_gravity(q, g);
    for (int i = 0; i < kJoints; ++i) {
      REQUIRE(k == 0 ? manager.commands[i] == 0 : same_bits(manager.commands[i], g[i]));
    }
    REQUIRE(manager.commands[kJoints] == (k == 0 ? 1 : 0));
  }
  REQUIRE(manager.plugin->on_deactivate({}) == CallbackReturn::SUCCESS);
  for (int i = 0; i < kJoints; ++i) REQUIRE(manager.commands[i] == 0);
  REQUIRE(manager.commands[kJoints] == 1);
}

#else

constexpr double kPeriod = 0.002;

/// The step in C, commanded by structs.
struct Reference {
  arm_config config{};
  arm_state state{};
  arm_input input{};
  arm_output output{};
  arm_command command{};

  Reference() {
    arm_default_config(&config);
    config.period = arm_number(1) / arm_number(500);
    config.stale_ticks = 0;
    config.joint_frequency[1] = 15;
  }
  void tell(int32_t kind) {
    command.kind = kind;
    ++command.sequence;
  }
  void step(const double* measured) {
    input.command = command;
    for (int i = 0; i < kJoints; ++i) {
      input.q[i] = static_cast<arm_number>(measured[i]);
      input.qd[i] = static_cast<arm_number>(measured[kJoints + i]);
    }
    arm_step(&config, &state, &input, &output);
  }
};

/// The robot that the torques move, by another function of the code.
struct Robot {
  arm_real q[kJoints] = {0, arm_real(-0.7), arm_real(0.4), 0, arm_real(0.8), 0}, qd[kJoints] = {};

  void move(const double* commands) {
    arm_real tau[kJoints], qdd[kJoints];
    for (int i = 0; i < kJoints; ++i) tau[i] = static_cast<arm_real>(commands[i]);
    arm_forward_dynamics(q, qd, tau, qdd);
    for (int i = 0; i < kJoints; ++i) {
      qd[i] += arm_real(kPeriod) * qdd[i];
      q[i] += arm_real(kPeriod) * qd[i];
    }
  }
};

class Drive {
 public:
  Drive() {
    REQUIRE(manager_.plugin->on_init() == CallbackReturn::SUCCESS);
    manager_.plugin->update_rate = 500;
    std::vector<double> frequencies(kJoints, 20.0);
    frequencies[1] = -1;
    node().overrides["joint_frequency"] = frequencies;
    REQUIRE(!manager_.configure() && was_logged("number 1 of member 9 "));
    frequencies[1] = 15;
    node().overrides["joint_frequency"] = frequencies;
    node().overrides["brakes"] = std::string("brakes/closed");
    REQUIRE(manager_.configure());
    REQUIRE(!node().call<std_srvs::srv::Trigger>("~/start"));  // not active
    REQUIRE(manager_.activate());
    REQUIRE(manager_.state_names.size() == 2 * kJoints);
    REQUIRE(manager_.command_names.size() == kJoints + 1);
    reference_.tell(ARM_START);
  }

  /// Updates, of which the first takes a command that is not refused.
  void update(int count) {
    for (int k = 0; k < count; ++k) {
      for (int i = 0; i < kJoints; ++i) {
        const std::string joint = arm_velocity_joints[i];
        manager_.state(joint, "position") = measured_[i] = robot_.q[i];
        manager_.state(joint, "velocity") = measured_[kJoints + i] = robot_.qd[i];
      }
      if (lost_ >= 0) {
#ifdef HUMBLE
        manager_.states[lost_] = kNaN;
#else
        manager_.states[lost_] = hardware_interface::Handle::kBusy;
#endif
        measured_[lost_] = kNaN;
      }
      manager_.update(kPeriod);
      reference_.step(measured_);
      REQUIRE(reference_.output.refused == 0);
      for (int i = 0; i < kJoints; ++i) {
        REQUIRE(same_bits(manager_.commands[i], reference_.output.tau[i]));
      }
      REQUIRE(manager_.commands[kJoints] == reference_.output.brakes);
      robot_.move(manager_.commands.data());
    }
    updates_ += count;
  }

  void hold() {
    update(50);
    node().timer->execute();
    REQUIRE(reference_.output.mode == ARM_RUNNING && was_logged("running"));
  }

  /// Joints in another order than the robot's.
  void move_joints() {
    trajectory_msgs::msg::JointTrajectory message;
    message.points.resize(1);
    message.points[0].time_from_start.nanosec = 600000000;
    for (int i = kJoints - 1; i >= 0; --i) {
      reference_.command.goal[i] = robot_.q[i] + arm_number(0.05) * arm_number(i + 1);
      message.joint_names.push_back(arm_velocity_joints[i]);
      message.points[0].positions.push_back(reference_.command.goal[i]);
    }
    auto wrong = message;
    wrong.joint_names[1] = "another";
    node().publish("~/joint_trajectory", wrong);
    REQUIRE(was_logged("is missing"));
    wrong.points.clear();
    node().publish("~/joint_trajectory", wrong);
    REQUIRE(was_logged("not one point"));
    node().publish("~/joint_trajectory", message);
    reference_.command.duration = arm_number(0 + 1e-9 * 600000000);
    reference_.tell(ARM_MOVE_JOINTS);
    update(400);
    for (int i = 0; i < kJoints; ++i) {
      REQUIRE(std::abs(robot_.q[i] - reference_.command.goal[i]) < 2e-3);
    }
  }

#ifdef TASK
  /// Axes of the point along others of the robot: bits of the matrix are exact.
  void move_point() {
    geometry_msgs::msg::PoseStamped message;
    message.header.frame_id = "moon";
    node().publish("~/tool/pose", message);
    REQUIRE(was_logged("`moon`"));
    arm_real position[3], rotation[9];
    arm_forward_kinematics(robot_.q, position, rotation);
    const double turned[9] = {0, 0, 1, 1, 0, 0, 0, 1, 0};
    for (int i = 0; i < 3; ++i) reference_.command.position[i] = position[i];
    for (int i = 0; i < 9; ++i) reference_.command.rotation[i] = arm_number(turned[i]);
    message.header.frame_id = "base";
    message.pose.position = {position[0], position[1], position[2]};
    message.pose.orientation = {1, 1, 1, 1};  // of any length
    node().publish("~/tool/pose", message);
    reference_.command.duration = 3;
    reference_.tell(ARM_MOVE_POINT);
    update(200);
    REQUIRE(reference_.state.law == 1);
  }
#endif

  /// Nothing overtakes the stop, and what comes behind it is not lost.
  void stop() {
    using std_srvs::srv::Trigger;
    REQUIRE(node().call<Trigger>("~/emergency_stop") && !node().call<Trigger>("~/comply"));
    reference_.tell(ARM_EMERGENCY_STOP);
    update(100);
    node().timer->execute();
    REQUIRE(was_logged("EMERGENCY_STOP") && reference_.output.mode == ARM_FAULTED);
    REQUIRE(node().call<Trigger>("~/reset"));
    reference_.tell(ARM_RESET);
    update(1);
    REQUIRE(node().call<Trigger>("~/start"));
    reference_.tell(ARM_START);
    update(49);
    REQUIRE(node().call<Trigger>("~/comply"));
    reference_.tell(ARM_COMPLY);
    update(50);
    REQUIRE(reference_.output.mode == ARM_RUNNING);
  }

  void lose_velocity() {
    lost_ = kJoints + 1;
    update(150);
    lost_ = -1;
    node().timer->execute();
    REQUIRE(was_logged("not finite") && reference_.output.mode == ARM_FAULTED);
    REQUIRE(manager_.commands[kJoints] == 1);
  }

  void deactivate() {
    REQUIRE(manager_.plugin->on_deactivate({}) == CallbackReturn::SUCCESS);
    for (int i = 0; i < kJoints; ++i) REQUIRE(manager_.commands[i] == 0);
    REQUIRE(manager_.commands[kJoints] == 1);
  }

  /// Starts anew, without what was left, and says where updates are not those of the period.
  void again() {
    REQUIRE(!node().call<std_srvs::srv::Trigger>("~/comply"));
    REQUIRE(manager_.activate());
    for (int i = 0; i < kJoints; ++i) manager_.states[i] = robot_.q[i];
    for (int k = 0; k < 500; ++k) manager_.update(2 * kPeriod);
    node().timer->execute();
    REQUIRE(was_logged(", and the law counts with 0.002 s"));
  }

 private:
  rclcpp_lifecycle::LifecycleNode& node() {
    return manager_.node();
  }

  Manager manager_;
  Reference reference_;
  Robot robot_;
  double measured_[2 * kJoints] = {};
  int lost_ = -1, updates_ = 0;
};

void drive() {
  Drive drive;
  drive.hold();
  drive.move_joints();
#ifdef TASK
  drive.move_point();
#endif
  drive.stop();
  drive.lose_velocity();
  drive.deactivate();
  drive.again();
}

#endif

}  // namespace

int main() {
  check_names();
  drive();
  return 0;
}
