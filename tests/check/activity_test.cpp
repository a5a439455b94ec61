#include <cmath>

#include "data/list_data.hpp"
#include "fixture.hpp"
#include "interpreter/loop_instances.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/entries.hpp"
#include "oracle/graph_run.hpp"

// Constraints and tasks that come and go, from the scene to the compiled code. Would catch: shares
// of others than the scene names, variants (batches, float, C, loops, exact tasks) that do not know
// them, a set whose values are not those of the code of this set, and torques that step while a
// robot changes its feet.

namespace treeline::tests {
namespace {

constexpr std::array kFeet{"LF", "RF", "LH", "RH"};

/// A quadruped on those of its feet that are true, by name under `active` if `named`, with `tasks`.
Subjects quadruped_on(const std::array<bool, 4>& feet, bool named, const std::string& more = "",
                      const std::string& rows = "[x, y, z, rx, ry, rz]",
                      const std::string& tasks = "") {
  std::string constraints, active;
  for (std::size_t i = 0; i < kFeet.size(); ++i) {
    if (!feet[i]) continue;
    const std::string foot = kFeet[i];
    constraints +=
        "  - {name: " + foot + ", between: [" + foot + "_FOOT, world], contact: point}\n";
    active += active.empty() ? foot : ", " + foot;
  }
  return in_scene(data_file("published/anymal_c.urdf"),
                  "base: floating\noperational_points: [{name: trunk, link: base, rows: " + rows +
                      "}]\nconstraints:\n" + constraints +
                      (named ? "inputs: {active: [" + active + tasks + "]}\n" : "") +
                      "functions: [constrained_forward_dynamics, supported_control_torque]\n" +
                      more);
}

void expect_right(const Subjects& subjects, int states = 24) {
  const auto report = check_or_throw(subjects, quick_options(states));
  EXPECT_TRUE(report.passed()) << print_text(report);
}

TEST(ActivityCheck, QuadrupedInAnySet) {
  expect_right(quadruped_on({true, true, true, true}, true));
}

TEST(ActivityCheck, InCWithoutLanes) {
  expect_right(quadruped_on({true, false, false, true}, true, "language: c\nlanes: 1\n"));
}

TEST(ActivityCheck, HandAtAWallInBatchesOfFloat) {
  expect_right(in_scene(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf",
                        "operational_points: [{name: tool, link: tool, rows: [x, y]}]\n"
                        "constraints: [{name: wall, between: [wrist_1, world], rows: [z]}]\n"
                        "inputs: {active: wall}\nreal: float\nbatch: 8\nsingular: exact\n"
                        "functions: [constrained_forward_dynamics, supported_control_torque]\n"));
}

// A loop that opens, with gravity as another argument beside.
TEST(ActivityCheck, LoopThatOpens) {
  expect_right(in_scene(data_file("written/four_bar.urdf"),
                        "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: "
                        "[0, 0, 0.25]}, other_origin: {xyz: [0.3, 0, 0]}, rows: [x, z]}]\n"
                        "passive: [coupler_joint]\ninputs: {active: closing, gravity: true}\n"
                        "functions: [constrained_forward_dynamics, supported_control_torque]\n"));
}

/// The arm of robots/ur10e with its hand's tasks under `active`.
void expect_right_arm(const std::string& points, const std::string& more) {
  expect_right(in_scene(std::string(TREELINE_ROBOTS_DIR) + "/ur10e/ur10e.urdf",
                        "operational_points: [" + points + "]\ninputs: {active: [hand, " + more));
}

// One point with as many rows as joints, with a payload as another argument beside.
TEST(ActivityCheck, TaskOfAnArmInC) {
  expect_right_arm("{name: hand, link: tool}",
                   "], payload: tool}\nlanguage: c\nfunctions: [control_torque]\n");
}

// Two tasks in the order of priority, and two beside each other, in float.
TEST(ActivityCheck, TasksByPriorityInBatches) {
  expect_right_arm(
      "{name: look, link: tool, rows: [rx, ry, rz], priority: 2}, "
      "{name: hand, link: tool, rows: [x, y, z]}",
      "look]}\nbatch: 8\nfunctions: [control_torque]\n");
}
TEST(ActivityCheck, TasksBesideEachOtherInFloat) {
  expect_right_arm(
      "{name: elbow, link: forearm, rows: [z]}, {name: hand, link: tool, rows: [x, y]}",
      "elbow]}\nreal: float\nfunctions: [control_torque]\n");
}

// Feet and tasks together.
TEST(ActivityCheck, TasksOfAQuadruped) {
  expect_right(quadruped_on({true, false, false, true}, true, "", "[z, rx, ry]", ", trunk"));
}

const Program& program_of(const Subjects& subjects, Function function) {
  for (const GeneratedFunction& each : subjects.generation.functions) {
    if (each.function == function) return each.program;
  }
  throw std::logic_error("not generated");
}

// All feet held, by code in which each may be let go: the same bits as without, for less than a
// hundredth more operations.
TEST(ActivityCheck, WholeSetHasTheBitsOfItsOwnCode) {
  const Subjects all = quadruped_on({true, true, true, true}, true);
  const Subjects own = quadruped_on({true, true, true, true}, false);
  const StateSpace space =
      make_state_space(all.robot, all.scene, all.generation.mechanism, all.generation.functions, 5);
  const Program& shared = program_of(all, Function::constrained_forward_dynamics);
  const Program& whole = program_of(own, Function::constrained_forward_dynamics);
  for (int index = 0; index < kStatesOfEveryClass; ++index) {
    State state = draw_state(space, index);
    state.others[Quantity::active].assign(4, 1);
    EXPECT_EQ(GraphRun(shared).results(state, Real::float64),
              GraphRun(whole).results(state, Real::float64))
        << "state " << index;
  }
  EXPECT_LT(count_operations(shared).flops(), 1.01 * count_operations(whole).flops());
}

/// A quadruped that trots in place: pairs of feet in turn are let go, lifted, put down and held
/// again, by the code of one scene. The ground holds a foot to the same share as the law.
class TrotInPlace {
 public:
  /// `ramp`: s in which a share changes between 0 and 1; `cycle`: s.
  TrotInPlace(const Subjects& subjects, double ramp, double cycle)
      : motion_(program_of(subjects, Function::constrained_forward_dynamics)),
        law_(program_of(subjects, Function::supported_control_torque)),
        ramp_(ramp),
        cycle_(cycle) {
    subject_ = make_subject<double>(subjects.robot, subjects.scene);
    state_.q.assign(19, 0);
    state_.q[6] = 1;
    for (std::size_t leg = 0; leg < 4; ++leg) {
      state_.q[7 + 3 * leg + 1] = sign(leg) * kHip;
      state_.q[7 + 3 * leg + 2] = -2 * sign(leg) * kHip;
    }
    start_ = state_.q;
    state_.qd.assign(18, 0);
    state_.xdd_cmd.assign(4, 0);
    state_.others[Quantity::stabilisation] = {40, 0};
    state_.others[Quantity::drift].assign(12, 0);
    state_.others[Quantity::f_wanted].assign(12, 0);
  }

