#include "circles.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "samm_joints.hpp"
#include "servo/clock.hpp"
#include "servo/loop.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::experiments {
namespace {

using State = servo::StateOf<Samm>;
constexpr int kGearedSubsteps = 8;

std::vector<std::string> column_names() {
  std::vector<std::string> names{"time"};
  for (const char* what : {"tool", "base"}) {
    for (const char* kind : {"wanted", "seen", "true"}) {
      for (const char* axis : {"x", "y", std::string_view(what) == "tool" ? "z" : "yaw"}) {
        names.push_back(std::string(what) + "_" + axis + "_" + kind);
      }
    }
  }
  for (const char* error :
       {"tool_error_seen", "tool_error", "rotation_error", "base_error_seen", "base_error"}) {
    names.emplace_back(error);
  }
  names.emplace_back("control_us");
  for (const char* quantity : {"q", "qd", "tau"}) {
    for (const char* joint : samm::kCoordinateJoints) {
      names.push_back(std::string(quantity) + "_" + joint);
    }
  }
  return names;
}

/// Appends the cycle to the table and updates the figures.
void record(const servo::Report<Samm>& report, const CircleController& controller,
            const State& links, CircleRun& run) {
  const CircleController::Tracking& tracking = controller.tracking();
  const CircleMotion& wanted = tracking.wanted;
  const double* goal = tracking.tool_wanted;
  double tool[3];
  double rotation[9];
  samm::forward_kinematics(links.q, tool, rotation);
  std::vector<double> row{report.time};
  const auto add = [&row](const double* values, int count) {
    row.insert(row.end(), values, values + count);
  };
  add(goal, 3);
  add(tracking.tool, 3);
  add(tool, 3);
  add(wanted.base, 3);
  add(report.state.q, 3);
  add(links.q, 3);
  const double* e = tracking.error;
  const double errors[5] = {std::hypot(e[0], e[1], e[2]),
                            std::hypot(goal[0] - tool[0], goal[1] - tool[1], goal[2] - tool[2]),
                            std::hypot(e[3], e[4], e[5]),
                            std::hypot(tracking.base_error[0], tracking.base_error[1]),
                            std::hypot(wanted.base[0] - links.q[0], wanted.base[1] - links.q[1])};
  add(errors, 5);
  row.push_back(1e-3 * static_cast<double>(report.control_nanoseconds));
  add(report.state.q, 9);
  add(report.state.qd, 9);
  add(report.tau, 9);
  run.table.append(row.data());
  CircleErrors& most = run.errors;
  most.tool_seen = std::max(most.tool_seen, errors[0]);
  most.tool = std::max(most.tool, errors[1]);
  most.tool_rms += errors[1] * errors[1];
  most.rotation = std::max(most.rotation, errors[2]);
  most.base_seen = std::max(most.base_seen, errors[3]);
  most.base = std::max(most.base, errors[4]);
  most.base_travel = std::max(most.base_travel, std::hypot(links.q[0], links.q[1]));
}

/// Runs the loop over the whole plan. `links` returns the state of the robot's links.
template <class Robot, class Links>
void drive(Robot& robot, const Links& links, const CircleGains& gains, CircleRun& run) {
  using Clock = servo::SimulatedClock;
  CircleController controller(run.plan, gains);
  Clock clock;
  servo::Mailbox mailbox;
  servo::LoopSettings settings;
  settings.rate = run.plan.rate;
  auto loop = std::make_unique<servo::ServoLoop<Samm, Robot, CircleController, Clock>>(
      settings, samm_limits(), robot, controller, clock, mailbox);
  mailbox.push(servo::message_of(servo::MessageKind::start));
  bool leaving = false;
  loop->run([&](const servo::Report<Samm>& report) {
    if (report.mode == servo::Mode::running) {
      record(report, controller, links(), run);
    }
    if (!leaving && (report.time >= run.plan.total() || report.mode == servo::Mode::faulted)) {
      leaving = mailbox.push(servo::message_of(servo::MessageKind::disconnect));
    }
  });
  run.fault = loop->fault();
  run.control = loop->control_times();
}

}  // namespace

const char* name_of(DriveModel model) {
  switch (model) {
    case DriveModel::ideal:
      return "ideal";
    case DriveModel::friction:
      return "friction";
    case DriveModel::backlash:
      return "backlash";
    case DriveModel::worn:
      return "worn";
  }
  return "";
}

