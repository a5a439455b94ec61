#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ball_controller.hpp"
#include "command_line/limit_figures.hpp"
#include "hand_with_ball.hpp"
#include "servo/run_for.hpp"
#include "turn_ball.hpp"

namespace treeline::experiments {

/// The experiment around the loop, for a hand.
template <class Hand>
class BallTurning {
 public:
  using Plant = HandWithBall<Hand>;
  using State = typename Plant::State;
  using Limits = servo::SafetyLimits<Plant::nq, Plant::nv>;

  explicit BallTurning(const BallPlan& plan)
      : plan_(plan), plant_(start_state(), kSubsteps, kMaterial), controller_(plan) {}

  BallRun run() {
    BallRun result{
        Hand::kName,
        plan_,
        Plant::kFingers,
        kMaterial.friction,
        report::Table(column_names(),
                      static_cast<std::size_t>(plan_.duration() * 1e3) / kRecordEvery + 2),
        {},
        {},
        {}};
    servo::SimulatedClock clock;
    servo::Mailbox mailbox;
    const auto watch = [this, &result](const servo::Report<Hand>& report) {
      look_at(report, result.figures);
      if (cycles_++ % kRecordEvery == 0) record(report, result.table);
    };
    const servo::RunEnd end =
        servo::run_for<Hand>(plan_.duration(), servo::LoopSettings{}, limits_of_hand(), plant_,
                             controller_, clock, mailbox, watch);
    result.figures.slipped = plant_.slipped();
    result.fault = end.fault;
    result.fault_text = describe_fault(end.fault, Hand::kCoordinateJoints, Hand::kVelocityJoints);
    return result;
  }

 private:
  static constexpr int kSubsteps = 8;
  static constexpr int kRecordEvery = 10;  ///< cycles
  static constexpr servo::BallMaterial kMaterial{};

  static State start_state() {
    State state{};
    std::copy(std::begin(Hand::kStart), std::end(Hand::kStart), state.q);
    state.q[Plant::nq - 1] = 1.0;
    return state;
  }

  /// The ball has no motor: any torque at it is a fault.
  static Limits limits_of_hand() {
    Limits limits = servo::limits_of(Hand::kLowerLimits, Hand::kUpperLimits, Hand::kVelocityLimits,
                                     Hand::kEffortLimits);
    std::fill(limits.torque.end() - 6, limits.torque.end(), 0.0);
    return limits;
  }

  static std::vector<std::string> column_names() {
    std::vector<std::string> names = {
        "time",         "wanted_x",  "wanted_y", "wanted_z", "wanted_rx",
        "wanted_ry",    "wanted_rz", "x",        "y",        "z",
        "rx",           "ry",        "rz",       "torque",   "friction_chosen",
        "friction_felt"};
    for (int i = 0; i < Plant::kFingers; ++i) names.push_back(fmt::format("pressure{}", i));
    return report::with_coordinates(std::move(names), Plant::nq);
  }

  static double share_of(const typename Plant::Touches& touches, double& least) {
    double most = 0.0;
    for (const servo::BallTouch& touch : touches) {
      double square = 0.0;
      for (const double force : touch.force) square += force * force;
      const double across = std::sqrt(std::max(0.0, square - touch.pressure * touch.pressure));
      most = std::max(most, touch.pressure > 0.0 ? across / touch.pressure : 1e9);
      least = std::min(least, touch.pressure);
    }
    return most;
  }

  void look_at(const servo::Report<Hand>& report, BallFigures& figures) {
    const Grip& grip = controller_.grip();
    touches_ = plant_.touches();
    felt_ = share_of(touches_, figures.least_felt);
    torque_ = 0.0;
    for (int i = 0; i < Plant::nv; ++i) {
      const double torque = std::fabs(report.tau[i]);
      if (i >= Plant::nv - 6) {
        figures.ball_torque = std::max(figures.ball_torque, torque);
        continue;
      }
      torque_ = std::max(torque_, torque / Hand::kEffortLimits[i]);
      const double speed = std::fabs(report.state.qd[i]) / Hand::kVelocityLimits[i];
      figures.speed = std::max(figures.speed, speed);
    }
    figures.torque = std::max(figures.torque, torque_);
    figures.least_pressure = std::min(figures.least_pressure, grip.least_pressure);
    figures.friction = std::max(figures.friction, grip.friction);
    figures.friction_felt = std::max(figures.friction_felt, felt_);
    figures.away = std::max(figures.away, grip.away);
    figures.turned_away = std::max(figures.turned_away, grip.turned_away);
    figures.end_away = grip.away;
    figures.end_turned_away = grip.turned_away;
    measure_rolling(report.state, figures);
  }

  /// How far contacts have moved on the ball's surface, along chords.
  void measure_rolling(const State& state, BallFigures& figures) {
    const double* const q = state.q + Plant::nq - 4;
    const double quaternion[4] = {q[0], q[1], q[2], q[3]};
    double R[9];
    core::rotation_from_quaternion(quaternion, R);
    for (std::size_t i = 0; i < touches_.size(); ++i) {
      std::array<double, 3> normal{};
      double square = 0.0;
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) normal[row] += R[3 * k + row] * touches_[i].normal[k];
        const double moved = normal[row] - first_[i][row];
        square += moved * moved;
      }
      if (cycles_ == 0) {
        first_[i] = normal;
      } else {
        figures.rolled = std::max(figures.rolled, Hand::kBallRadius * std::sqrt(square));
      }
    }
  }

  void record(const servo::Report<Hand>& report, report::Table& table) {
    const auto wanted = ball_at(plan_, report.time);
    const double* const ball = report.state.q + Plant::nq - 7;
    const double quaternion[4] = {ball[3], ball[4], ball[5], ball[6]};
    double turn[3];
    core::rotation_vector_from_quaternion(quaternion, turn);
    std::vector<double> row = {report.time};
    row.insert(row.end(), std::begin(wanted.position), std::end(wanted.position));
    for (int i = 0; i < 3; ++i) row.push_back(ball[i] - Hand::kStart[Plant::nq - 7 + i]);
    row.insert(row.end(), std::begin(turn), std::end(turn));
    row.insert(row.end(), {torque_, controller_.grip().friction, felt_});
    for (const servo::BallTouch& touch : touches_) row.push_back(touch.pressure);
    row.insert(row.end(), std::begin(report.state.q), std::end(report.state.q));
    table.append(row.data());
  }

  BallPlan plan_;
  Plant plant_;
  BallController<Hand> controller_;
  typename Plant::Touches touches_{};
  std::array<std::array<double, 3>, Plant::kFingers> first_{};
  double torque_ = 0.0, felt_ = 0.0;
  long cycles_ = 0;
};

}  // namespace treeline::experiments