  void run(double duration) {
    for (double time = 0; time < duration; time += cycle_) move(time);
  }

  double step = 0;               ///< largest change of a torque in a cycle, N m
  double away = 0, tilt = 0;     ///< of the trunk, m and rad
  std::array<double, 4> lift{};  ///< of the feet, m

 private:
  static constexpr double kHip = 0.4, kPeriod = 0.8, kSwing = 0.2;

  /// Fore knees bend one way, hind knees the other.
  static double sign(std::size_t leg) { return leg < 2 ? 1 : -1; }

  /// Time since the pair of this leg was let go, s; negative before.
  static double since_let_go(std::size_t leg, double time) {
    const bool first = leg == 1 || leg == 2;
    return std::fmod(time, kPeriod) - (first ? 0.1 : 0.5);
  }

  [[nodiscard]] double share(std::size_t leg, double time) const {
    const double since = since_let_go(leg, time);
    const double beyond = since < kSwing / 2 ? -since : since - kSwing;
    if (ramp_ == 0) return beyond >= 0 ? 1 : 0;
    const double u = std::clamp(beyond / ramp_, 0.0, 1.0);
    return u * u * (3 - 2 * u);
  }

  /// The bend of a leg that swings, from 0 to 1 and back, and its two derivatives.
  static std::array<double, 3> bend(std::size_t leg, double time) {
    const double u = since_let_go(leg, time) / kSwing, left = 1 - u;
    if (u <= 0 || u >= 1) return {};
    return {64 * std::pow(u * left, 3), 192 * std::pow(u * left, 2) * (left - u) / kSwing,
            384 * u * left * ((left - u) * (left - u) - u * left) / (kSwing * kSwing)};
  }