const char* describe(DriveModel model) {
  switch (model) {
    case DriveModel::ideal:
      return "ideal drives";
    case DriveModel::friction:
      return "drives with friction";
    case DriveModel::backlash:
      return "gears with backlash";
    case DriveModel::worn:
      return "friction and backlash";
  }
  return "";
}

servo::Drives<9> samm_drives(DriveModel model) {
  // README.md gives the source of each figure.
  constexpr double kRotors[9] = {30, 30, 2, 1.14, 4.71, 0.827, 0.2, 0.179, 0.193};
  constexpr double kCoulomb[9] = {40, 40, 6, 26.0, 10.6, 6.36, 1.07, 0.854, 0.555};
  constexpr double kViscous[9] = {60, 60, 6, 5.80, 9.50, 3.98, 0.412, 0.427, 0.216};
  constexpr double kPlay[9] = {1e-3, 1e-3, 2e-3, 5e-4, 5e-4, 5e-4, 1e-3, 1e-3, 1e-3};
  constexpr double kStiffness[9] = {2e6, 2e6, 1e5, 5e4, 5e4, 3e4, 3e3, 3e3, 5e2};
  constexpr double kDamping[9] = {2e4, 2e4, 5e2, 1e2, 1e2, 4e1, 1, 1, 0.1};
  constexpr double kSlipSpeed = 0.005;
  const bool rubs = model == DriveModel::friction || model == DriveModel::worn;
  const bool plays = model == DriveModel::backlash || model == DriveModel::worn;
  servo::Drives<9> drives;
  for (std::size_t i = 0; i < 9; ++i) {
    drives[i].rotor = kRotors[i];
    drives[i].friction = {rubs ? kCoulomb[i] : 0.0, rubs ? kViscous[i] : 0.0, kSlipSpeed};
    drives[i].gear = {plays ? kPlay[i] : 0.0, kStiffness[i], kDamping[i]};
  }
  return drives;
}

servo::SafetyLimits<9, 9> samm_limits() {
  constexpr double kNone = 1e9;
  servo::SafetyLimits<9, 9> limits;
  limits.lower = {-10, -10, -kNone, -2.79, -3.93, -0.79, -1.92, -1.75, -4.64};
  limits.upper = {10, 10, kNone, 2.79, 0.79, 3.93, 2.97, 1.75, 4.64};
  limits.velocity = {1.5, 1.5, 2.5, 8, 10, 10, 10, 10, 10};
  limits.torque = {1000, 1000, 300, 97.6, 186.4, 89.4, 24.2, 20.1, 21.3};
  return limits;
}

CircleRun run_circles(DriveModel model, bool moving) {
  CirclePlan plan;
  plan.base_radius = moving ? plan.base_radius : 0.0;
  CircleRun run{
      plan,
      model,
      report::Table(column_names(), static_cast<std::size_t>(plan.total() * plan.rate) + 2),
      {},
      {},
      {}};
  State initial;
  std::copy(std::begin(plan.start), std::end(plan.start), std::begin(initial.q));
  CircleGains gains;
  if (model == DriveModel::ideal) {
    servo::SimulatedRobot<Samm> robot(initial);
    const auto links = [&robot] {
      State state;
      robot.read(state);
      return state;
    };
    drive(robot, links, gains, run);
  } else {
    const servo::Drives<9> drives = samm_drives(model);
    // The motors hold the arm's weight from the start, with touching teeth.
    double weight[9];
    samm::gravity(initial.q, weight);
    std::array<double, 9> leads{};
    for (std::size_t i = 0; i < 9; ++i) {
      gains.rotors[i] = drives[i].rotor;
      const double side = weight[i] > 0.0 ? 0.5 : weight[i] < 0.0 ? -0.5 : 0.0;
      leads[i] = weight[i] / drives[i].gear.stiffness + side * drives[i].gear.play;
    }
    servo::GearedRobot<Samm> robot(initial, drives, kGearedSubsteps, leads);
    drive(
        robot, [&robot] { return robot.links(); }, gains, run);
  }
  run.errors.tool_rms = std::sqrt(run.errors.tool_rms / static_cast<double>(run.table.rows()));
  return run;
}

std::vector<CircleRun> run_all_circles() {
  std::vector<CircleRun> runs;
  for (const DriveModel model : kDriveModels) {
    runs.push_back(run_circles(model, false));
    runs.push_back(run_circles(model, true));
  }
  return runs;
}

}  // namespace treeline::experiments