  void ask(double time) {
    constexpr double kStiff = 900, kDamp = 60, kMore = 0.2;
    const auto& q = state_.q;
    const auto& qd = state_.qd;
    state_.qdd.assign(18, 0);
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const auto [at, rate, acceleration] = bend(leg, time);
      for (std::size_t joint = 0; joint < 3; ++joint) {
        const std::size_t i = 3 * leg + joint;
        const double by = joint == 0 ? 0 : sign(leg) * kMore * (joint == 1 ? 1 : -2);
        state_.qdd[6 + i] = by * acceleration + kDamp * (by * rate - qd[6 + i]) +
                            kStiff * (start_[7 + i] + by * at - q[7 + i]);
      }
    }
    const Eigen::Quaterniond turn(q[6], q[3], q[4], q[5]);
    const Eigen::Vector3d v = turn * Eigen::Vector3d(qd[0], qd[1], qd[2]);
    const Eigen::Vector3d w = turn * Eigen::Vector3d(qd[3], qd[4], qd[5]);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const double back = -100 * (q[i] - start_[i]) - 20 * v(k);
      i < 2 ? state_.qdd[i] = back : state_.xdd_cmd[0] = back;
      state_.xdd_cmd[1 + i] = -200 * 2 * q[3 + i] - 28 * w(k);
    }
  }

  void move(double time) {
    std::vector<double>& active = state_.others[Quantity::active];
    active.clear();
    for (std::size_t leg = 0; leg < 4; ++leg) active.push_back(share(leg, time));
    ask(time);
    auto tau = law_.results(state_, Real::float64);
    tau.resize(18);
    for (std::size_t i = 0; i < tau.size() && !state_.tau.empty(); ++i) {
      step = std::max(step, std::abs(tau[i] - state_.tau[i]));
    }
    state_.tau = tau;
    const auto qdd = motion_.results(state_, Real::float64);
    for (std::size_t i = 0; i < 18; ++i) state_.qd[i] += cycle_ * qdd[i];
    state_.q = entries_of(interpreter::move_coordinates<double>(
        subject_.model, vector_of<double>(state_.q), vector_of<double>(state_.qd), cycle_));
    look();
  }

  void look() {
    const auto& q = state_.q;
    away = std::max(away, std::hypot(q[0], q[1], q[2]));
    tilt = std::max(tilt, 2 * std::hypot(q[3], q[4], q[5]));
    const auto feet = interpreter::forward_kinematics<double>(subject_.model, subject_.constraints,
                                                              vector_of<double>(q));
    for (std::size_t leg = 0; leg < 4; ++leg) {
      if (heights_.size() < 4) heights_.push_back(feet[leg].position(2));
      lift[leg] = std::max(lift[leg], feet[leg].position(2) - heights_[leg]);
    }
  }

  GraphRun motion_, law_;
  double ramp_, cycle_;
  Subject<double> subject_;
  State state_;
  std::vector<double> start_, heights_;
};

// Half the time between two cycles halves what torques change by in one: nothing steps. Where feet
// are let go and held at once, something does.
TEST(ActivityCheck, QuadrupedTrotsFromOneScene) {
  const Subjects subjects = quadruped_on({true, true, true, true}, true, "", "[z, rx, ry, rz]");
  const auto trot = [&](double ramp, double cycle) {
    TrotInPlace run(subjects, ramp, cycle);
    run.run(1.6);
    return run;
  };
  const TrotInPlace smooth = trot(0.05, 1e-3), finer = trot(0.05, 5e-4);
  const TrotInPlace abrupt = trot(0, 1e-3), abrupt_finer = trot(0, 5e-4);
  EXPECT_LT(finer.step, 0.6 * smooth.step);
  EXPECT_GT(abrupt_finer.step, 0.9 * abrupt.step);
  EXPECT_LT(smooth.step, abrupt.step / 5);
  EXPECT_LT(smooth.away, 0.01);
  EXPECT_LT(smooth.tilt, 0.01);
  for (const double lift : smooth.lift) EXPECT_GT(lift, 0.05);
}

}  // namespace
}  // namespace treeline::tests
